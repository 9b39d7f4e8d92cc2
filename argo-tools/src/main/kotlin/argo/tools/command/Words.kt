package argo.tools.command

import java.nio.charset.Charset

/** Returns [count] and [noun] in singular or plural, such as `1 command` or `17 commands`. */
fun counted(count: Number, noun: String): String = if (count.toLong() == 1L) "1 $noun" else "$count ${noun}s"

/** Returns the character set of the standard output. The property for it depends on the Java version. */
fun standardCharset(): Charset {
    val encoding = listOf("stdout.encoding", "sun.stdout.encoding", "native.encoding").firstNotNullOfOrNull(System::getProperty)
    return if (encoding != null && Charset.isSupported(encoding)) Charset.forName(encoding) else Charset.defaultCharset()
}

/** Returns the lines of a table: [head], and [rows] in columns below it. Without rows, the result is empty. */
internal fun table(head: List<String>, rows: List<List<String>>): List<String> {
    if (rows.isEmpty()) return emptyList()
    val all = listOf(head) + rows
    val widths = head.indices.map { column -> all.maxOf { it[column].length } }
    return all.map { line -> line.mapIndexed { column, text -> text.padEnd(widths[column]) }.joinToString("  ").trimEnd() }
}
