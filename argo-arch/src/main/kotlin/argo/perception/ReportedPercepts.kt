package argo.perception

import argo.filters.CriticalRule
import javino.wire.Shape

/**
 * The percepts that a board has reported since the request for its newest message: for each critical rule, the last report. The reports are
 * kept because the board may have made the message before them. Not safe for use by several threads at once.
 */
internal class ReportedPercepts {
    private class Report(val text: String, val receivedNanos: Long)

    private val reports = LinkedHashMap<CriticalRule, Report>() // in the order of the reports

    val texts: List<String> get() = reports.values.map { it.text }

    /** Adds the percept [text], reported at [receivedNanos] because it meets [rule]. */
    fun add(rule: CriticalRule, text: String, receivedNanos: Long) {
        reports -= rule
        reports[rule] = Report(text, receivedNanos)
    }

    /** Drops reports from before [askedNanos], since the message that was requested at [askedNanos] is newer. */
    fun dropBefore(askedNanos: Long) {
        reports.values.removeIf { it.receivedNanos - askedNanos <= 0 }
    }

    fun clear() = reports.clear()

    /**
     * Returns [message] with each report in place of the older percept of its sensor. If there is no older percept, the report goes to the
     * end.
     */
    fun placedIn(message: List<String>): List<String> = reports.values.fold(message) { percepts, report -> placed(report.text, percepts) }

    private fun placed(text: String, percepts: List<String>): List<String> {
        val numbers = ArrayList<String>()
        val shape = Shape.of(text, numbers)
        val place = percepts.indices.filter { Shape.of(percepts[it]) == shape }.maxByOrNull { same(numbers, percepts[it]) }
        return if (place == null) percepts + text else percepts.toMutableList().also { it[place] = text }
    }

    /** Returns how many of [numbers] are also in [other] at their places. `sonar(2,9)` must replace `sonar(2,40)`, not `sonar(1,30)`. */
    private fun same(numbers: List<String>, other: String): Int {
        val others = ArrayList<String>()
        Shape.of(other, others)
        return numbers.zip(others).count { (one, another) -> one == another }
    }
}
