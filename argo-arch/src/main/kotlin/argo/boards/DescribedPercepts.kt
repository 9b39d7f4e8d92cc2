package argo.boards

import argo.connecting.OpenPort
import javino.PerceptKind
import javino.PortException
import javino.PortInterruptedException

/**
 * The kinds of percepts that the board on [port] describes. After the first call of [get], the board is asked once in each session, between
 * two requests. So the board of an agent that nobody watches is not asked. Sensing waits for the answer. So a board without a quick answer
 * is not asked again while the port is open.
 *
 * @param warn takes the reason why a board's kinds are not known, at most once
 */
internal class DescribedPercepts(private val port: OpenPort, private val warn: (String) -> Unit) {
    @Volatile
    private var isWanted = false

    @Volatile
    private var isAsked = false

    @Volatile
    private var kinds = emptyList<PerceptKind>()

    private var isGivenUp = false // used by the sensing thread

    /** Returns the kinds; empty: they are not known yet, or the board describes none. Any thread. */
    fun get(): List<PerceptKind> {
        isWanted = true
        return kinds
    }

    /** Notes that a session has begun, with the same or another board. Any thread. */
    fun renew() {
        isAsked = false
    }

    /** Asks the board, if that is wanted and was not done in this session. Called by the sensing thread. */
    fun askIfWanted() {
        if (!isWanted || isAsked || isGivenUp || !port.link.isPaced) return
        isAsked = true
        try {
            kinds = port.link.perceptKinds(minOf(port.options.timeoutMs, LIMIT_MS))
        } catch (trouble: PortException) {
            if (trouble is PortInterruptedException || !port.link.isOpen) throw trouble
            isGivenUp = true
            kinds = emptyList()
            warn("${trouble.message}; it is not asked again until the port is opened anew, and its percepts have no units and ranges")
        }
    }

    private companion object {
        /** Ms that sensing waits for a description: less than the usual time until a board is believed silent. */
        const val LIMIT_MS = 300
    }
}
