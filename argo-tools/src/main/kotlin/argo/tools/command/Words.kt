package argo.tools.command

/** Returns [count] with [noun] in singular or plural: `1 command`, `17 commands`. */
internal fun counted(count: Number, noun: String): String = if (count.toLong() == 1L) "1 $noun" else "$count ${noun}s"

/** Arranges [rows] below [head] in columns. Returns no lines without rows. */
internal fun table(head: List<String>, rows: List<List<String>>): List<String> {
    if (rows.isEmpty()) return emptyList()
    val all = listOf(head) + rows
    val widths = head.indices.map { column -> all.maxOf { it[column].length } }
    return all.map { line -> line.mapIndexed { column, text -> text.padEnd(widths[column]) }.joinToString("  ").trimEnd() }
}
