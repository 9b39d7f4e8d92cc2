package argo.tools.board

import argo.tools.command.refuse
import argo.tools.command.requireWithin
import javino.Link
import javino.LinkSettings
import javino.Protocol
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
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
    val timeoutMs: Int get() = timeout.also { spec.requireWithin("--timeout", it, 1..MOST_MS) }

    val settings: LinkSettings
        get() {
            spec.requireWithin("--baud", baud, BAUDS)
            spec.requireWithin("--boot", boot, 0..MOST_MS)
            val version = PROTOCOLS[protocol] ?: spec.refuse("--protocol is 1, 2 or auto, not $protocol")
            return LinkSettings.defaults().withBaud(baud).withBootMillis(boot).withProtocol(version)
        }

    /** Opens [port]; wrong options come first. */
    fun open(port: String): Link {
        val settings = settings
        timeoutMs
        return Link.open(port, settings, spec.qualifiedName())
    }

    companion object {
        /** The rates that a line can be asked to have, bits a second. */
        val BAUDS = 1..20_000_000
        private val PROTOCOLS = mapOf("1" to Protocol.V1, "2" to Protocol.V2, "auto" to Protocol.AUTO)
        private const val MOST_MS = 600_000
    }
}

/** The version that a link speaks, in words. */
internal fun versionSpoken(protocol: Protocol): String = when (protocol) {
    Protocol.AUTO -> "an unknown version"
    Protocol.V1 -> "version 1"
    Protocol.V2 -> "version 2"
}
