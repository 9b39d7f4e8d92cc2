package argo.recording.why

import argo.recording.PerceivedSnapshot

/** Counts the messages of boards that an agent perceives, from 1. One is perceived again when its filter lets more of it through. */
internal class Frames(private val secondsOf: (Long) -> Double) {
    private val newest = HashMap<String, Pair<Long, Int>>()
    private var count = 0

    /** What is next: [snapshot], perceived in the cycle that has Jason's number [cycle]. */
    fun of(snapshot: PerceivedSnapshot, cycle: Int): Frame {
        val known = newest[snapshot.port]?.takeIf { (receivedNs, _) -> receivedNs == snapshot.receivedNs }
        val number = known?.second ?: ++count
        newest[snapshot.port] = snapshot.receivedNs to number
        return Frame(
            number, snapshot.port, snapshot.namespace, secondsOf(snapshot.receivedNs), cycle, snapshot.texts, snapshot.kept,
        )
    }
}
