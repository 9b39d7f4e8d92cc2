package argo.check.project

import argo.check.syntax.Belief
import argo.check.syntax.Block
import argo.check.syntax.Body
import argo.check.syntax.BodyOperator
import argo.check.syntax.Bracketed
import argo.check.syntax.Component
import argo.check.syntax.Directive
import argo.check.syntax.EventKind
import argo.check.syntax.Formula
import argo.check.syntax.Group
import argo.check.syntax.If
import argo.check.syntax.InitialGoal
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.Loop
import argo.check.syntax.Node
import argo.check.syntax.Operation
import argo.check.syntax.Parallel
import argo.check.syntax.Plan
import argo.check.syntax.Prefixed
import argo.check.syntax.Span
import argo.check.syntax.Statement
import argo.check.syntax.Term
import argo.check.syntax.Trigger
import argo.check.syntax.Unread
import argo.check.syntax.Variable

internal class MentionReader {
    private val found = ArrayList<Mention>()

    /** The roles in which the program uses a variable as a literal. The literals of these roles are not all known. */
    private val open = HashSet<Role>()

    fun read(components: List<Component>): Mentions {
        components.forEach(::component)
        return Mentions(found, open)
    }

    private fun component(component: Component) {
        when (component) {
            is Directive -> component.components?.forEach(::component)
            is Belief -> rule(component)
            is InitialGoal -> mention(Role.POSTED, component.goal)
            is Plan -> plan(component)
            is Unread -> {}
        }
    }

    private fun rule(rule: Belief) {
        mention(Role.BELIEVED, rule.head)
        rule.condition?.let(::formula)
    }

    private fun plan(plan: Plan) {
        mention(roleOf(plan.trigger), plan.trigger.term)
        rest(plan)
    }

    private fun rest(plan: Plan) {
        plan.context?.let(::formula)
        plan.goalCondition?.let(::formula)
        plan.body?.let(::body)
        plan.plans.forEach(::plan)
    }

    private fun roleOf(trigger: Trigger): Role = when {
        trigger.kind == EventKind.ACHIEVE && trigger.operator == "+" -> Role.HANDLED
        trigger.kind == EventKind.ACHIEVE -> Role.FAILURE_HANDLED
        trigger.kind == EventKind.TEST -> Role.TEST_HANDLED
        else -> Role.EVENT
    }

    /**
     * Reads an event in braces. [role] depends on the action: some post the event, as in `.at("now", { +!g })`, others only wait for it.
     */
    private fun event(trigger: Trigger, role: Role) {
        val isMade = role == Role.POSTED || role == Role.BELIEVED
        when {
            trigger.term is Variable -> {}
            trigger.kind == EventKind.ACHIEVE -> mention(if (isMade) Role.POSTED else Role.NAMED_GOAL, trigger.term)
            trigger.kind == EventKind.TEST -> mention(Role.DATA, trigger.term)
            else -> mention(if (isMade) Role.BELIEVED else Role.EVENT, trigger.term)
        }
    }

    private fun body(body: Body) = body.statements.forEach(::statement)

    private fun statement(statement: Statement) {
        when (statement) {
            is Formula -> step(statement.operator, statement.term)
            is Group -> body(statement.body)
            is Parallel -> statement.branches.forEach(::statement)
            is If -> {
                statement.branches.forEach {
                    formula(it.condition)
                    body(it.body)
                }
                statement.otherwise?.let(::body)
            }
            is Loop -> {
                formula(statement.condition)
                body(statement.body)
            }
        }
    }

    private fun step(operator: BodyOperator, term: Term) {
        when {
            term is Block -> content(term, Role.BELIEVED)
            operator == BodyOperator.ACHIEVE || operator == BodyOperator.ACHIEVE_APART -> mention(Role.POSTED, term)
            operator == BodyOperator.TEST -> formula(term)
            operator.adds -> mention(Role.BELIEVED, term)
            operator.deletes -> mention(Role.DELETED, term)
            term is Literal && term.isInternal -> call(term)
            term is Literal -> mention(Role.ACTION, term)
            else -> data(term)
        }
    }

    /** Reads a formula, whose literals are queries of the belief base. */
    private fun formula(term: Term) {
        when {
            term is Operation && (term.isOf("&") || term.isOf("|")) -> term.operands.forEach(::formula)
            term is Prefixed && term.operator.isKeyword("not") -> formula(term.operand)
            term is Bracketed -> formula(term.term)
            term is Literal && term.isInternal -> call(term)
            term is Literal -> mention(Role.READ, term)
            term is Variable -> {
                open += Role.READ
                term.annotations?.let(::data)
            }
            else -> data(term)
        }
    }

    private fun call(call: Literal) {
        found += Mention(Role.INTERNAL, call)
        val special = SpecialArguments.of(call)
        call.arguments.forEachIndexed { index, argument ->
            when (val role = special[index]) {
                null -> data(argument)
                Role.READ -> formula(argument)
                Role.EVENT -> if (argument is Block) awaited(argument) else formula(argument)
                else -> if (argument is Block) content(argument, role) else mention(role, argument)
            }
        }
        call.annotations?.let(::data)
    }

    private fun data(node: Node) {
        when (node) {
            is Literal -> if (node.isInternal) call(node) else mention(Role.DATA, node)
            is Block -> content(node, Role.DATA)
            else -> node.children.forEach(::data)
        }
    }

    private fun content(block: Block, role: Role) {
        when (val content = block.content) {
            is Body -> body(content)
            is Plan -> if (role == Role.DATA) pattern(content) else plan(content)
            is Belief -> rule(content)
            is Trigger -> event(content, role)
            else -> {}
        }
    }

    private fun awaited(block: Block) {
        val step = (block.content as? Body)?.statements?.singleOrNull() as? Formula
        if (step == null) content(block, Role.EVENT) else mention(Role.EVENT, step.term)
    }

    /** Reads a plan that serves as a search pattern or another argument. */
    private fun pattern(plan: Plan) {
        event(plan.trigger, Role.DATA)
        rest(plan)
    }

    private fun mention(role: Role, term: Term) {
        when (term) {
            is Literal -> {
                found += Mention(role, term)
                term.arguments.forEach(::data)
                term.annotations?.let(::data)
                term.namespace?.let { if (it is Variable) open += role }
            }
            is Variable -> open += role
            is ListTerm -> term.items.forEach { mention(role, it) }
            is Bracketed -> if (role == Role.DATA) data(term.term) else formula(term.term)
            else -> data(term)
        }
    }
}

/** @property open the roles in which the program uses a variable as a literal. The literals of these roles are not all known */
class Mentions(val all: List<Mention>, val open: Set<Role>) {
    private val byRole: Map<Role, List<Mention>> = all.groupBy { it.role }

    private val inOrder: List<Mention> by lazy { all.sortedBy { it.span.start } }

    /** Returns the mentions that begin in [span] or at its end, in the order of the text. */
    internal fun within(span: Span): List<Mention> = inOrder.subList(indexOf(span.start), indexOf(span.end + 1))

    private fun indexOf(offset: Int): Int = inOrder.binarySearch { if (it.span.start < offset) -1 else 1 }.inv()

    operator fun get(role: Role): List<Mention> = byRole[role].orEmpty()
}
