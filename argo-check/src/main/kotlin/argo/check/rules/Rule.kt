package argo.check.rules

import argo.check.findings.Finding
import argo.check.findings.Level
import argo.check.findings.Place
import argo.check.project.Mention
import argo.check.syntax.Span

/** Finds the errors of one kind in one program. A rule has no state. One instance can check many texts. */
internal fun interface Rule {
    fun check(scene: Scene, report: Report)
}

/** Collects the findings in one file. [place] converts a span to a place. */
internal class Report(private val place: (Span) -> Place) {
    private val collected = ArrayList<Finding>()

    val findings: List<Finding> get() = collected

    fun error(rule: String, span: Span, what: String, why: String, remedy: String) = add(rule, Level.ERROR, span, what, why, remedy)

    fun warning(rule: String, span: Span, what: String, why: String, remedy: String) = add(rule, Level.WARNING, span, what, why, remedy)

    fun hint(rule: String, span: Span, what: String, why: String, remedy: String) = add(rule, Level.HINT, span, what, why, remedy)

    /** Warns of [mentions] with an unknown functor that resembles one of [known]. */
    fun slips(rule: String, mentions: List<Mention>, known: Set<String>, scene: Scene, why: String, what: (Mention) -> String) {
        val names = SimilarNames(known)
        for (mention in mentions) {
            if (mention.functor in known || scene.isKnownElsewhere(mention)) continue
            val meant = names.near(mention.functor) ?: continue
            warning(rule, mention.span, what(mention), why, "did you mean $meant?")
        }
    }

    fun add(rule: String, level: Level, span: Span, what: String, why: String, remedy: String) {
        collected += Finding(rule, level, place(span), what, why, remedy)
    }
}
