package argo.check.rules

import argo.check.project.Mention
import argo.check.project.Role

/**
 * Finds beliefs that are read but never added, or added but never read. A misspelt name or a wrong number of arguments may be the cause.
 */
internal object BeliefRules : Rule {
    private val READS = arrayOf(Role.READ, Role.EVENT, Role.DELETED, Role.ASKED)
    private val SOURCES = arrayOf(Role.BELIEVED, Role.TOLD)

    override fun check(scene: Scene, report: Report) {
        val reads = scene.mentions(*READS)
        val believed = scene.mentions(*SOURCES)
        neverBelieved(scene, report, reads, believed)
        neverRead(scene, report, reads, believed)
    }

    private fun neverBelieved(scene: Scene, report: Report, reads: List<Mention>, believed: List<Mention>) {
        val known = believed.map { it.literal.indicator }.toSet()
        val tests = scene.mentions(Role.TEST_HANDLED).map { it.literal.indicator }.toSet()
        val often = scene.facts.often(*READS)
        val percepts = scene.project.robot.percepts.map { it.functor() }.toSet()
        val arities = GoalRules.aritiesIn(believed)
        val base = believed.map { it.functor } + TRUTHS + scene.namesOfJaCaMo + percepts + scene.project.operations
        val isClosed = scene.isClosed && scene.agents.none { it.isArgo } && !scene.isOpen(Role.BELIEVED) && !scene.facts.isOpen(Role.TOLD)
        val names = SimilarNames(base)
        val namesOfMore = SimilarNames(base + often.filter { it.value > 1 }.keys)
        val namesOfAll = SimilarNames(base + often.keys)
        for (mention in READS.flatMap { scene.program.mentions[it] }) {
            val indicator = mention.literal.indicator
            if (indicator in known || indicator in tests || mention.functor in percepts || scene.isKnownElsewhere(mention)) continue
            val sameName = arities[mention.functor]
            val candidates = when {
                often[mention.functor] != 1 -> names
                mention.role == Role.DELETED -> namesOfAll
                else -> namesOfMore
            }
            val meant = candidates.near(mention.functor)
            val what = "${mention.functor}/${mention.arity} is ${wordFor(mention.role)} and never believed"
            when {
                sameName != null -> report.warning(
                    "belief-arity", mention.span,
                    "$what: the agent believes ${GoalRules.forms(mention, sameName)}",
                    WHY_READ, "correct the arguments",
                )
                meant != null -> report.warning("belief-unknown", mention.span, what, WHY_READ, "did you mean $meant?")
                isClosed -> report.hint("belief-unknown", mention.span, what, WHY_READ, "believe it, or say that $OTHERS")
            }
        }
    }

    private fun neverRead(scene: Scene, report: Report, reads: List<Mention>, believed: List<Mention>) {
        val everyRead = scene.facts.often(*READS).keys
        report.slips("belief-unread", scene.program.mentions[Role.TOLD], everyRead, scene, "this message has no effect") {
            "no agent of the project reads ${it.literal.indicator}"
        }
        val known = (reads + scene.mentions(Role.TEST_HANDLED)).map { it.functor }.toSet()
        val isClosed = scene.isClosed && !scene.facts.isOpen(Role.ASKED) && !scene.isOpen(Role.READ, Role.EVENT)
        val often = believed.groupingBy { it.functor }.eachCount()
        val names = SimilarNames(known)
        val namesOfMore = SimilarNames(known + often.filter { it.value > 1 }.keys)
        for (mention in scene.program.mentions[Role.BELIEVED]) {
            if (mention.functor in known || scene.isKnownElsewhere(mention)) continue
            val meant = (if (often.getValue(mention.functor) == 1) namesOfMore else names).near(mention.functor)
            val what = "${mention.literal.indicator} is believed and never read"
            val why = "this belief has no effect"
            when {
                meant != null -> report.warning("belief-unread", mention.span, what, why, "did you mean $meant?")
                isClosed -> report.hint("belief-unread", mention.span, what, why, "read it, or remove it")
            }
        }
    }

    private fun wordFor(role: Role) = when (role) {
        Role.EVENT -> "awaited"
        Role.DELETED -> "deleted"
        Role.ASKED -> "asked for"
        else -> "read"
    }

    private val TRUTHS = listOf("true", "false", "jag_awaking", "jag_sleeping", "jag_shutting_down")
    private const val OTHERS = "others may send it"
    private const val WHY_READ = "it is never true, and causes no event"
}
