package argo.ports

import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.NumberTerm
import jason.asSyntax.Term
import javino.LinkSettings
import javino.Protocol
import javino.Transports

/**
 * How a port is used: the second argument of `argo.port`.
 *
 * @property link baud rate and manners on the line
 * @property timeoutMs how long an answer may take, in ms
 * @property listens whether the board speaks unasked, so that it is listened to and never asked
 * @property saysBaud whether the rate is settled; else it is what ports of the port's kind usually have, see [on]
 * @property staleMs after how many ms without a message `stale(Port)` is believed, 0: never; null: as [staleAfterMs] says
 */
internal data class PortOptions(
    val link: LinkSettings = LinkSettings.defaults(),
    val timeoutMs: Int = DEFAULT_TIMEOUT_MS,
    val listens: Boolean = false,
    val saysBaud: Boolean = false,
    val staleMs: Int? = null,
) {
    /**
     * After how many ms without a message `stale(Port)` is believed, null: never. Unless it is set: when two answers in turn may have
     * stayed out, but never for a board that speaks when it has something to say.
     *
     * @param intervalMs the sensing interval in ms
     */
    fun staleAfterMs(intervalMs: Int): Long? =
        if (staleMs != null) staleMs.toLong().takeIf { it > 0 } else (intervalMs + 2L * timeoutMs).takeUnless { listens }


    companion object {
        /** How long an answer may take unless `timeout(Ms)` says otherwise: three times what twelve percepts take at 9600 baud. */
        const val DEFAULT_TIMEOUT_MS = 500

        /**
         * Reads a list such as `[baud(115200), timeout(500)]`.
         * @throws ArgumentException if it is not a list of known options
         */
        fun of(term: Term): PortOptions = optionsIn(term, "[baud(115200)]").fold(PortOptions()) { options, option -> options.with(option) }
    }

    /**
     * How the link treats its line. One that is not [paced] is used as was published, with version 1 of the protocol unless version 2
     * was asked for.
     */
    fun linkSettings(paced: Boolean): LinkSettings {
        val version = if (!paced && link.protocol == Protocol.AUTO) Protocol.V1 else link.protocol
        return link.withPaced(paced).withProtocol(version)
    }

    /** These options for [port]: with the rate that ports of its kind usually have, if none was asked for. */
    fun on(port: String): PortOptions = if (saysBaud) this else copy(link = link.withBaud(Transports.usualLine(port).baud()), saysBaud = true)

    private fun with(option: Term): PortOptions {
        val name = (option as? Literal)?.takeIf { it.arity == 1 && !it.isVar }?.functor
        return when (name) {
            "baud" -> copy(link = link.withBaud(whole(option, 1..MOST_BAUD)), saysBaud = true)
            "timeout" -> copy(timeoutMs = whole(option, 1..MOST_MS))
            "stale" -> copy(staleMs = whole(option, 0..MOST_MS))
            "boot" -> copy(link = link.withBootMillis(whole(option, 0..MOST_MS)))
            "spacing" -> copy(link = link.withSpacingMillis(whole(option, 0..MOST_MS)))
            "queue" -> copy(link = link.withBoardQueue(whole(option, 1..MOST_QUEUE)))
            "mode" -> copy(listens = oneOf(option, "request", "listen") == "listen")
            "protocol" -> copy(link = link.withProtocol(PROTOCOLS.getValue(oneOf(option, *PROTOCOLS.keys.toTypedArray()))))
            else -> throw ArgumentException("$option is not an option; there are $KNOWN")
        }
    }
}

private const val KNOWN = "baud(Rate), timeout(Ms), mode(request) or mode(listen), protocol(1), protocol(2) or protocol(auto), boot(Ms), spacing(Ms), queue(Messages) and stale(Ms)"
private val PROTOCOLS = mapOf("1" to Protocol.V1, "2" to Protocol.V2, "auto" to Protocol.AUTO)
private const val MOST_BAUD = 20_000_000
private const val MOST_MS = 600_000
private const val MOST_QUEUE = 1000

/** An argument that an internal action cannot use; [message] says what was found and what is expected. */
internal class ArgumentException(message: String) : Exception(message)

/** The options in [list], which may be a variable without a value or with an open end, since an agent's program may have any; [example] is one as it should be. */
internal fun optionsIn(list: Term, example: String): List<Term> =
    (list as? ListTerm)?.takeIf { it.isList && it.tail == null }?.asList
        ?: throw ArgumentException("the second argument is a list of options such as $example, not $list")

/** The argument of [option], a whole number in [range]. */
internal fun whole(option: Literal, range: IntRange): Int = wholeNumber(option.getTerm(0))?.takeIf { it in range }
    ?: throw ArgumentException("$option: ${option.functor} takes a whole number from ${range.first} to ${range.last}")

private fun oneOf(option: Literal, vararg words: String): String = option.getTerm(0).toString().takeIf { it in words }
    ?: throw ArgumentException("$option: ${option.functor} is ${words.joinToString(" or ")}")

/** [term] as a whole number, or null if it is none. */
internal fun wholeNumber(term: Term): Int? {
    val value = (term as? NumberTerm)?.takeIf { it.isNumeric && it.isGround }?.solve() ?: return null
    return value.toInt().takeIf { it.toDouble() == value }
}
