package argo.filters.matching

/** The sensors whose number a condition with two limits holds for, since it has met the first one and not yet reached the second. */
internal class Latches {
    private val memory = SensorMemory<Unit>()

    /**
     * Returns true if [condition] holds for the sensor of the percept in [text], which is named by its parts from [start] to [from] and
     * from [to] to [end].
     */
    fun isOn(condition: Any, text: CharSequence, start: Int, from: Int, to: Int, end: Int): Boolean =
        memory.get(condition, text, start, from, to, end) != null

    /** Notes whether the sensor that was asked for last, and was one of those if it [wasOn], is one of them from now on. */
    fun set(wasOn: Boolean, isOn: Boolean) {
        if (isOn && !wasOn) memory.put(Unit) else if (wasOn && !isOn) memory.remove()
    }
}
