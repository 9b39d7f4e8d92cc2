package argo.connecting

import argo.calls.ArgumentException
import argo.calls.whole
import argo.calls.withOptions
import jason.asSyntax.Literal
import jason.asSyntax.Term
import javino.Protocol
import javino.Transports
import javino.link.LinkSettings

/**
 * The options of a port: the second argument of `argo.port`.
 *
 * @property link the settings of the link
 * @property timeoutMs the time limit for an answer, in ms
 * @property listens whether the board sends percepts without requests; if true, ARGO sends no requests
 * @property hasBaud whether a baud rate is given; if false, [on] sets the usual rate of the port's kind
 * @property namespace the namespace of the board's percepts; null for the default namespace
 * @property staleMs the ms without a message after which `stale(Port)` is believed; 0 for never, null for the default
 */
internal data class PortOptions(
    val link: LinkSettings = LinkSettings.defaults(),
    val timeoutMs: Int = DEFAULT_TIMEOUT_MS,
    val listens: Boolean = false,
    val hasBaud: Boolean = false,
    val staleMs: Int? = null,
    val namespace: String? = null,
) {
    companion object {
        /** The default time limit for an answer in ms: three times as long as twelve percepts take at 9600 baud. */
        const val DEFAULT_TIMEOUT_MS = 500

        /** Reads a list such as `[baud(115200), timeout(500)]`. Throws [ArgumentException] if [term] is not a list of known options. */
        fun of(term: Term): PortOptions = withOptions(PortOptions(), term, "[baud(115200)]", KNOWN) { with(it) }
    }

    /**
     * Returns the link's settings. If [paced] is false, the link uses version 1, as in the published ARGO. The options may set version 2.
     */
    fun linkSettings(paced: Boolean): LinkSettings {
        val version = if (!paced && link.protocol == Protocol.AUTO) Protocol.V1 else link.protocol
        return link.withPaced(paced).withProtocol(version)
    }

    /** Returns these options for [port]. If no baud rate is given, the result has the usual rate of the port's kind. */
    fun on(port: String): PortOptions =
        if (hasBaud) this else copy(link = link.withBaud(Transports.usualLine(port).baud()), hasBaud = true)

    /** Returns true if [other] opens a port alike. The namespaces may differ. */
    fun openAs(other: PortOptions): Boolean = copy(namespace = other.namespace) == other

    /** The list from which [of] reads these options: the baud rate, if a line has one, and all options that differ from the default. */
    val text: String
        get() = LinkSettings.defaults().let { usual ->
            listOfNotNull(
                "baud(${link.baud()})".takeIf { hasBaud && link.baud() <= MAX_BAUD }, // a network's usual rate is higher
                "timeout($timeoutMs)".takeIf { timeoutMs != DEFAULT_TIMEOUT_MS },
                "stale($staleMs)".takeIf { staleMs != null },
                "boot(${link.bootMillis()})".takeIf { link.bootMillis() != usual.bootMillis() },
                "spacing(${link.spacingMillis()})".takeIf { link.spacingMillis() != usual.spacingMillis() },
                "queue(${link.boardQueue()})".takeIf { link.boardQueue() != usual.boardQueue() },
                "mode(listen)".takeIf { listens },
                "protocol(${wordOf(link.protocol())})".takeIf { link.protocol() != usual.protocol() },
                "as($namespace)".takeIf { namespace != null },
            ).joinToString(",", "[", "]")
        }

    private fun with(option: Term): PortOptions? {
        val name = (option as? Literal)?.takeIf { it.arity == 1 && !it.isVar }?.functor
        return when (name) {
            "baud" -> copy(link = link.withBaud(whole(option, 1..MAX_BAUD)), hasBaud = true)
            "timeout" -> copy(timeoutMs = whole(option, 1..MAX_MS))
            "stale" -> copy(staleMs = whole(option, 0..MAX_MS))
            "boot" -> copy(link = link.withBootMillis(whole(option, 0..MAX_MS)))
            "spacing" -> copy(link = link.withSpacingMillis(whole(option, 0..MAX_MS)))
            "queue" -> copy(link = link.withBoardQueue(whole(option, 1..MAX_QUEUE)))
            "mode" -> copy(listens = oneOf(option, "request", "listen") == "listen")
            "protocol" -> copy(link = link.withProtocol(PROTOCOLS.getValue(oneOf(option, *PROTOCOLS.keys.toTypedArray()))))
            "as" -> copy(namespace = namespaceIn(option))
            else -> null
        }
    }
}

private const val KNOWN = "baud(Rate), timeout(Ms), mode(request) or mode(listen), protocol(1), protocol(2) or protocol(auto), boot(Ms), " +
    "spacing(Ms), queue(Messages), stale(Ms) and as(Namespace)"
private val PROTOCOLS = mapOf("1" to Protocol.V1, "2" to Protocol.V2, "auto" to Protocol.AUTO)
private fun wordOf(protocol: Protocol) = PROTOCOLS.entries.first { it.value == protocol }.key
private const val MAX_BAUD = 20_000_000
private const val MAX_MS = 600_000
private const val MAX_QUEUE = 1000
private const val DEFAULT_NAMESPACE = "default"

private fun namespaceIn(option: Literal): String? {
    val name = (option.getTerm(0) as? Literal)?.takeIf { it.isAtom && !it.isVar && it.ns == Literal.DefaultNS }
        ?: throw ArgumentException("$option: as takes the name of a namespace, an atom such as left")
    return name.functor.takeUnless { it == DEFAULT_NAMESPACE }
}

private fun oneOf(option: Literal, vararg words: String): String = option.getTerm(0).toString().takeIf { it in words }
    ?: throw ArgumentException("$option: ${option.functor} is ${words.joinToString(" or ")}")
