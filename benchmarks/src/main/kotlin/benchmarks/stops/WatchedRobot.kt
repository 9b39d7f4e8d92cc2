package benchmarks.stops

import javino.LineClock

/**
 * The robot that the sketch `Stops` or `FieldStops` on [uno] drives, in the time of [clock]. The robot drives towards a wall at 10 cm/s
 * while the sketch's pin is high. The robot's front sensor gives 1 mV per mm of distance.
 */
internal class WatchedRobot(private val uno: SteppedUno, private val clock: LineClock, private val timeline: Timeline) {
    private var millimetres = 0
    private var drives = false
    private var departure: (Long) -> Long = { it }
    private val edges = HashMap<Int, Int>()

    /** The time in ns at which the sensor first showed the limit or less. Null if that has not happened since [place]. */
    var crossedAt: Long? = null
        private set

    /** The time in ns of the first stop after [crossedAt], or null before that. */
    var stoppedAt: Long? = null
        private set

    /** The time in ns of the last stop after [crossedAt]. Null if the robot has not stopped since [place]. */
    var restsSince: Long? = null
        private set

    val acted: Int get() = edges.getOrDefault(ACTED, 0)

    val looked: Int get() = edges.getOrDefault(LOOKED, 0)

    val started: Int get() = edges.getOrDefault(STARTED, 0)

    init {
        uno.changed = ::changed
        listOf(DRIVES, ACTED, LOOKED, STARTED).forEach(uno::watch)
        place(FIRST_MM) { it }
    }

    /**
     * Places the robot [millimetres] from the wall. [departure] maps the time at which the robot drives off to the time at which its first
     * millimetre begins, both in ns.
     */
    fun place(millimetres: Int, departure: (Long) -> Long) {
        this.millimetres = millimetres
        this.departure = departure
        crossedAt = null
        stoppedAt = null
        restsSince = null
        show()
    }

    private fun show() {
        uno.runTo(clock.nanos())
        uno.setMillivolts("A0", millimetres)
        if (crossedAt == null && seen(millimetres) <= LIMIT_MM) crossedAt = clock.nanos()
    }

    private fun changed(pin: Int, isHigh: Boolean, atNanos: Long) {
        if (pin != DRIVES) {
            if (isHigh || edges.containsKey(pin)) count(pin, atNanos) // the first low level only makes the pin an output, and is no edge
            return
        }
        timeline.add(if (isHigh) "drives" else "stops", atNanos)
        if (isHigh && !drives) depart(atNanos)
        if (!isHigh && drives && crossedAt != null) stop(atNanos)
        drives = isHigh
    }

    private fun count(pin: Int, atNanos: Long) {
        edges.merge(pin, 1, Int::plus)
        timeline.add(if (pin == LOOKED) "reads its sensors" else if (pin == ACTED) "acts" else "starts", atNanos)
    }

    private fun stop(atNanos: Long) {
        if (stoppedAt == null) stoppedAt = atNanos
        restsSince = atNanos
    }

    private fun depart(atNanos: Long) {
        clock.schedule(departure(atNanos) + MILLIMETRE_NANOS - clock.nanos(), ::drive)
    }

    private fun drive() {
        if (!drives || millimetres == 0) return
        millimetres--
        show()
        clock.schedule(MILLIMETRE_NANOS, ::drive)
    }

    companion object {
        const val LIMIT_MM = 800

        const val MILLIMETRE_NANOS = 10_000_000L

        private const val FIRST_MM = 1000
        private const val DRIVES = 8
        private const val ACTED = 9
        private const val LOOKED = 10
        private const val STARTED = 11

        /** Returns the voltage in mV as the sketch reads it, with ten bits for 5 V. */
        private fun seen(millivolts: Int) = millivolts * 1023 / 5000 * 5000 / 1023
    }
}
