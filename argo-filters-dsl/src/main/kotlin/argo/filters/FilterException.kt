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

    /** Returns this problem with a message that is fit to be shown. The end of a message states the expected text. */
    internal fun shown(): Problem = copy(message = foreignText(message, first = 120, last = 250))
}

/**
 * Thrown if a filter's text is refused. The message lists all [problems], one a line, in the order of the text. The messages of the
 * problems have no control characters, and only the beginning and the end of long values.
 *
 * @throws IllegalArgumentException if [problems] is empty
 */
class FilterException(problems: List<Problem>, cause: Throwable? = null) :
    Exception(problems.joinToString("\n") { "${it.shown()}" }, cause) {

    val problems: List<Problem> = java.util.List.copyOf(problems.map(Problem::shown))

    init {
        require(problems.isNotEmpty()) { "a filter is refused for at least one problem" }
    }
}

/** Thrown if no filter has the requested name. The message lists the searched places and the existing filters. */
class FilterNotFoundException(message: String) : Exception(message)
