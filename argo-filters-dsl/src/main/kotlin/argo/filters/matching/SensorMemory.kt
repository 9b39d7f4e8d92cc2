package argo.filters.matching

/**
 * A filter's memory. The memory has a value for each sensor of each owner. An owner is a rule or a condition. Each owner has its own
 * names for sensors.
 *
 * If a board has more than [CAPACITY] sensors, the memory forgets the sensors whose last look-up is longest ago. The memory has no room
 * for percepts longer than [MAX_LENGTH] characters ([isRoomFor]). A look-up allocates nothing. Not thread-safe.
 */
internal class SensorMemory<V : Any> {
    private val probe = SensorKey()
    private val values = object : LinkedHashMap<SensorKey, V>(INITIAL_CAPACITY, LOAD_FACTOR, true) {
        override fun removeEldestEntry(eldest: Map.Entry<SensorKey, V>) = size > CAPACITY
    }

    val isEmpty: Boolean get() = values.isEmpty()

    /** Returns the value of the sensor that [owner] calls [name], or null. */
    operator fun get(owner: Any, name: String): V? = values[probe.of(owner, name, name.length, name.length)]

    /** Returns the value of [owner] for a sensor, or null. The sensor's name is the [text] without the part from [from] to [to]. */
    fun get(owner: Any, text: CharSequence, start: Int, from: Int, to: Int, end: Int): V? =
        values[probe.of(owner, text, from, to, start, end)]

    operator fun get(key: SensorKey): V? = values[key]

    /** Returns the key of the last sensor that was looked up. */
    fun newKey(): SensorKey = probe.copy()

    operator fun set(key: SensorKey, value: V) {
        values[key] = value
    }

    /** Stores [value] for the last sensor that was looked up. */
    fun put(value: V) = set(newKey(), value)

    companion object {
        const val CAPACITY = 4_096
        const val MAX_LENGTH = 1_024
        private const val INITIAL_CAPACITY = 16
        private const val LOAD_FACTOR = 0.75f

        fun isRoomFor(length: Int) = length <= MAX_LENGTH
    }
}

/** An owner's name for a sensor: the text of the sensor's percepts without the changing part. */
internal class SensorKey(
    private var owner: Any? = null, private var name: CharArray = CharArray(INITIAL_LENGTH), private var length: Int = 0,
) {
    private var hash = 0

    /** Sets this name to the [text] from [start] to [end], without the part from [from] to [to]. */
    fun of(owner: Any, text: CharSequence, from: Int, to: Int, start: Int = 0, end: Int = text.length): SensorKey {
        val room = from - start + end - to
        if (name.size < room) name = CharArray(2 * room)
        this.owner = owner
        length = 0
        hash = owner.hashCode()
        add(text, start, from)
        add(text, to, end)
        return this
    }

    private fun add(text: CharSequence, from: Int, to: Int) {
        for (i in from until to) {
            val character = text[i]
            name[length++] = character
            hash = 31 * hash + character.code
        }
    }

    fun copy() = SensorKey(owner, name.copyOf(length), length).also { it.hash = hash }

    override fun hashCode(): Int = hash

    override fun equals(other: Any?): Boolean =
        other is SensorKey && owner === other.owner && java.util.Arrays.equals(name, 0, length, other.name, 0, other.length)

    private companion object {
        const val INITIAL_LENGTH = 64
    }
}
