package argo.check.rules

import argo.check.project.Mention
import argo.check.project.Role

/** Finds environment actions that are probably misspelt, because another action has almost the same name. */
internal object ActionRules : Rule {
    override fun check(scene: Scene, report: Report) {
        val often = scene.facts.often(Role.ACTION)
        val goals = scene.mentions(Role.HANDLED).map { it.functor }.toSet()
        val namesOfMore = HashMap<Int, SimilarNames>()
        for (action in scene.program.mentions[Role.ACTION]) {
            val times = often.getValue(action.functor)
            val names = namesOfMore.getOrPut(times) {
                SimilarNames(often.filter { it.value > times }.keys + scene.project.operations + OF_ARTIFACTS)
            }
            action(action, names, goals, scene, report)
        }
    }

    private fun action(action: Mention, names: SimilarNames, goals: Set<String>, scene: Scene, report: Report) {
        if (action.functor in scene.project.foreignNames || action.functor in KNOWN || scene.isSentByOthers(action)) return
        val meant = names.near(action.functor)
        val internal = "." + action.functor
        val what = "no action of the environment is called ${action.functor}"
        val why = "the action fails, and the plan with it"
        when {
            meant != null -> report.warning("action-unknown", action.span, what, why, "did you mean $meant?")
            internal in InternalAction.ALL && action.functor !in KEPT ->
                report.hint("action-unknown", action.span, what, why, "did you mean the internal action $internal?")
            action.functor in goals && !scene.project.hasOwnJava ->
                report.warning("action-unknown", action.span, "${action.functor} is a goal, and here it is an action", why,
                    "did you mean !${action.functor}?")
        }
    }

    /** Operations of CArtAgO's tuple spaces. The names are short, so other names resemble them by chance. */
    private val OF_TUPLE_SPACES = setOf("in", "inp", "out", "rd", "rdp")

    /** Operations that each CArtAgO workspace and each Moise organisation has. */
    private val OF_ARTIFACTS = setOf(
        "makeArtifact", "lookupArtifact", "disposeArtifact", "focus", "stopFocus", "focusWhenAvailable", "joinWorkspace", "quitWorkspace",
        "createWorkspace",
        "linkArtifacts", "adoptRole", "leaveRole", "commitMission", "leaveMission", "createGroup", "createScheme", "addScheme",
        "goalAchieved",
        "setArgumentValue", "resetGoal", "goalFailed",
    )

    private val KNOWN = OF_ARTIFACTS + OF_TUPLE_SPACES

    /** Internal actions whose names environments often use for actions. */
    private val KEPT = setOf("print", "println", "send", "wait", "date", "time", "random", "count", "suspend", "resume", "perceive", "at",
        "list", "string")
}
