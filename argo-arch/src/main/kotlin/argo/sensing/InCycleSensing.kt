package argo.sensing

import argo.platform.Platform
import argo.platform.Waker
import argo.ports.OpenPort

/** Sensing as it was published: the agent's own thread asks for percepts and waits for them, once an interval. */
internal class InCycleSensing(private val platform: Platform, private val waker: Waker) {
    private var lastStart: Long? = null

    /** Takes a message from the board on [port], unless less than [intervalMs] ms have gone by since the last time. */
    fun sense(port: OpenPort, intervalMs: Int) {
        val start = platform.clock.nanos()
        if (lastStart?.let { start - it < intervalMs * NANOS_PER_MS } == true) return
        lastStart = start
        port.sensing.exchange()
        waker.wakeIn(intervalMs.toLong()) // an agent that has nothing else to do must perceive again
    }

    private companion object {
        const val NANOS_PER_MS = 1_000_000L
    }
}
