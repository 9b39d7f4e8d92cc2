package argo.filters.format

import argo.filters.FilterException
import argo.filters.Problem

/** Collects the problems of the document called [source], so that all are reported at once. */
internal class Problems(private val source: String) {
    private val found = ArrayList<Problem>()

    fun report(at: Position, message: String) {
        report(Problem(source, at.line, at.column, message))
    }

    fun report(problem: Problem) {
        found += problem
    }

    /** Returns the result of [read]; null if it throws an [IllegalArgumentException], whose message is reported with the [expectation]. */
    fun <T> reporting(at: Position, expectation: String = "", read: () -> T): T? = try {
        read()
    } catch (e: IllegalArgumentException) {
        report(at, listOf(e.message.orEmpty(), expectation).filter(String::isNotEmpty).joinToString("; "))
        null
    }

    /** @throws FilterException with all problems, in the order of the text, if there are any */
    fun throwIfAny() {
        if (found.isNotEmpty()) throw FilterException(found.distinct().sortedBy { Position(it.line, it.column) })
    }
}
