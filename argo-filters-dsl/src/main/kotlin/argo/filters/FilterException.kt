package argo.filters

/**
 * One thing that is wrong with a filter's text.
 *
 * @property source the file or other place the text came from
 * @property line counted from 1
 * @property column counted from 1, in characters
 * @property message the finding and the expectation
 */
data class Problem(val source: String, val line: Int, val column: Int, val message: String) {
    /** `file:line:column: message`. */
    override fun toString(): String = "$source:$line:$column: $message"

    /** Returns this problem with a message of bounded length: only the beginning and the end of a long message are left. */
    internal fun shortened(): Problem {
        if (message.length <= MAX_LENGTH) return this
        val omitted = message.length - SHOWN_FIRST - SHOWN_LAST
        return copy(message = "${message.take(SHOWN_FIRST)}… $omitted characters …${message.takeLast(SHOWN_LAST)}")
    }

    private companion object {
        const val MAX_LENGTH = 450
        const val SHOWN_FIRST = 120

        /** A message ends with the expectation, so its last characters are kept. */
        const val SHOWN_LAST = 250
    }
}

/**
 * A filter was refused. The message lists all [problems], one a line, in the order of the text; long values in them are shortened.
 *
 * @throws IllegalArgumentException if there is no problem
 */
class FilterException(problems: List<Problem>, cause: Throwable? = null) :
    Exception(problems.joinToString("\n") { "${it.shortened()}" }, cause) {

    val problems: List<Problem> = java.util.List.copyOf(problems.map(Problem::shortened))

    init {
        require(problems.isNotEmpty()) { "a filter is refused for at least one problem" }
    }
}

/** There is no filter of the name that was asked for. The message lists the places of the search and the filters there are. */
class FilterNotFoundException(message: String) : Exception(message)
