package argo.ros.bridge

import javino.LineClock
import java.util.concurrent.TimeUnit

/**
 * Computes the platform time at which a robot's message was true. Uses the offset of the robot's clock. If the robot's time is simulated,
 * uses `/clock`. Safe for use by several threads.
 *
 * @param clockIsThere called with the type of the topic [CLOCK] if it exists. The caller then passes its messages to [show].
 * @param warn takes a warning if the time stamps of a topic are useless
 * @param tell takes a sentence that names the clock on which the ages of messages depend
 */
internal class RobotTime(
    private val clock: LineClock,
    private val api: RosApi,
    private val clockIsThere: (type: String) -> Unit,
    private val warn: (String) -> Unit,
    private val tell: (String) -> Unit,
) {
    private val offset = ClockOffset()
    private val simulated = SimulatedClock()

    @Volatile
    private var isSimulated = false

    @Volatile
    private var isClockKnown = false

    @Volatile
    private var dueNanos: Long? = null // the time of the next question, or null while an answer is pending
    private var toldNanos: Long? = null // only the bridge's thread uses this field and the next one
    private var answers = 0

    fun ask() {
        dueNanos = null
        if (!isClockKnown) askForClock()
        val askedNanos = clock.nanos()
        api.ask("/rosapi/get_time").whenComplete { answer, _ ->
            val ros = answer?.values?.part("time")?.rosNanos()
            if (ros != null) answered(askedNanos, ros, answer.receivedNanos)
            dueNanos = clock.nanos() + when {
                ros == null -> UNKNOWN_INTERVAL_NANOS
                answers < FIRST_ANSWERS -> FIRST_INTERVAL_NANOS
                else -> INTERVAL_NANOS
            }
        }
    }

    fun renew() {
        if (dueNanos?.let { clock.nanos() - it >= 0 } == true) ask()
    }

    private fun askForClock() {
        api.ask("/rosapi/topic_type", mapOf("topic" to CLOCK)).thenAccept { answer ->
            val type = answer.text("type").orEmpty()
            if (type.isEmpty() || isClockKnown) return@thenAccept
            isClockKnown = true
            clockIsThere(type)
        }
    }

    private fun answered(askedNanos: Long, rosNanos: Long, receivedNanos: Long) {
        offset.add(askedNanos, rosNanos, receivedNanos)
        answers++
        simulated.newest?.let { (simNanos, atNanos) -> compare(rosNanos, receivedNanos, simNanos, atNanos) }
        if (answers >= FIRST_ANSWERS && !isSimulated) report()
    }

    /** Decides whether the robot takes its time from [CLOCK]. A real clock and a simulated clock differ by decades. */
    private fun compare(rosNanos: Long, receivedNanos: Long, simNanos: Long, atNanos: Long) {
        if (isSimulated || Math.abs(receivedNanos - atNanos) > SAME_INSTANT_NANOS || Math.abs(rosNanos - simNanos) > SAME_TIME_NANOS) return
        isSimulated = true
        tell("the robot's time is simulated; ages go by its time stamps and $CLOCK, at the speed of the simulator")
    }

    /** Stores that the topic [CLOCK] showed [simNanos] at the platform time [nowNanos]. */
    fun show(simNanos: Long, nowNanos: Long) {
        val isFirst = simulated.newest == null
        simulated.show(simNanos, nowNanos)
        if (isFirst && dueNanos != null) ask() // the answer shows whether the robot uses the simulator's clock
    }

    /**
     * Returns the platform time at which a message with the robot's time stamp [stampNanos] was true. The result is never later than
     * [nowNanos], the time of arrival. Without a plausible stamp, the result is [nowNanos]. A stamp far ahead, or older than
     * [MAX_AGE_NANOS], is not plausible.
     */
    fun trueAt(topic: String, stampNanos: Long?, nowNanos: Long): Long {
        if (stampNanos == null) return nowNanos
        val shown = (if (isSimulated) simulated.whenShown(stampNanos, nowNanos) else offset.whenShown(stampNanos)) ?: return nowNanos
        val age = nowNanos - shown
        if (age !in -AHEAD_NANOS..MAX_AGE_NANOS) {
            val side = if (age < 0) "ahead of the robot's clock" else "older than ten minutes by the robot's clock"
            warn("the time stamps of $topic are $side, so that its ages count from the arrival")
            return nowNanos
        }
        return nowNanos - maxOf(0, age)
    }

    private fun report() {
        val now = offset.offsetNanos ?: return
        if (toldNanos?.let { Math.abs(it - now) < CHANGE_NANOS } == true) return
        toldNanos = now
        val wall = TimeUnit.MILLISECONDS.toNanos(System.currentTimeMillis()) - clock.nanos()
        val aheadMs = TimeUnit.NANOSECONDS.toMillis(now - wall)
        val side = if (aheadMs < 0) "behind" else "ahead of"
        val errorMs = maxOf(1, TimeUnit.NANOSECONDS.toMillis(offset.errorNanos))
        tell("the robot's clock is ${Math.abs(aheadMs)} ms $side this computer's, give or take $errorMs ms; ages go by its time stamps")
    }

    companion object {
        const val CLOCK = "/clock"

        val MAX_AGE_NANOS = TimeUnit.MINUTES.toNanos(10)

        /** The tolerance for stamps that lie ahead, since clock readings have errors. */
        private val AHEAD_NANOS = TimeUnit.SECONDS.toNanos(1)
        private const val FIRST_ANSWERS = 4
        private val FIRST_INTERVAL_NANOS = TimeUnit.MILLISECONDS.toNanos(50)
        private val INTERVAL_NANOS = TimeUnit.SECONDS.toNanos(10)
        private val UNKNOWN_INTERVAL_NANOS = TimeUnit.MINUTES.toNanos(1)
        private val CHANGE_NANOS = TimeUnit.MILLISECONDS.toNanos(50)
        private val SAME_INSTANT_NANOS = TimeUnit.SECONDS.toNanos(1)
        private val SAME_TIME_NANOS = TimeUnit.MINUTES.toNanos(1)
    }
}
