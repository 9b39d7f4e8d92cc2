package argo.boards

import argo.connecting.OpenPort
import javino.PerceptKind

/**
 * The kinds of percepts that the board on [port] describes. The board is asked for them once in each session, between two requests, but
 * only after somebody has called [get]: the board of an agent that nobody watches is not asked.
 */
internal class DescribedPercepts(private val port: OpenPort) {
    @Volatile
    private var isWanted = false

    @Volatile
    private var isAsked = false

    @Volatile
    private var kinds = emptyList<PerceptKind>()

    /** Returns the kinds; none: they are not known yet, or the board describes none. Any thread. */
    fun get(): List<PerceptKind> {
        isWanted = true
        return kinds
    }

    /** Notes that a session has begun, with the same board or another one. Any thread. */
    fun renew() {
        isAsked = false
    }

    /** Asks the board if that is wanted and was not done in this session. Called by the sensing thread. */
    fun askIfWanted() {
        if (!isWanted || isAsked || !port.link.isPaced) return
        isAsked = true
        kinds = port.link.perceptKinds(port.options.timeoutMs)
    }
}
