package argo.check.rules

import argo.check.findings.Level
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
import javino.PerceptTerm

/** Finds percepts and values that the robot does not have, and commands that its boards do not accept. */
internal object RobotRules : Rule {
    override fun check(scene: Scene, report: Report) {
        if (scene.agents.isNotEmpty() && scene.agents.none { it.isArgo }) return
        if (scene.project.robot.percepts.isNotEmpty()) percepts(scene, report)
        if (scene.project.robot.actions.isNotEmpty()) scene.program.program.components.forEach { commands(it, scene, report) }
    }

    private fun percepts(scene: Scene, report: Report) {
        val kinds = scene.project.robot.percepts.groupBy { it.functor() }
        val own = scene.mentions(Role.BELIEVED, Role.TOLD).map { it.functor }.toSet()
        for (component in scene.program.program.components) {
            val reads = scene.program.mentions.within(component.span).filter { it.role in READS && it.functor !in own }
            val ranges: Ranges = HashMap()
            reads.forEach { read -> kinds[read.functor]?.let { percept(read, it, ranges, scene, report) } }
            comparisons(component, ranges, report)
        }
        val hasEnvironment = scene.project.masFiles.any { it.environment != null }
        if (scene.project.robot.isComplete && !hasEnvironment && scene.agents.any { it.isArgo }) unknown(scene, kinds.keys, own, report)
    }

    private fun unknown(scene: Scene, kinds: Set<String>, own: Set<String>, report: Report) {
        val tests = scene.mentions(Role.TEST_HANDLED).map { it.functor }.toSet()
        val names = SimilarNames(kinds + own)
        for (read in listOf(Role.EVENT, Role.READ).flatMap { scene.program.mentions[it] }) {
            if (read.functor in kinds || read.functor in own || read.functor in tests || scene.isKnownElsewhere(read) ||
                names.near(read.functor) != null) continue
            report.add(
                "percept-unknown", if (scene.project.robot.observed.isEmpty()) Level.WARNING else Level.HINT, read.span,
                "no board of the project has the percept ${read.literal.indicator}, and no agent believes or sends it",
                "it is never true, and causes no event", "the boards have ${kinds.joinToString()}",
            )
        }
    }

    private fun percept(read: Mention, kinds: List<PerceptKind>, ranges: Ranges, scene: Scene, report: Report) {
        val level = if (kinds.all(scene.project.robot.observed::contains)) Level.HINT else Level.WARNING
        val alike = kinds.filter { it.arguments().size == read.arity }
        if (alike.isEmpty()) {
            report.add(
                "percept-arity", level, read.span,
                "the board has ${kinds.joinToString()}, and here ${read.functor} has ${read.arity} arguments", WHY, "correct the arguments",
            )
            return
        }
        read.literal.arguments.forEachIndexed { index, argument ->
            val described = alike.map { it.arguments()[index] }
            val value = valueOf(argument)
            val wrong = if (value == null) null else described.map { it.deviationOf(value).orElse(null) ?: return@forEachIndexed }.first()
            if (wrong != null) {
                report.add("percept-value", level, argument.span,
                    "argument ${index + 1} of ${read.functor} is $value, $wrong: the board has ${alike.joinToString()}", WHY, "correct it")
            }
            val range = described.singleOrNull() as? PerceptArgument.Quantity
            if (argument is Variable && range != null) ranges[argument.name.text] = KnownRange(range, level)
        }
    }

    /**
     * Reports comparisons that are always true or always false in the known range. With L in `0..100`, `light(_,L) & L > 100` is always
     * false.
     */
    private fun comparisons(component: Node, ranges: Ranges, report: Report) {
        if (ranges.isEmpty()) return
        component.withDescendants().filterIsInstance<Operation>().filter { it.operators.size == 1 }.forEach { comparison ->
            val (left, right) = comparison.operands
            val operator = comparison.operators.single().text
            outcome(left, operator, right, ranges)?.let { decided(comparison, left, it, ranges, report) }
                ?: outcome(right, MIRRORED[operator] ?: operator, left, ranges)?.let { decided(comparison, right, it, ranges, report) }
        }
    }

    private fun decided(comparison: Operation, variable: Term, outcome: Boolean, ranges: Ranges, report: Report) {
        val (range, level) = ranges.getValue((variable as Variable).name.text)
        val origin = if (level == Level.HINT) "was observed" else "the board describes it"
        val what = "${variable.name} is $range as $origin, so that this is ${if (outcome) "always" else "never"} true"
        val why = if (outcome) "the comparison decides nothing" else WHY
        report.add("percept-range", if (outcome) Level.HINT else level, comparison.span, what, why, "compare with a number in the range")
    }

    /** Returns the constant result of the comparison, or null if the result depends on the value. */
    private fun outcome(variable: Term, operator: String, bound: Term, ranges: Ranges): Boolean? {
        val range = ranges[(variable as? Variable)?.name?.text]?.range ?: return null
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

    /** Checks commands. A plan that calls `argo.can(Action)` may send an action that some boards lack. */
    private fun commands(component: Node, scene: Scene, report: Report) {
        val calls = scene.program.mentions.within(component.span).filter { it.role == Role.INTERNAL }
        val asked = calls.filter { ArgoActions.actionIn(it.functor) == "can" }.mapNotNull { it.literal.arguments.firstOrNull() }
        if (asked.any { it is Variable }) return
        val names = asked.map { (it as? Literal)?.functor }
        calls.filter { ArgoActions.actionIn(it.functor) == "act" && (it.literal.arguments.firstOrNull() as? Literal)?.functor !in names }
            .forEach { command(it, scene, report) }
    }

    private fun command(call: Mention, scene: Scene, report: Report) {
        val command = call.literal.arguments.firstOrNull() ?: return
        val text = commandIn(command) ?: return
        val actions = scene.project.robot.actions
        if (actions.any { isFor(it, text) }) return
        val name = text.substringBefore('(')
        val same = actions.filter { it.name == name }
        val meant = SimilarNames.near(name, actions.map { it.name }.distinct())
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
        term is StringTerm -> term.text.replace("\\\"", "\"")
        term !is Literal || term.isInternal -> null
        term.arity == 0 -> term.functor
        else -> term.functor + List(term.arity) { "_" }.joinToString(",", "(", ")")
    }

    fun isFor(action: BoardAction, text: String): Boolean = PerceptTerm.of(text).let {
        it.functor() == action.name && (action.arity == null || action.arity == it.arguments().size)
    }

    /** Returns the text that a board gets for [command], or null if [command] has variables or structures. */
    fun textOf(command: Term): String? = when {
        command is StringTerm -> if ('\\' in command.text) null else command.text
        command !is Literal || command.isInternal || command.annotations != null -> null
        command.arity == 0 -> command.functor
        else -> command.arguments.map { valueOf(it) ?: return null }.joinToString(",", "${command.functor}(", ")")
    }

    /** Returns the text of the constant [term] in percepts, or null for other terms. */
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

/** @property level the level of findings about values outside the range */
private data class KnownRange(val range: PerceptArgument.Quantity, val level: Level)

private typealias Ranges = HashMap<String, KnownRange>
