package argo.tools.command

/** Returns [count] with [noun] in singular or plural: `1 command`, `17 commands`. */
internal fun counted(count: Number, noun: String): String = if (count.toLong() == 1L) "1 $noun" else "$count ${noun}s"
