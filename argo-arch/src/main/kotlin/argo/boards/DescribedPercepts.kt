package argo.boards

import argo.connecting.OpenPort
import javino.PerceptKind
import javino.PortException
import javino.PortInterruptedException

/**
 * The kinds of percepts that the board on [port] describes. The board is asked only after the first call of [get], since nobody needs the
 * kinds before. The board is asked once in each session, between two requests for percepts. Sensing waits for the answer. If the board does
 * not answer in time, it is not asked again while the port is open.
 *
 * @param warn called at most once, with the reason why the board's kinds are not known
 */
internal class DescribedPercepts(private val port: OpenPort, private val warn: (String) -> Unit) {
    @Volatile
    private var isWanted = false

    @Volatile
    private var isAsked = false

    @Volatile
    private var kinds = emptyList<PerceptKind>()

    private var isGivenUp = false // only for the sensing thread

    /** Returns the kinds. The list is empty if they are not known yet, or if the board describes none. Any thread. */
    fun get(): List<PerceptKind> {
        isWanted = true
        return kinds
    }

    /** Notes that a session has begun. Any thread. */
    fun renew() {
        isAsked = false
    }

    /** Asks the board, if [get] has been called and the board was not asked in this session. Called by the sensing thread. */
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
        /** The time, in ms, that a sensing thread waits for a description. The default time limit for an answer is longer. */
        const val LIMIT_MS = 300
    }
}
