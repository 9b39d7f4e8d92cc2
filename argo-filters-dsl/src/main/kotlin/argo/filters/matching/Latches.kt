package argo.filters.matching

/** Remembers for which sensors a condition with two limits holds: their number has met the first limit, but not yet reached the second. */
internal class Latches {
    private val memory = SensorMemory<Unit>()

    /**
     * Returns true if [condition] holds for the sensor of the percept in [text]. The sensor's name is the text from [start] to [from] and
     * from [to] to [end].
     */
    fun isOn(condition: Any, text: CharSequence, start: Int, from: Int, to: Int, end: Int): Boolean =
        memory.get(condition, text, start, from, to, end) != null

    /** Notes whether the condition holds from now on for the sensor that was asked for last. [wasOn] was the answer for that sensor. */
    fun set(wasOn: Boolean, isOn: Boolean) {
        if (isOn && !wasOn) memory.put(Unit) else if (wasOn && !isOn) memory.remove()
    }
}
