package argo.filters.matching

import argo.filters.DecimalReader
import argo.filters.GroundTerm
import argo.filters.GroundTermReader

/**
 * Applies the smoothing rules of [matcher], and remembers the [Readings] of each sensor. For a known sensor, only rules that annotate
 * allocate. Not thread-safe.
 *
 * @param annotated returns a percept with the annotation `smoothed`
 */
internal class Smoother<P : Any>(
    private val matcher: PerceptMatcher, private val textOf: (P) -> String, private val annotated: (P) -> P,
) {
    /** The effect of smoothing: [rule] would replace a percept by [standing], for this [reason]. */
    class Replacement<P>(val rule: CompiledRule, val standing: P, val reason: String)

    private val memory = SensorMemory<Sensor<P>>()
    private val places = ArrayList<Sensor<P>?>() // the last sensor at each index of a picture

    private var picture = Picture<P>()
    private var spare = Picture<P>()
    private var isDoubted = false // whether the last added percept is not credible

    /**
     * Adds the percepts [received] at [nowMs] to the readings. Returns the percepts with their replacements. If a percept of [old] was in
     * the last picture, does not add it again. The result is valid until the next call but one.
     */
    fun picture(received: List<P>, nowMs: Long, old: Set<P>): Picture<P> {
        val before = picture
        val earlier = if (old.isEmpty()) emptyMap() else before.placesOf(old)
        picture = spare.also { it.begin(received) }
        spare = before
        for (place in received.indices) {
            val earlierPlace = earlier[received[place]]
            val standing = if (earlierPlace == null) stands(received[place], nowMs, place) else before.standing(earlierPlace)
            picture.stand(standing, if (earlierPlace == null) isDoubted else before.isDoubted(earlierPlace))
        }
        return picture
    }

    /** Adds a [percept] at [nowMs], which is at index [place] of a picture. Returns its replacement, or the percept itself. */
    fun stands(percept: P, nowMs: Long, place: Int): P {
        val text = textOf(percept)
        isDoubted = false
        return places.getOrNull(place)?.takeIfItsOwn(percept, text, nowMs) ?: read(text, percept) { rule, known, from, to, number ->
            val sensor = known ?: memory.newKey().let { key -> newSensor(rule, text, from, to, key).also { memory[key] = it } }
            if (matcher.smoothsByName) sit(place, sensor)
            sensor.take(percept, text, from, to, number, nowMs)
        }
    }

    /**
     * Adds the [percept] if its text shows that it comes from this sensor. Else returns null. Searches neither for the rule nor for the
     * sensor.
     */
    private fun Sensor<P>.takeIfItsOwn(percept: P, text: String, nowMs: Long): P? {
        val to = numberEnd(text)
        val number = if (to > from && SensorMemory.isRoomFor(text.length)) DecimalReader.plain(text, from, to) else Double.NaN
        return if (number.isNaN() || memory[key] !== this) null else take(percept, text, from, to, number, nowMs)
    }

    private fun Sensor<P>.take(percept: P, text: String, from: Int, to: Int, number: Double, nowMs: Long): P =
        readings.take(percept, text, from, to, number, nowMs).also { isDoubted = readings.doubt != null }

    private fun sit(place: Int, sensor: Sensor<P>) {
        while (places.size <= place) places += null
        places[place] = sensor
    }

    /** Returns the replacement of [percept] if the percept came at [nowMs]. Returns null if no rule smooths the percept. */
    fun replacement(percept: P, nowMs: Long): Replacement<P>? {
        val text = textOf(percept)
        return read(text, null) { rule, known, from, to, number ->
            val readings = known?.readings?.copy() ?: Readings(checkNotNull(rule.smoothing), annotated)
            Replacement(rule, readings.take(percept, text, from, to, number, nowMs), readings.reason(number))
        }
    }

    private fun newSensor(rule: CompiledRule, text: String, from: Int, to: Int, key: SensorKey) =
        Sensor(Readings(checkNotNull(rule.smoothing), annotated), text.substring(0, from), text.substring(to), key)

    /**
     * Calls [found] with the rule that smooths the percept in [text], the sensor and the number. Returns [none] if no rule smooths the
     * percept.
     */
    private inline fun <T> read(
        text: String, none: T, found: (rule: CompiledRule, known: Sensor<P>?, from: Int, to: Int, number: Double) -> T,
    ): T {
        val end = text.length
        if (end > SensorMemory.MAX_LENGTH) return none
        return scan(text, 0, end, none) { functor, functorEnd, tail, head ->
            val rule = matcher.smoothingRule(text, functor, functorEnd, tail, head)
            val argument = rule?.smoothing?.argument ?: return none
            if (argument >= TermBounds.arity(tail)) return none
            val from = TermBounds.argument(text, functorEnd, end, argument)
            val to = TermBounds.partEnd(text, from, end, ')')
            val number = number(text, from, to)
            if (!number.isFinite()) return none
            found(rule, memory.get(rule, text, functorEnd, from, to, TermBounds.annotations(tail)), from, to, number)
        }
    }

    private fun number(text: String, from: Int, to: Int): Double {
        val plain = DecimalReader.plain(text, from, to)
        return if (plain.isNaN()) (GroundTermReader(text, from, to).readWhole() as? GroundTerm.Number)?.value ?: plain else plain
    }
}

/** A smoothed sensor: its [readings], and the text of its percepts [before] and [behind] the number. */
private class Sensor<P : Any>(val readings: Readings<P>, private val before: String, private val behind: String, val key: SensorKey) {
    /** The index at which the number begins. */
    val from: Int get() = before.length

    /** Returns the index at which the number in [text] would end. Returns 0 if [text] belongs to another sensor. */
    fun numberEnd(text: String): Int = if (text.startsWith(before) && text.endsWith(behind)) text.length - behind.length else 0
}
