package argo.check.rules

/** Text that Jason refuses. */
internal object SyntaxRules : Rule {
    override fun check(scene: Scene, report: Report) = scene.program.program.errors.forEach {
        report.error("syntax", it.span, it.message, "Jason refuses the whole file",
            "correct it; the rest of the file is checked as far as it can be read")
    }
}
