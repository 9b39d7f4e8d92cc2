package argo.tools.board

import argo.links.BoardLink
import argo.links.BoardLinkProvider
import argo.tools.command.refuse
import argo.tools.command.requireWithin
import javino.LineClock
import javino.Protocol
import javino.Transport
import javino.Transports
import javino.link.Link
import javino.link.LinkSettings
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Spec

/** The options for a board's serial line, like those of `argo.port`. Picocli mixes them into a command. */
class LineOptions {
    @Spec(Spec.Target.MIXEE)
    private lateinit var spec: CommandSpec

    @Option(
        names = ["--baud"], paramLabel = "RATE", defaultValue = "9600",
        description = ["the line's rate, bits a second (\${DEFAULT-VALUE})"],
    )
    private var baud = 0

    @Option(
        names = ["--protocol"], paramLabel = "VERSION", defaultValue = "auto",
        description = ["1, 2 or auto: 2 if the board answers in it, else 1 (\${DEFAULT-VALUE})"],
    )
    private lateinit var protocol: String

    @Option(
        names = ["--timeout"], paramLabel = "MS", defaultValue = "500",
        description = ["how long an answer may take, milliseconds (\${DEFAULT-VALUE})"],
    )
    var timeoutMs = 0
        private set

    @Option(
        names = ["--boot"], paramLabel = "MS", defaultValue = "3000",
        description = ["how long the board may take to start, since opening its port resets it, milliseconds (\${DEFAULT-VALUE})"],
    )
    private var boot = 0

    /** Checks all options, and opens the line at [port] for raw bytes, without Javino. */
    fun openRaw(port: String): Transport = Transports.open(inJavino(port), settings().line())

    /**
     * Checks all options and opens [port].
     *
     * @throws javino.PortException if [port] cannot be opened
     */
    fun open(port: String): Link = Link.open(inJavino(port), settings(), spec.qualifiedName())

    /**
     * Opens [port] if it is no serial line, such as `ros://robot:9090`. Returns null for a serial line. Checks all options first. Refuses
     * options for serial lines.
     *
     * @throws javino.PortException if [port] cannot be opened
     */
    fun openElsewhere(port: String): BoardLink? {
        val provider = BoardLinkProvider.of(port) ?: return null
        settings()
        OF_LINES.find(::isGiven)?.let { spec.refuse("$it is an option of lines, and $port is on none") }
        return provider.open(port, true, LineClock.system())
    }

    /** The time limit of the user in ms, or 0 if there is none. */
    val givenTimeoutMs: Int get() = if (isGiven("--timeout")) timeoutMs else 0

    private fun isGiven(option: String) = spec.commandLine().parseResult.hasMatchedOption(option)

    /** Returns [port] if it is a serial line, and refuses it otherwise. */
    private fun inJavino(port: String): String {
        if (BoardLinkProvider.of(port) == null) return port
        spec.refuse("$port is on no line, and this command speaks only Javino; monitor, send and \"ports --describe\" do more")
    }

    private fun settings(): LinkSettings {
        spec.requireWithin("--timeout", timeoutMs, 1..MAX_MS)
        spec.requireWithin("--baud", baud, BAUDS)
        spec.requireWithin("--boot", boot, 0..MAX_MS)
        val version = PROTOCOLS[protocol] ?: spec.refuse("--protocol is 1, 2 or auto, not $protocol")
        return LinkSettings.defaults().withBaud(baud).withBootMillis(boot).withProtocol(version)
    }

    companion object {
        val BAUDS = 1..20_000_000
        private val OF_LINES = listOf("--baud", "--protocol", "--boot", "--mode")
        private val PROTOCOLS = mapOf("1" to Protocol.V1, "2" to Protocol.V2, "auto" to Protocol.AUTO)
        private const val MAX_MS = 600_000
    }
}

internal fun versionSpoken(protocol: Protocol): String = when (protocol) {
    Protocol.AUTO -> "an unknown version"
    Protocol.V1 -> "version 1"
    Protocol.V2 -> "version 2"
}
