package argo.tools.migration

/**
 * A difference between this version of ARGO and the one that a program was written for.
 *
 * @property line counted from 1
 * @property column counted from 1; null: it is about the line
 * @property must true if the program behaves differently until this is changed
 * @property what the difference that the advice is about
 */
internal data class Advice(
    val file: String,
    val line: Int,
    val must: Boolean,
    val what: String,
    val remedy: String,
    val column: Int? = null,
) {
    /** `file:line`, with the column if it is known. */
    val place: String get() = "$file:$line" + column?.let { ":$it" }.orEmpty()
}

internal class Advices(private val file: String) {
    private val collected = ArrayList<Advice>()

    /** In the order of the lines. */
    val all: List<Advice> get() = collected.sortedBy { it.line }

    fun change(line: Int, what: String, remedy: String, column: Int? = null) {
        collected += Advice(file, line, true, what, remedy, column)
    }

    fun note(line: Int, what: String, remedy: String) {
        collected += Advice(file, line, false, what, remedy)
    }
}
