package argo.filters.matching

/** The last [size] numbers of a series, sorted by value. [add] takes time linear in [size] and allocates nothing. */
internal class SortedWindow(private val size: Int) {
    private val numbers = DoubleArray(size)

    /** The indices of [numbers], sorted by number. */
    private val order = IntArray(size)
    private var next = 0

    /** The number of numbers in the window. */
    var count = 0
        private set

    /** Adds [number]. In a full window, [number] replaces the oldest. Returns the index of [number] in [numbers]. */
    fun add(number: Double): Int {
        val place = next
        next = if (place + 1 == size) 0 else place + 1
        val oldest = if (count == size) positionOf(place) else count++
        numbers[place] = number
        insert(place, number, oldest)
        return place
    }

    private fun positionOf(place: Int): Int {
        var i = 0
        while (order[i] != place) i++
        return i
    }

    /** Moves the gap in [order] from [gap] to the place of [number], after equal numbers, and puts [place] there. */
    private fun insert(place: Int, number: Double, gap: Int) {
        var i = gap
        while (i > 0 && numbers[order[i - 1]] > number) {
            order[i] = order[i - 1]
            i--
        }
        while (i < count - 1 && numbers[order[i + 1]] <= number) {
            order[i] = order[i + 1]
            i++
        }
        order[i] = place
    }

    /** Returns the index of the median. If there are two middle numbers, returns the index of the newer. */
    fun median(): Int {
        val upper = order[count / 2]
        if (count % 2 == 1) return upper
        val lower = order[count / 2 - 1]
        return if (age(lower) < age(upper)) lower else upper
    }

    private fun age(place: Int) = (next - 1 - place + size) % size

    /** Returns the number at index [place]. */
    operator fun get(place: Int): Double = numbers[place]

    /** Returns the median. If there are two middle numbers, returns the greater. */
    fun middle(): Double = numbers[order[count / 2]]

    /** Returns the median of the distances to [middle]. If there are two middle distances, returns the greater. */
    fun medianDistance(): Double {
        var low = count / 2
        var high = low
        val middle = numbers[order[low]]
        var distance = 0.0
        repeat(count / 2) {
            val below = if (low > 0) middle - numbers[order[low - 1]] else Double.POSITIVE_INFINITY
            val above = if (high < count - 1) numbers[order[high + 1]] - middle else Double.POSITIVE_INFINITY
            distance = minOf(below, above)
            if (below <= above) low-- else high++
        }
        return distance
    }

    /** Returns a window with the same numbers. */
    fun copy() = SortedWindow(size).also {
        numbers.copyInto(it.numbers)
        order.copyInto(it.order)
        it.next = next
        it.count = count
    }
}
