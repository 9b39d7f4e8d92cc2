package argo.filters.format

import argo.filters.FilterException
import argo.filters.Problem

/** Collects the problems of the document called [source]. */
internal class Problems(private val source: String) {
    private val found = ArrayList<Problem>()

    fun report(at: Position, message: String) {
        report(Problem(source, at.line, at.column, message))
    }

    fun report(problem: Problem) {
        found += problem
    }

    /**
     * Returns the result of [read]. If [read] throws an [IllegalArgumentException], reports its message with the [expectation] and returns
     * null.
     */
    fun <T> reporting(at: Position, expectation: String = "", read: () -> T): T? = try {
        read()
    } catch (e: IllegalArgumentException) {
        report(at, listOf(e.message.orEmpty(), expectation).filter(String::isNotEmpty).joinToString("; "))
        null
    }

    /** @throws FilterException if there are problems; the exception lists all of them in the order of the text */
    fun throwIfAny() {
        if (found.isNotEmpty()) throw FilterException(found.distinct().sortedBy { Position(it.line, it.column) })
    }
}
