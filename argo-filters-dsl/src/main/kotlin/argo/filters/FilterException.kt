package argo.filters

/**
 * A fault in a filter's text.
 *
 * @property source the file or other source of the text
 * @property line counted from 1
 * @property column counted from 1, in characters
 * @property message the fault and the expected text
 */
data class Problem(val source: String, val line: Int, val column: Int, val message: String) {
    override fun toString(): String = "$source:$line:$column: $message"

    /** Returns this problem with a shortened message. Keeps only the beginning and the end of a long message. */
    internal fun shortened(): Problem {
        if (message.length <= MAX_LENGTH) return this
        val omitted = message.length - SHOWN_FIRST - SHOWN_LAST
        return copy(message = "${message.take(SHOWN_FIRST)}… $omitted characters …${message.takeLast(SHOWN_LAST)}")
    }

    private companion object {
        const val MAX_LENGTH = 450
        const val SHOWN_FIRST = 120

        /** The number of characters kept at the end of a long message, which states the expected text. */
        const val SHOWN_LAST = 250
    }
}

/**
 * Thrown if a filter's text is refused. The message lists all [problems], one a line, in the order of the text. The message shortens long
 * values.
 *
 * @throws IllegalArgumentException if [problems] is empty
 */
class FilterException(problems: List<Problem>, cause: Throwable? = null) :
    Exception(problems.joinToString("\n") { "${it.shortened()}" }, cause) {

    val problems: List<Problem> = java.util.List.copyOf(problems.map(Problem::shortened))

    init {
        require(problems.isNotEmpty()) { "a filter is refused for at least one problem" }
    }
}

/** Thrown if no filter has the requested name. The message lists the searched places and the existing filters. */
class FilterNotFoundException(message: String) : Exception(message)
