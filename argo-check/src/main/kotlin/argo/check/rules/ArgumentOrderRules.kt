package argo.check.rules

import argo.check.project.Mention
import argo.check.syntax.Block
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.NumberTerm
import argo.check.syntax.Operation
import argo.check.syntax.Prefixed
import argo.check.syntax.StringTerm
import argo.check.syntax.Term
import argo.check.syntax.Variable

/** Two neighbouring arguments that the rest of the project writes in the other order. */
internal object ArgumentOrderRules : Rule {
    override fun check(scene: Scene, report: Report) {
        val alike = scene.project.programs.values.flatMap { it.mentions.all }.filter(::isOpen).groupBy { it.literal.indicator }
        for (component in scene.program.program.components) {
            val inside = scene.program.mentions.within(component.span).filter(::isOpen)
            inside.forEach { mention(it, alike.getValue(it.literal.indicator), inside, report) }
        }
    }

    /** Returns true for a literal whose arguments neither Jason nor ARGO fixes. */
    private fun isOpen(mention: Mention) =
        mention.arity >= 2 && mention.functor !in InternalAction.ALL && mention.functor !in GoalRules.OF_JASON

    private fun mention(mention: Mention, alike: List<Mention>, inside: List<Mention>, report: Report) {
        val index = swapped(mention, alike.filter { it !== mention }.map { it.literal.arguments }) ?: return
        val (first, second) = mention.literal.arguments.drop(index)
        val isBothWays = first is Variable && second is Variable && inside.any { other ->
            other !== mention && other.literal.indicator == mention.literal.indicator &&
                signOf(other.literal.arguments[index]) == signOf(second) &&
                signOf(other.literal.arguments[index + 1]) == signOf(first)
        }
        if (isBothWays) return
        report.warning(
            "argument-order", first.span + second.span,
            "arguments ${index + 1} and ${index + 2} of ${mention.literal.indicator} stand the other way round elsewhere in the project",
            "the literal does not match the others", "correct their order",
        )
    }

    private fun swapped(mention: Mention, others: List<List<Term>>): Int? =
        mention.literal.arguments.zipWithNext().indices.firstOrNull { index ->
            isSwapped(mention.literal.arguments[index], mention.literal.arguments[index + 1], index, others)
        }

    private fun isSwapped(first: Term, second: Term, index: Int, others: List<List<Term>>): Boolean {
        if (kindOf(first) != null && kindOf(first) == kindOf(second)) return false
        val left = others.map { it[index] }
        val right = others.map { it[index + 1] }
        val misplaced = listOf(strength(first, left, right), strength(second, right, left))
        return misplaced.none { it < 0 } && misplaced.sum() >= ENOUGH
    }

    /** Returns how strongly [term] belongs among the terms [there] rather than [here]; negative: it is in its place. */
    private fun strength(term: Term, here: List<Term>, there: List<Term>): Int {
        val sign = signOf(term) ?: return 0
        val kind = kindOf(term)
        val same = there.count { signOf(it) == sign }
        return when {
            here.count { signOf(it) == sign } * (if (term is Variable && sign.length < LONG) MAX else MANY) > same -> AGAINST
            same > 0 -> if (term is Variable && sign.length < LONG) ALIKE else SAME
            kind == null -> 0
            here.any { kindOf(it) == kind } -> AGAINST
            there.any { kindOf(it) == kind } -> ALIKE
            else -> 0
        }
    }

    /** The kind of a term in one word; null: the term tells nothing. */
    private fun signOf(term: Term): String? = when (term) {
        is Variable -> term.name.text.trimStart('_').ifEmpty { null }
        is Literal -> term.indicator
        is NumberTerm -> term.text
        is StringTerm -> term.text
        else -> kindOf(term)
    }

    private fun kindOf(term: Term): String? = when (term) {
        is Literal -> if (term.isInternal) null else if (term.arity == 0) "atom" else term.indicator
        is NumberTerm -> "number"
        is StringTerm -> "string"
        is ListTerm -> "list"
        is Operation, is Prefixed -> "number"
        is Block -> "block"
        else -> null
    }

    /** A term belongs in another place only if it stands there at least this many times as often as here. */
    private const val MANY = 5
    private const val MAX = 1_000_000
    private const val AGAINST = -10
    private const val SAME = 2
    private const val ALIKE = 1
    private const val ENOUGH = 2

    /** A variable with a shorter name tells little. */
    private const val LONG = 3
}
