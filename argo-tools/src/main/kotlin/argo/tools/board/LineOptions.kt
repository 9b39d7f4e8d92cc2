package argo.tools.board

import javino.Link
import javino.LinkSettings
import javino.Protocol
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Spec

/** How a board is spoken to: the options that `argo.port` has too. */
internal class LineOptions {
    @Spec(Spec.Target.MIXEE)
    private lateinit var spec: CommandSpec

    @Option(names = ["--baud"], paramLabel = "RATE", defaultValue = "9600", description = ["the line's rate, bits a second (\${DEFAULT-VALUE})"])
    private var baud = 0

    @Option(names = ["--protocol"], paramLabel = "VERSION", defaultValue = "auto", description = ["1, 2 or auto: 2 if the board answers in it, else 1 (\${DEFAULT-VALUE})"])
    private lateinit var protocol: String

    @Option(names = ["--timeout"], paramLabel = "MS", defaultValue = "500", description = ["how long an answer may take, milliseconds (\${DEFAULT-VALUE})"])
    private var timeout = 0

    @Option(
        names = ["--boot"], paramLabel = "MS", defaultValue = "3000",
        description = ["how long the board may take to start, since opening its port resets it, milliseconds (\${DEFAULT-VALUE})"],
    )
    private var boot = 0

    /** Milliseconds that an answer may take. */
    val timeoutMs: Int get() = timeout.also { requireRange("--timeout", it, 1..MOST_MS) }

    val settings: LinkSettings
        get() {
            requireRange("--baud", baud, 1..MOST_BAUD)
            requireRange("--boot", boot, 0..MOST_MS)
            val version = PROTOCOLS[protocol] ?: throw misuse("--protocol is 1, 2 or auto, not $protocol")
            return LinkSettings.defaults().withBaud(baud).withBootMillis(boot).withProtocol(version)
        }

    /** Opens [port]; wrong options come first. */
    fun open(port: String): Link {
        val settings = settings
        timeoutMs
        return Link.open(port, settings, spec.qualifiedName())
    }

    private fun requireRange(option: String, value: Int, range: IntRange) {
        if (value !in range) throw misuse("$option is from ${range.first} to ${range.last}, not $value")
    }

    private fun misuse(reason: String) = ParameterException(spec.commandLine(), reason)

    private companion object {
        val PROTOCOLS = mapOf("1" to Protocol.V1, "2" to Protocol.V2, "auto" to Protocol.AUTO)
        const val MOST_BAUD = 20_000_000
        const val MOST_MS = 600_000
    }
}

/** The version that a link speaks, in words. */
internal fun versionSpoken(protocol: Protocol): String = when (protocol) {
    Protocol.AUTO -> "an unknown version"
    Protocol.V1 -> "version 1"
    Protocol.V2 -> "version 2"
}
