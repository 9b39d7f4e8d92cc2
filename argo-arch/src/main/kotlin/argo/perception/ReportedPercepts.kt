package argo.perception

import argo.filters.CriticalRule
import javino.wire.Shape

/**
 * The percepts that a board has reported by themselves since it was asked for the newest message, the last one for each critical rule, so
 * that a message of before does not take their place. Not safe for use by several threads at once.
 */
internal class ReportedPercepts {
    private class Report(val text: String, val receivedNanos: Long)

    private val reports = LinkedHashMap<CriticalRule, Report>() // in the order in which they came

    /** Their texts. */
    val texts: List<String> get() = reports.values.map { it.text }

    /** [text] was reported at [receivedNanos], since it meets [rule]. */
    fun add(rule: CriticalRule, text: String, receivedNanos: Long) {
        reports -= rule
        reports[rule] = Report(text, receivedNanos)
    }

    /** A message came that the board was asked for at [askedNanos]: what it reported before is in the message. */
    fun dropBefore(askedNanos: Long) {
        reports.values.removeIf { it.receivedNanos - askedNanos <= 0 }
    }

    /** Forgets all. */
    fun clear() = reports.clear()

    /** [message] with each report in place of the percept that it is a newer value of, or behind the others. */
    fun placedIn(message: List<String>): List<String> = reports.values.fold(message) { percepts, report -> placed(report.text, percepts) }

    private fun placed(text: String, percepts: List<String>): List<String> {
        val numbers = ArrayList<String>()
        val shape = Shape.of(text, numbers)
        val place = percepts.indices.filter { Shape.of(percepts[it]) == shape }.maxByOrNull { same(numbers, percepts[it]) }
        return if (place == null) percepts + text else percepts.toMutableList().also { it[place] = text }
    }

    /** How many [numbers] of a percept another of its shape shares: of `sonar(1,30)` and `sonar(2,40)`, `sonar(2,9)` is the second's. */
    private fun same(numbers: List<String>, other: String): Int {
        val others = ArrayList<String>()
        Shape.of(other, others)
        return numbers.zip(others).count { (one, another) -> one == another }
    }
}
