package argo.check.rules

import argo.check.syntax.SyntaxError

internal object SyntaxRules : Rule {
    override fun check(scene: Scene, report: Report) {
        val program = scene.program.program
        val foreign = program.errors.find { REPLACEMENT in program.text.substring(it.span.start, it.span.end) }
        val errors = if (foreign == null) program.errors else listOf(SyntaxError(foreign.span, "this is no text in UTF-8"))
        errors.take(MOST).forEach {
            report.error("syntax", it.span, it.message, "Jason refuses the whole file",
                "correct it; the rest of the file is checked as far as it can be read")
        }
        errors.drop(MOST).firstOrNull()?.let {
            report.error("syntax", it.span, "from here on are ${errors.size - MOST} more errors", "Jason refuses the whole file",
                "correct the first ones, and check again")
        }
    }

    /** The decoder replaces invalid UTF-8 with this character. */
    private const val REPLACEMENT = '\uFFFD'
    private const val MOST = 20
}
