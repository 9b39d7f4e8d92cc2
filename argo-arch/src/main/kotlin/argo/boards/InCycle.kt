package argo.boards

import argo.platform.Platform
import argo.platform.Waker
import argo.sensing.Sensing
import java.util.concurrent.TimeUnit

/**
 * Couples reasoning cycles and lines as the published ARGO does, see [argo.sensing.SensingPolicy.IN_CYCLE]. Once in each interval, the
 * agent's own thread asks the boards one by one, and waits for each answer. Only the agent's thread may call [perceiving].
 */
internal class InCycle(private val platform: Platform, private val waker: Waker) {
    private var lastStart: Long? = null

    /**
     * Asks the boards if the interval is over. [sensings] returns the sensing of each port in use, or nothing while perceiving is blocked.
     */
    fun perceiving(intervalMs: Int, sensings: () -> List<Sensing>) {
        val start = platform.clock.nanos()
        val isEarly = lastStart?.let { start - it < TimeUnit.MILLISECONDS.toNanos(intervalMs.toLong()) } == true
        val toAsk = if (isEarly) emptyList() else sensings()
        if (toAsk.isEmpty()) return
        lastStart = start
        toAsk.forEach(Sensing::exchange)
        waker.wakeIn(intervalMs.toLong()) // otherwise an idle agent would not perceive again
    }
}
