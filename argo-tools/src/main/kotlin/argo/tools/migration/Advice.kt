package argo.tools.migration

/**
 * Something in a program that is otherwise here.
 *
 * @property file its path
 * @property line counted from 1
 * @property must whether the program does not do what it did until this is changed
 * @property what what is different
 * @property remedy what to do
 */
internal data class Advice(val file: String, val line: Int, val must: Boolean, val what: String, val remedy: String)

/** Collects what is to be said of one file. */
internal class Advices(private val file: String) {
    private val collected = ArrayList<Advice>()

    /** In the order of the lines. */
    val all: List<Advice> get() = collected.sortedBy { it.line }

    fun change(line: Int, what: String, remedy: String) {
        collected += Advice(file, line, true, what, remedy)
    }

    fun note(line: Int, what: String, remedy: String) {
        collected += Advice(file, line, false, what, remedy)
    }
}
