package argo.check.rules

import argo.check.project.Role

internal object SingleNameRules : Rule {
    override fun check(scene: Scene, report: Report) {
        val told = report.findings.map { it.place.begin }.toSet()
        val tests = scene.program.goalsOfTests
        for (mention in scene.program.mentions.all.filter { it.role !in OTHERS && it.span.start !in tests && scene.isSingle(it) }) {
            val meant = scene.facts.names.near(mention.functor) ?: continue
            if (scene.program.place(mention.span).begin in told) continue
            report.hint("name-once", mention.span, "the project has the name ${mention.functor} only here", "it may be a slip",
                "did you mean $meant?")
        }
    }

    private val OTHERS = setOf(Role.DATA, Role.INTERNAL)
}
