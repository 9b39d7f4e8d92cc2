package argo.check.rules

import argo.check.findings.Finding
import argo.check.findings.Level
import argo.check.project.FilterFile
import argo.check.project.Mention
import argo.check.project.Project
import argo.check.project.Role
import argo.check.syntax.Literal
import argo.check.syntax.StringTerm
import argo.filters.Condition
import argo.filters.PerceptionFilter
import argo.filters.matching.matcher
import argo.filters.matching.warnings
import argo.filters.Rule as FilterRule

/** Checks filter files, their reflexes, and the filters that agents select. */
internal object FilterRules : Rule {
    fun check(project: Project): List<Finding> {
        val isForOtherVersion = project.programs.isEmpty() || project.programs.values.any { program ->
            program.mentions[Role.INTERNAL].any { it.functor.startsWith(".") && ArgoActions.actionIn(it.functor) != null }
        }
        return project.filters.flatMap { file(it, isForOtherVersion) + reflexes(it, project) }
    }

    private fun file(file: FilterFile, isForOtherVersion: Boolean): List<Finding> {
        val why = "argo.change_filter fails, and the previous filter stays"
        val refused = file.problems.map {
            Finding("filter", Level.ERROR, file.place(it.line, it.column), "the filter is refused: ${it.message}", why, "correct it")
        }
        val warnings = file.filter?.warnings().orEmpty().map {
            Finding("filter", Level.WARNING, file.place(1), it, "a part of the filter has no effect", "correct or remove it")
        }
        return refused + warnings + file.text.lines().flatMapIndexed { index, line -> line(file, index + 1, line, isForOtherVersion) }
    }

    private fun line(file: FilterFile, number: Int, line: String, isForOtherVersion: Boolean): List<Finding> = buildList {
        if (isForOtherVersion) DIFFERS.find(line)?.let {
            add(Finding("filter-operator", Level.HINT, file.place(number, it.range.first + 1), "NE means differs",
                "some versions of ARGO read it as equals", "invert the operator if the file relies on that"))
        }
    }

    private fun reflexes(file: FilterFile, project: Project): List<Finding> {
        val actions = project.robot.actions
        if (actions.isEmpty()) return emptyList()
        val unknown = file.filter?.critical.orEmpty().mapNotNull { it.reflex }.distinct()
            .filter { reflex -> actions.none { RobotRules.isFor(it, reflex) } }
        return unknown.map { reflex ->
            val line = file.text.lines().indexOfFirst { reflex in it } + 1
            val meant = SimilarNames.near(reflex.substringBefore('('), actions.map { it.name })
            Finding(
                "reflex", Level.WARNING, file.place(maxOf(line, 1)), "no board of the project has the action $reflex",
                "the reflex does nothing", meant?.let { "did you mean $it?" } ?: "there are ${actions.joinToString()}",
            )
        }
    }

    override fun check(scene: Scene, report: Report) {
        val calls = scene.mentions(Role.INTERNAL).filter {
            ArgoActions.actionIn(it.functor) in setOf("change_filter", "filter") && it.arity == 1
        }
        val own = scene.program.mentions[Role.INTERNAL].toSet()
        calls.filter { it in own }.forEach { missing(it, scene, report) }
        val used = calls.map { call -> nameIn(call)?.let { name -> scene.project.filters.find { it.isCalled(name) }?.filter } }
        if (used.isEmpty() || null in used) return // a filter is unknown, or sometimes no filter is active
        dropped(scene, used.filterNotNull().distinct(), report)
    }

    private fun missing(call: Mention, scene: Scene, report: Report) {
        val name = nameIn(call) ?: return
        if (name == "none" || name == "remove" || scene.project.filters.any { it.isCalled(name) } ||
            name in scene.project.operations) return
        val meant = SimilarNames.near(name, scene.project.filters.map { it.name })
        report.hint(
            "filter-missing", call.literal.arguments.single().span,
            "the project has no file of the filter $name, and no Kotlin source that makes it",
            "argo.change_filter fails, unless it is on the class path", meant?.let { "did you mean $it?" } ?: "put it into filters/",
        )
    }

    private fun nameIn(call: Mention): String? = when (val argument = call.literal.arguments.single()) {
        is Literal -> argument.functor
        is StringTerm -> argument.text
        else -> null
    }

    private fun FilterFile.isCalled(written: String) = written.substringAfterLast('/').let { it == name || it == "${path.fileName}" }

    /** Reports literals that a plan awaits or reads although all [filters] of the agent drop them. */
    private fun dropped(scene: Scene, filters: List<PerceptionFilter>, report: Report) {
        val own = scene.mentions(Role.BELIEVED, Role.TOLD).map { it.functor }.toSet() + Scene.OF_ARGO + setOf("true", "false")
        for (mention in scene.program.mentions[Role.EVENT] + scene.program.mentions[Role.READ]) {
            if (mention.functor in own || !filters.all { drops(it, mention.literal) }) continue
            report.warning(
                "filter-drops", mention.span,
                "${filters.joinToString(" and ") { "filter ${it.name}" }} drops ${mention.literal.indicator}, which this plan waits for",
                "the percept does not reach the agent", "change the filter, or remove the plan",
            )
        }
    }

    private fun drops(filter: PerceptionFilter, literal: Literal): Boolean {
        val values = literal.arguments.map(RobotRules::valueOf)
        val percept = literal.functor + if (values.isEmpty()) "" else values.joinToString(",", "(", ")") { it ?: "0" }
        fun isSure(condition: Condition) =
            condition is Condition.Argument && condition.until == null && values.getOrNull(condition.index) != null
        fun mayMeet(rule: FilterRule) =
            PerceptionFilter("one", FilterRule(rule.predicate, rule.conditions.filter(::isSure), rule.arity)).matcher().drops(percept)
        if (filter.critical.any { mayMeet(it.rule) }) return false
        return when (filter.mode) {
            PerceptionFilter.Mode.DROP -> filter.rules.any { it.rate == null && it.conditions.all(::isSure) && mayMeet(it) }
            PerceptionFilter.Mode.KEEP -> filter.rules.none(::mayMeet)
        }
    }

    private val DIFFERS = Regex("operator\\s*=\\s*[\"']\\s*ne\\s*[\"']", RegexOption.IGNORE_CASE)
}
