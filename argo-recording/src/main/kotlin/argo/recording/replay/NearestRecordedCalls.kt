package argo.recording.replay

import argo.recording.Call
import argo.recording.Cycle
import argo.recording.End

/**
 * Finds recorded calls, and the ends of their operations, in [cycles]. The recorded calls answer an agent that may make other calls, or
 * make its calls at other times.
 */
internal class NearestRecordedCalls(cycles: Sequence<Cycle>) {
    class Made(val call: Call, val index: Long, val ns: Long) {
        var isTaken = false
    }

    class Ended(val end: End, val index: Long, val ns: Long) {
        var isTaken = false
    }

    private val made = HashMap<String, ArrayList<Made>>()
    private val ended = HashMap<Int, Ended>()
    private val timers = ArrayList<Ended>()

    init {
        for (cycle in cycles) {
            cycle.input.calls.forEach { made.getOrPut(key(it.name, it.args)) { ArrayList() } += Made(it, cycle.index, cycle.ns) }
            for (end in cycle.input.ends) if (end.number != 0) {
                val one = Ended(end, cycle.index, cycle.ns)
                ended[end.number] = one
                if (end.kind == TIMER) timers += one
            }
        }
    }

    /** The usual duration of a command, from its call to its outcome, in ns: the median of the recorded durations. */
    val usualNs: Long = made.values.flatten().filter { it.call.commands.isNotEmpty() }
        .mapNotNull { call -> call.call.number?.let(ended::get)?.let { it.ns - call.ns } }
        .sorted().let { it.getOrNull(it.size / 2) ?: USUAL_NS }

    fun endOf(number: Int): Ended? = ended[number]

    /** Returns the next call of [name] with [args]; null if none is left. Returns each call once. */
    fun nextOf(name: String, args: List<String>): Made? =
        made[key(name, args)]?.firstOrNull { !it.isTaken }?.also { it.isTaken = true }

    /**
     * Returns the call of [name] with [args] in the cycle with [index]. If this cycle has no such call, returns the nearest call within
     * [NEAR_NS] of [ns]; null if none is left. Returns each call once.
     */
    fun near(name: String, args: List<String>, index: Long?, ns: Long): Made? =
        around(name, args, ns).filter { !it.isTaken }.minByOrNull { distance(it, index, ns) }?.also { it.isTaken = true }

    /** Searches like [near], but may return a call several times. */
    fun nearest(name: String, args: List<String>, index: Long?, ns: Long): Made? =
        around(name, args, ns).minByOrNull { distance(it, index, ns) }

    /** Returns the first call of [name] with [args], at any time. May return a call several times. */
    fun firstOf(name: String, args: List<String>): Made? = made[key(name, args)]?.first()

    /** Returns the end of a timer at about [ns], or a little later, since an agent sees the end late. Returns each end once. */
    fun timer(ns: Long): Ended? {
        val first = timers.binarySearch { it.ns.compareTo(ns - EARLY_NS) }.let { if (it < 0) -it - 1 else it }
        return timers.asSequence().drop(first).takeWhile { it.ns <= ns + LATE_NS }.firstOrNull { !it.isTaken }?.also { it.isTaken = true }
    }

    /** Returns the end of the timer [number] of the recorded step if this end came at about [ns]. Returns each end once. */
    fun takeTimer(number: Int, ns: Long): Ended? =
        ended[number]?.takeIf { !it.isTaken && it.end.kind == TIMER && it.ns - ns in -EARLY_NS..LATEST_NS }?.also { it.isTaken = true }

    private fun around(name: String, args: List<String>, ns: Long): Sequence<Made> {
        val calls = made[key(name, args)] ?: return emptySequence()
        val first = calls.binarySearch { if (it.ns < ns - NEAR_NS) -1 else 1 }.let { -it - 1 }
        return calls.asSequence().drop(first).takeWhile { it.ns <= ns + NEAR_NS }
    }

    private fun distance(call: Made, index: Long?, ns: Long) =
        if (call.index == index) -1 else if (call.ns > ns) call.ns - ns else ns - call.ns

    private fun key(name: String, args: List<String>) = "$name(${args.joinToString(",", transform = ::normal)})"

    companion object {
        /** The largest distance in time between a question and its recorded answer, in ns. */
        const val NEAR_NS = 1_000_000_000L

        private const val TIMER = "timer"

        /** How much too early or too late a timer may seem to end, in ns. */
        private const val EARLY_NS = 2_000_000L
        private const val LATE_NS = 100_000_000L
        private const val LATEST_NS = 2_000_000_000L

        /** The assumed duration of a command if none was recorded, in ns. */
        private const val USUAL_NS = 10_000_000L
    }
}
