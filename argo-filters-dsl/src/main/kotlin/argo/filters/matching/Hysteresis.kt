package argo.filters.matching

/**
 * Remembers for which sensors a condition with two limits holds. A picture is the set of percepts that are received together. The
 * condition holds for a percept whose number meets the first limit. If it held for the sensor in the previous picture, it also holds for
 * a number that meets the second limit. The result does not depend on the order of percepts in a picture, or on the number of calls for
 * one percept.
 *
 * @param notes true if [holds] records the result for the next picture
 */
internal class Hysteresis private constructor(
    private val memory: SensorMemory<Latch>, private var picture: Long, private val notes: Boolean,
) {
    constructor() : this(SensorMemory(), 0, true)

    /** True if no condition has held for any sensor yet. */
    val isEmpty: Boolean get() = memory.isEmpty

    /** Begins the next picture. */
    fun begin() {
        picture++
    }

    /** Returns a hysteresis that answers for the next picture and records nothing. */
    fun ofNext() = Hysteresis(memory, picture + 1, false)

    /**
     * Returns true if [condition] holds in this picture for the percept in [text], whose number meets the second limit. The sensor's name
     * is the text from [start] to [from] and from [to] to [end]. A percept that is too long for a [SensorMemory] is not remembered.
     *
     * @param isMet true if the number also meets the first limit
     */
    fun holds(condition: Any, text: CharSequence, start: Int, from: Int, to: Int, end: Int, isMet: Boolean): Boolean {
        if (!SensorMemory.isRoomFor(end)) return isMet
        val known = memory.get(condition, text, start, from, to, end)
        val holds = isMet || known?.heldBefore(picture) == true
        if (holds && notes) (known ?: Latch().also(memory::put)).hold(picture)
        return holds
    }

    /** The last unbroken series of pictures, from [first] to [last], in which a condition held for a sensor. */
    private class Latch {
        private var first = 0L
        private var last = -1L

        fun heldBefore(picture: Long) = first < picture && last >= picture - 1

        fun hold(picture: Long) {
            if (last < picture - 1) first = picture
            last = picture
        }
    }
}
