package argo.filters.matching

/**
 * Remembers for which sensors a condition with two limits holds: their number has met the first limit, but not yet reached the second. It
 * ends for a sensor that a picture leaves out.
 */
internal class Latches {
    /** The last [picture] in which a condition held for a sensor. */
    private class Latch(var picture: Long)

    private val memory = SensorMemory<Latch>()
    private var picture = 0L

    /** True if no condition holds for any sensor, so that none need be looked up. */
    val areAllOff: Boolean get() = memory.isEmpty

    /** Begins the next picture of the world. */
    fun begin() {
        picture++
    }

    /**
     * Returns true if [condition] holds in this picture for the sensor of the percept in [text]. The sensor's name is the text from [start]
     * to [from] and from [to] to [end].
     */
    fun isOn(condition: Any, text: CharSequence, start: Int, from: Int, to: Int, end: Int): Boolean =
        memory.get(condition, text, start, from, to, end)?.picture == picture

    /**
     * Notes a percept of this picture. The first parameters are those of [isOn].
     *
     * @param isMet the number meets the first limit
     * @param isWithin the number meets the second limit
     */
    fun note(condition: Any, text: CharSequence, start: Int, from: Int, to: Int, end: Int, isMet: Boolean, isWithin: Boolean) {
        val latch = memory.get(condition, text, start, from, to, end)
        val isOn = isMet || isWithin && latch != null && latch.picture >= picture - 1
        if (latch == null) {
            if (isOn) memory.put(Latch(picture))
        } else if (isOn) latch.picture = picture else memory.remove()
    }
}
