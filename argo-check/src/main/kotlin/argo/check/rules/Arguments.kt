package argo.check.rules

import argo.check.project.AgentProgram
import argo.check.project.Mention
import argo.check.syntax.Block
import argo.check.syntax.Component
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.NumberTerm
import argo.check.syntax.Operation
import argo.check.syntax.Prefixed
import argo.check.syntax.Span
import argo.check.syntax.StringTerm
import argo.check.syntax.Term
import argo.check.syntax.Variable

/**
 * An argument of a literal.
 *
 * @property sign a word that identifies equal arguments, such as a variable's name, or null if there is none
 * @property kind the argument's kind, such as `a number`, or null if it is not known
 */
internal class Argument(val term: Term, kindsOfVariables: Map<String, String>) {
    val isVariable: Boolean = term is Variable

    val kind: String? = if (term is Variable) kindsOfVariables[term.name.text] else kindOf(term)

    val sign: String? = when (term) {
        is Variable -> term.name.text.trimStart('_').ifEmpty { null }
        is Literal -> term.indicator
        is NumberTerm -> term.text
        is StringTerm -> term.text
        is Operation -> calculated(term) ?: kind
        else -> kind
    }

    /** True for a variable with a short name. Equal short names mean little. */
    val isShort: Boolean = (isVariable || term is Operation && calculated(term) != null) && sign.orEmpty().length < LONG

    /** Returns the only variable in the calculation [term], such as `X` in `X - 1`. Returns null without one or with several. */
    private fun calculated(term: Operation): String? =
        if (term.isArithmetic) term.operands.filterIsInstance<Variable>().singleOrNull()?.name?.text else null

    val isString: Boolean = term is StringTerm

    /** The letters of a numbered atom, such as `post` in `post5`, or null for other terms. */
    val stem: String? = (term as? Literal)?.takeIf { it.arity == 0 }?.let { NUMBERED.matchEntire(it.functor) }?.groupValues?.get(1)

    private fun kindOf(term: Term): String? = when (term) {
        is Literal -> if (term.isInternal) null else if (term.arity == 0) "an atom" else term.indicator
        is NumberTerm, is Operation, is Prefixed -> "a number"
        is StringTerm -> "a string"
        is ListTerm -> "a list"
        is Block -> "a block"
        else -> null
    }

    private companion object {
        const val LONG = 3
        val NUMBERED = Regex("(.*[a-zA-Z_])[0-9]+")
    }
}

/** A literal whose arguments the project defines, not Jason or ARGO. [component] is the plan, rule or belief around it. */
internal class OpenLiteral(val mention: Mention, val component: Component, kindsOfVariables: Map<String, String>) {
    val arguments: List<Argument> = mention.literal.arguments.map { Argument(it, kindsOfVariables) }

    val neighbours: List<Pair<String, String>> get() = arguments.zipWithNext().filter { (a, b) -> a.isVariable && b.isVariable }
        .mapNotNull { (a, b) -> a.sign?.let { first -> b.sign?.let { first to it } } }.filter { (first, second) -> first != second }

    fun placeOf(index: Int): Span = arguments[index].term.span + arguments[index + 1].term.span
}

/** Statistics of all arguments at one position of a literal. */
internal class Column {
    private val signs = HashMap<String, Int>()
    private val kinds = HashMap<String, Int>()
    private val stems = HashMap<String, Int>()
    private var size = 0
    private var variables = 0
    private var strings = 0

    fun add(argument: Argument) {
        size++
        if (argument.isVariable) variables++
        if (argument.isString) strings++
        argument.stem?.let { stems.merge(it, 1, Int::plus) }
        argument.sign?.let { signs.merge(it, 1, Int::plus) }
        argument.kind?.let { kinds.merge(it, 1, Int::plus) }
    }

    /** Returns the number of arguments with [sign] in this column, without [own]. */
    fun signsLike(sign: String, own: Argument): Int = signs.getOrDefault(sign, 0) - if (own.sign == sign) 1 else 0

    /** Returns the number of numbered atoms with the letters [stem]. */
    fun stemsLike(stem: String): Int = stems.getOrDefault(stem, 0)

    /** True if exactly one argument is no variable. */
    val isOfVariablesButOne: Boolean get() = size > 1 && variables == size - 1

    /** True if exactly one argument is no string. */
    val isOfStringsButOne: Boolean get() = size > 1 && strings == size - 1

    /** Returns the number of arguments of [kind] in this column, without [own]. */
    fun kindsLike(kind: String, own: Argument): Int = kinds.getOrDefault(kind, 0) - if (own.kind == kind) 1 else 0
}

internal class Arguments(programs: Collection<AgentProgram>) {
    private val columns = HashMap<String, List<Column>>()
    private val pairs = HashMap<Pair<String, String>, Int>()
    private val literals: Map<AgentProgram, List<List<OpenLiteral>>> = programs.associateWith { literalsIn(it) }

    init {
        for (inside in literals.values.flatten()) {
            inside.forEach { literal -> literal.arguments.zip(columnsOf(literal)).forEach { (argument, column) -> column.add(argument) } }
            inside.flatMap { it.neighbours }.toSet().forEach { pairs.merge(it, 1, Int::plus) }
        }
    }

    /** Returns the open literals of [program], one list for each plan, rule or belief. */
    fun of(program: AgentProgram): List<List<OpenLiteral>> = literals[program] ?: literalsIn(program)

    fun columnsOf(literal: OpenLiteral): List<Column> =
        columns.getOrPut(literal.mention.literal.indicator) { List(literal.arguments.size) { Column() } }

    /** Returns the number of plans, rules and beliefs with these neighbouring variables in this order. */
    fun often(pair: Pair<String, String>): Int = pairs.getOrDefault(pair, 0)

    private fun literalsIn(program: AgentProgram): List<List<OpenLiteral>> = program.program.components.map { component ->
        val open = program.mentions.within(component.span).filter(::isOpen)
        val kinds = if (open.isEmpty()) emptyMap() else kindsIn(component)
        open.map { OpenLiteral(it, component, kinds) }
    }

    private fun kindsIn(component: Component): Map<String, String> =
        KindOfUse.within(component).filter { it.kind != KindOfUse.EITHER }.groupBy({ it.variable }, { it.kind })
            .mapNotNull { (name, kinds) -> kinds.distinct().singleOrNull()?.let { name to InternalAction.WORDS.getValue(it) } }.toMap()

    private fun isOpen(mention: Mention) =
        mention.arity >= 2 && mention.functor !in InternalAction.ALL && mention.functor != GoalRules.SYMMETRIC
}
