package argo.recording.why

import argo.recording.PerceivedSnapshot

/**
 * Numbers the messages of boards that an agent perceives, from 1. A message that the agent perceives again, since the filter lets more of
 * its percepts through, keeps its number.
 */
internal class Frames(private val secondsOf: (Long) -> Double) {
    private val newest = HashMap<String, Pair<Long, Int>>()
    private var count = 0

    /** Returns the frame of [snapshot], the next one, which the agent perceived in the cycle with Jason's number [cycle]. */
    fun of(snapshot: PerceivedSnapshot, cycle: Int): Frame {
        val known = newest[snapshot.port]?.takeIf { (receivedNs, _) -> receivedNs == snapshot.receivedNs }
        val number = known?.second ?: ++count
        newest[snapshot.port] = snapshot.receivedNs to number
        return Frame(
            number, snapshot.port, snapshot.namespace, secondsOf(snapshot.receivedNs), cycle, snapshot.texts, snapshot.kept,
        )
    }
}
