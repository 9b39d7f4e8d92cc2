package argo.check.rules

import argo.check.project.BoardAction
import argo.check.project.Mention
import argo.check.project.Role
import argo.check.syntax.Literal
import argo.check.syntax.Node
import argo.check.syntax.NumberTerm
import argo.check.syntax.Operation
import argo.check.syntax.Prefixed
import argo.check.syntax.StringTerm
import argo.check.syntax.Term
import argo.check.syntax.Variable
import argo.check.syntax.withDescendants
import javino.PerceptArgument
import javino.PerceptKind

/** Percepts and values that the robot does not have, and commands that its boards do not know. */
internal object RobotRules : Rule {
    override fun check(scene: Scene, report: Report) {
        if (scene.agents.isNotEmpty() && scene.agents.none { it.isArgo }) return
        if (scene.project.robot.percepts.isNotEmpty()) percepts(scene, report)
        if (scene.project.robot.actions.isNotEmpty()) scene.program.mentions[Role.INTERNAL].forEach { command(it, scene, report) }
    }

    private fun percepts(scene: Scene, report: Report) {
        val kinds = scene.project.robot.percepts.groupBy { it.functor() }
        val own = scene.mentions(Role.BELIEVED, Role.TOLD).map { it.functor }.toSet()
        for (component in scene.program.program.components) {
            val reads = scene.program.mentions.within(component.span).filter { it.role in READS && it.functor !in own }
            val ranges = HashMap<String, PerceptArgument.Quantity>()
            reads.forEach { read -> kinds[read.functor]?.let { percept(read, it, ranges, report) } }
            comparisons(component, ranges, report)
        }
        val hasEnvironment = scene.project.masFiles.any { it.environment != null }
        if (scene.project.robot.isComplete && !hasEnvironment && scene.agents.any { it.isArgo }) unknown(scene, kinds.keys, own, report)
    }

    /** Reports a belief that no board, plan or message of the project produces. */
    private fun unknown(scene: Scene, kinds: Set<String>, own: Set<String>, report: Report) {
        val tests = scene.mentions(Role.TEST_HANDLED).map { it.functor }.toSet()
        val names = Names(kinds + own)
        for (read in listOf(Role.EVENT, Role.READ).flatMap { scene.program.mentions[it] }) {
            if (read.functor in kinds || read.functor in own || read.functor in tests || scene.isKnownElsewhere(read) ||
                names.near(read.functor) != null) continue
            report.warning(
                "percept-unknown", read.span,
                "no board of the project has the percept ${read.literal.indicator}, and no agent believes or sends it",
                "it is never true, and causes no event", "the boards have ${kinds.joinToString()}",
            )
        }
    }

    private fun percept(read: Mention, kinds: List<PerceptKind>, ranges: MutableMap<String, PerceptArgument.Quantity>, report: Report) {
        val alike = kinds.filter { it.arguments().size == read.arity }
        if (alike.isEmpty()) {
            report.warning(
                "percept-arity", read.span, "the board has ${kinds.joinToString()}, and here ${read.functor} has ${read.arity} arguments",
                WHY, "correct the arguments",
            )
            return
        }
        read.literal.arguments.forEachIndexed { index, argument ->
            val described = alike.map { it.arguments()[index] }
            val value = valueOf(argument)
            val wrong = if (value == null) null else described.map { it.deviationOf(value).orElse(null) ?: return@forEachIndexed }.first()
            if (wrong != null) {
                report.warning("percept-value", argument.span,
                    "argument ${index + 1} of ${read.functor} is $value, $wrong: the board has ${alike.joinToString()}", WHY, "correct it")
            }
            val range = described.singleOrNull() as? PerceptArgument.Quantity
            if (argument is Variable && range != null) ranges[argument.name.text] = range
        }
    }

    /** Reports comparisons whose result a described range fixes: with L in `0..100`, `light(_,L) & L > 100` is never true. */
    private fun comparisons(component: Node, ranges: Map<String, PerceptArgument.Quantity>, report: Report) {
        if (ranges.isEmpty()) return
        component.withDescendants().filterIsInstance<Operation>().filter { it.operators.size == 1 }.forEach { comparison ->
            val (left, right) = comparison.operands
            val operator = comparison.operators.single().text
            outcome(left, operator, right, ranges)?.let { decided(comparison, left, it, ranges, report) }
                ?: outcome(right, MIRRORED[operator] ?: operator, left, ranges)?.let { decided(comparison, right, it, ranges, report) }
        }
    }

    private fun decided(comparison: Operation, variable: Term, outcome: Boolean, ranges: Map<String, PerceptArgument.Quantity>,
        report: Report) {
        val range = ranges.getValue((variable as Variable).name.text)
        val what = "${variable.name} is $range as the board describes it, so that this is ${if (outcome) "always" else "never"} true"
        if (outcome) report.hint("percept-range", comparison.span, what, "the comparison decides nothing",
            "compare with a number in the range")
        else report.warning("percept-range", comparison.span, what, WHY, "compare with a number in the range")
    }

    private fun outcome(variable: Term, operator: String, bound: Term, ranges: Map<String, PerceptArgument.Quantity>): Boolean? {
        val range = ranges[(variable as? Variable)?.name?.text] ?: return null
        val number = valueOf(bound)?.toBigDecimalOrNull() ?: return null
        val min = range.min().map { it.compareTo(number) }.orElse(null)
        val max = range.max().map { it.compareTo(number) }.orElse(null)
        return when (operator) {
            ">" -> if (max != null && max <= 0) false else if (min != null && min > 0) true else null
            ">=" -> if (max != null && max < 0) false else if (min != null && min >= 0) true else null
            "<" -> if (min != null && min >= 0) false else if (max != null && max < 0) true else null
            "<=" -> if (min != null && min > 0) false else if (max != null && max <= 0) true else null
            "==", "=" -> if (min != null && min > 0 || max != null && max < 0) false else null
            else -> null
        }
    }

    private fun command(call: Mention, scene: Scene, report: Report) {
        if (ArgoActions.actionIn(call.functor) != "act") return
        val command = call.literal.arguments.firstOrNull() ?: return
        val text = commandIn(command) ?: return
        val actions = scene.project.robot.actions
        if (actions.any { isFor(it, text) }) return
        val name = text.substringBefore('(')
        val same = actions.filter { it.name == name }
        val meant = Names.near(name, actions.map { it.name }.distinct())
        val remedy = when {
            same.isNotEmpty() -> "there is ${same.joinToString()}"
            meant != null -> "did you mean $meant?"
            else -> "there are ${actions.distinct().joinToString()}"
        }
        report.warning(
            "action-unregistered", command.span, "no board of the project has the action $command",
            "argo.act fails with error(act_refused)", remedy,
        )
    }

    private fun commandIn(term: Term): String? = when {
        term is StringTerm -> term.text
        term !is Literal || term.isInternal -> null
        term.arity == 0 -> term.functor
        else -> term.functor + List(term.arity) { "_" }.joinToString(",", "(", ")")
    }

    fun isFor(action: BoardAction, text: String): Boolean {
        val name = text.substringBefore('(').trim()
        val arguments = text.substringAfter('(', "").substringBeforeLast(')')
        return name == action.name &&
            (action.arity == null || action.arity == if (arguments.isBlank()) 0 else arguments.count { it == ',' } + 1)
    }

    /** Returns the text of a constant as percepts have it; null: [term] is no constant. */
    fun valueOf(term: Term): String? = when (term) {
        is NumberTerm -> term.text
        is Literal -> term.functor.takeIf { term.arity == 0 && !term.isInternal }
        is StringTerm -> "\"${term.text}\""
        is Prefixed -> (term.operand as? NumberTerm)?.let { term.operator.text + it.text }?.removePrefix("+")
        else -> null
    }

    private val READS = listOf(Role.READ, Role.EVENT, Role.DELETED)
    private val MIRRORED = mapOf("<" to ">", ">" to "<", "<=" to ">=", ">=" to "<=")
    private const val WHY = "it is never true, and causes no event"
}
