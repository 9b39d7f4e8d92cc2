package argo.filters

/**
 * Makes a foreign text fit for a message. Control characters, which could command a terminal, become `\xHH`. Of a text that is much longer,
 * only the [first] and the [last] characters stay.
 */
internal fun foreignText(text: String, first: Int, last: Int = 0): String {
    val omitted = text.length - first - last
    val shown = if (omitted < WORTH_OMITTING) text else "${text.take(first)}… $omitted characters …${text.takeLast(last)}"
    return shown.map { if (it.isISOControl()) "\\x%02X".format(it.code) else "$it" }.joinToString("")
}

private const val WORTH_OMITTING = 80
