package argo.check.rules

import argo.check.project.Mention
import argo.check.project.Role

/** Beliefs that are read but never believed, or believed but never read. A slip in the name or in the arguments may be the cause. */
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
        val often = scene.everyMention(*READS).groupingBy { it.functor }.eachCount()
        val percepts = scene.project.robot.percepts.map { it.functor() }.toSet()
        val arities = believed.groupBy({ it.functor }, { it.arity })
        val base = believed.map { it.functor } + TRUTHS + scene.namesOfJaCaMo + percepts + scene.project.operations
        val names = Names(base)
        val namesOfMore = Names(base + often.filter { it.value > 1 }.keys)
        val namesOfAll = Names(base + often.keys)
        for (mention in READS.flatMap { scene.program.mentions[it] }) {
            val indicator = mention.literal.indicator
            if (indicator in known || indicator in tests || mention.functor in percepts || scene.isKnownElsewhere(mention)) continue
            val sameName = arities[mention.functor].orEmpty().distinct()
            val candidates = when {
                often[mention.functor] != 1 -> names
                mention.role == Role.DELETED -> namesOfAll
                else -> namesOfMore
            }
            val meant = candidates.near(mention.functor)
            val what = "${mention.functor}/${mention.arity} is ${wordFor(mention.role)} and never believed"
            when {
                sameName.isNotEmpty() -> report.warning(
                    "belief-arity", mention.span,
                    "$what: the agent believes ${sameName.sorted().joinToString(" and ") { "${mention.functor}/$it" }}",
                    WHY_READ, "correct the arguments",
                )
                meant != null -> report.warning("belief-unknown", mention.span, what, WHY_READ, "did you mean $meant?")
            }
        }
    }

    private fun neverRead(scene: Scene, report: Report, reads: List<Mention>, believed: List<Mention>) {
        val everyRead = scene.everyMention(*READS).map { it.functor }.toSet()
        report.slips("belief-unread", scene.program.mentions[Role.TOLD], everyRead, scene, "this message has no effect") {
            "no agent of the project reads ${it.literal.indicator}"
        }
        val known = (reads + scene.mentions(Role.TEST_HANDLED)).map { it.functor }.toSet()
        val often = believed.groupingBy { it.functor }.eachCount()
        val names = Names(known)
        val namesOfMore = Names(known + often.filter { it.value > 1 }.keys)
        for (mention in scene.program.mentions[Role.BELIEVED]) {
            if (mention.functor in known || scene.isKnownElsewhere(mention)) continue
            val meant = (if (often.getValue(mention.functor) == 1) namesOfMore else names).near(mention.functor) ?: continue
            val what = "${mention.literal.indicator} is believed and never read"
            report.warning("belief-unread", mention.span, what, "this belief has no effect", "did you mean $meant?")
        }
    }

    private fun wordFor(role: Role) = when (role) {
        Role.EVENT -> "awaited"
        Role.DELETED -> "deleted"
        Role.ASKED -> "asked for"
        else -> "read"
    }

    private val TRUTHS = listOf("true", "false", "jag_awaking", "jag_sleeping", "jag_shutting_down")
    private const val WHY_READ = "it is never true, and causes no event"
}
