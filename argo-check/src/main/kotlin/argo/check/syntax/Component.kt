package argo.check.syntax

/** A part of a program that ends with a full stop, or a directive. */
sealed interface Component : Node

/** @property components the components between `{ begin … }` and `{ end }`, or null for other directives, such as `{ include("a.asl") }` */
class Directive(override val span: Span, val call: Literal?, val components: List<Component>?) : Component {
    override val children: List<Node> get() = listOfNotNull(call) + components.orEmpty()
}

/** Returns the plans, beliefs and rules in [component]. Each has its own variable scope. */
internal fun clauses(component: Component): List<Component> = when (component) {
    is Directive -> component.components.orEmpty().flatMap(::clauses)
    is Plan, is Belief -> listOf(component)
    else -> emptyList()
}

/** A belief, or a rule if it has a [condition]. */
class Belief(override val span: Span, val head: Term, val condition: Term?) : Component {
    override val children: List<Node> get() = listOfNotNull(head, condition)
}

/** An initial goal of the agent. */
class InitialGoal(override val span: Span, val goal: Term) : Component {
    override val children: List<Node> get() = listOf(goal)
}

/**
 * A plan.
 *
 * @property goalCondition the formula behind `<:`
 * @property plans the plans in braces behind the plan's full stop
 */
class Plan(
    override val span: Span,
    val label: Label?,
    val trigger: Trigger,
    val context: Term?,
    val goalCondition: Term?,
    val body: Body?,
    val plans: List<Plan>,
) : Component {
    override val children: List<Node> get() = listOfNotNull(label, trigger, context, goalCondition, body) + plans
}

/** Text of unknown meaning, which the reader skipped after an error. */
class Unread(override val span: Span) : Component

/** The name and the annotations of a plan, `@p1[atomic]`. A plan in braces may have a variable as its name. */
class Label(override val span: Span, val name: Name?, val annotations: ListTerm?) : Node {
    override val children: List<Node> get() = listOfNotNull(name, annotations)
}

/** The kinds of events, and their symbols in triggers. */
enum class EventKind(val symbol: String) { BELIEF(""), ACHIEVE("!"), TEST("?") }

/** @property operator `+`, `-` or `^` */
class Trigger(override val span: Span, val operator: String, val kind: EventKind, val term: Term) : Node {
    override val children: List<Node> get() = listOf(term)
}

/** The statements of a plan's body. */
class Body(override val span: Span, val statements: List<Statement>) : Node {
    override val children: List<Node> get() = statements
}

/** A step of a plan's body. */
sealed interface Statement : Node

/** The use of a term in a statement. */
enum class BodyOperator(val symbol: String) {
    /** An action, an internal action, a comparison, or a term whose value is a body. */
    DO(""),
    ACHIEVE("!"), ACHIEVE_APART("!!"), TEST("?"), ADD("+"), ADD_APART("++"), ADD_FIRST("+<"), ADD_LAST("+>"), DELETE("-"), REPLACE("-+"),
    DELETE_APART("--"),
    ;

    /** True if the operator adds a belief. */
    val adds: Boolean get() = this == REPLACE || symbol.startsWith("+")

    /** True if the statement deletes a belief without replacing it by another. */
    val deletes: Boolean get() = this == DELETE || this == DELETE_APART
}

class Formula(override val span: Span, val operator: BodyOperator, val term: Term) : Statement {
    override val children: List<Node> get() = listOf(term)
}

/** A body in parentheses, as in `(a; b)`. */
class Group(override val span: Span, val body: Body) : Statement {
    override val children: List<Node> get() = listOf(body)
}

/** Statements that run concurrently, `a |&| b` or `a ||| b`. */
class Parallel(override val span: Span, val branches: List<Statement>) : Statement {
    override val children: List<Node> get() = branches
}

/** One branch of an `if`. */
class Branch(override val span: Span, val condition: Term, val body: Body) : Node {
    override val children: List<Node> get() = listOf(condition, body)
}

/** `if`, `elif` and `else`. */
class If(override val span: Span, val branches: List<Branch>, val otherwise: Body?) : Statement {
    override val children: List<Node> get() = branches + listOfNotNull(otherwise)
}

/** `for` or `while`. */
class Loop(override val span: Span, val keyword: String, val condition: Term, val body: Body) : Statement {
    override val children: List<Node> get() = listOf(condition, body)
}
