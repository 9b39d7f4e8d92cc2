package argo.filters

/** Replaces the control characters of [text], which could command a terminal, by `\xHH`. */
fun withControlsShown(text: String): String = text.map { if (it.isISOControl()) "\\x%02X".format(it.code) else "$it" }.joinToString("")

/** Makes a foreign text fit for a message or a log line. Of a text that is much longer, only the [first] and the [last] characters stay. */
fun foreignText(text: String, first: Int = 200, last: Int = 0): String {
    val omitted = text.length - first - last
    val shown = if (omitted < WORTH_OMITTING) text else "${text.take(first)}… $omitted characters …${text.takeLast(last)}"
    return withControlsShown(shown)
}

private const val WORTH_OMITTING = 80
