package argo.check.rules

import argo.check.findings.Level
import argo.check.syntax.Belief
import argo.check.syntax.Literal
import argo.check.syntax.NumberTerm

/** Finds neighbouring arguments in the reverse of the order that the project uses elsewhere, for the literal or for the variables. */
internal object ArgumentOrderRules : Rule {
    override fun check(scene: Scene, report: Report) {
        val arguments = scene.facts.arguments
        for (inside in arguments.of(scene.program)) {
            for (literal in inside) {
                if (!ofLiteral(literal, inside, arguments, report)) ofVariables(literal, inside, arguments, report)
            }
        }
    }

    private fun ofLiteral(literal: OpenLiteral, inside: List<OpenLiteral>, arguments: Arguments, report: Report): Boolean {
        val columns = arguments.columnsOf(literal)
        val index = (0 until literal.arguments.size - 1).firstOrNull { isSwapped(literal, columns, it) } ?: return false
        val isLikely = !isBothWays(literal, index, inside) && !isStringForVariable(literal, columns, index)
        if (!isSymmetric(literal, index, inside)) tell(literal, index, isLikely, report)
        return true
    }

    /** Reports two neighbouring variables whose order is the reverse in several other plans and rare in this form. */
    private fun ofVariables(literal: OpenLiteral, inside: List<OpenLiteral>, arguments: Arguments, report: Report) {
        val own = inside.flatMap { it.neighbours }.toSet()
        for ((first, second) in literal.neighbours) {
            val other = second to first
            val others = arguments.often(other) - if (other in own) 1 else 0
            if (others + usual(second, first) < maxOf(MIN_PLANS, MANY * (arguments.often(first to second) - 1))) continue
            val index = (0 until literal.arguments.size - 1)
                .first { literal.arguments[it].sign == first && literal.arguments[it + 1].sign == second }
            if (isSymmetric(literal, index, inside)) continue
            report.hint(
                "argument-order", literal.placeOf(index),
                "$second stands in front of $first ${if (others == 0) "mostly" else "in $others other plans"}, and here behind it",
                "the arguments may be those of each other", "correct their order, if it is not meant",
            )
        }
    }

    /**
     * Returns the number of plans that count for a conventional order, such as X and Y, I and J, or X1 and X2. Returns 0 for other orders.
     */
    private fun usual(first: String, second: String): Int {
        val at = first.indices.filter { first[it] != second.getOrNull(it) }.singleOrNull()
        return if (first.length == second.length && at != null && first[at] + 1 == second[at]) MIN_PLANS else 0
    }

    /** Reports swapped arguments, as a warning if [isLikely] and otherwise as a hint. A plan may use both orders or search for a string. */
    private fun tell(literal: OpenLiteral, index: Int, isLikely: Boolean, report: Report) = report.add(
        "argument-order", if (isLikely) Level.WARNING else Level.HINT, literal.placeOf(index),
        "arguments ${index + 1} and ${index + 2} of ${literal.mention.literal.indicator} stand the other way round elsewhere in the " +
            "project",
        "the literal does not match the others", "correct their order",
    )

    /** Returns true if the literal is in a rule that makes a relation symmetric: `near(A,B) :- near(B,A)`. */
    private fun isSymmetric(literal: OpenLiteral, index: Int, inside: List<OpenLiteral>) =
        literal.arguments.size == 2 && isOfHead(literal) && isBothWays(literal, index, inside)

    private fun isOfHead(literal: OpenLiteral) =
        ((literal.component as? Belief)?.head as? Literal)?.indicator == literal.mention.literal.indicator

    /** Returns true if [inside], the surrounding plan or rule, also has these variables in reverse order. */
    private fun isBothWays(literal: OpenLiteral, index: Int, inside: List<OpenLiteral>): Boolean {
        val (first, second) = literal.arguments.drop(index)
        return first.isVariable && second.isVariable && inside.any { other ->
            other !== literal && other.mention.literal.indicator == literal.mention.literal.indicator &&
                other.arguments[index].sign == second.sign && other.arguments[index + 1].sign == first.sign
        }
    }

    private fun isSwapped(literal: OpenLiteral, columns: List<Column>, index: Int): Boolean {
        val (first, second) = literal.arguments.drop(index)
        if (isStringForVariable(literal, columns, index)) return true
        if (!first.isVariable && first.kind != null && first.kind == second.kind) {
            return isNumberedLike(first, columns[index], columns[index + 1]) && isNumberedLike(second, columns[index + 1], columns[index])
        }
        val misplaced = listOf(
            strength(first, columns[index], columns[index + 1], second), strength(second, columns[index + 1], columns[index], first),
        )
        return misplaced.none { it < 0 } && misplaced.sum() >= ENOUGH
    }

    /**
     * Returns true if one argument is the only string in a column of variables, and its neighbour the only variable in a column of strings.
     */
    private fun isStringForVariable(literal: OpenLiteral, columns: List<Column>, index: Int): Boolean {
        val (text, variable) = listOf(index, index + 1).sortedByDescending { literal.arguments[it].isString }
        return literal.arguments[text].isString && literal.arguments[variable].isVariable &&
            columns[text].isOfVariablesButOne && columns[variable].isOfStringsButOne
    }

    /** Returns true if [argument] is numbered like several atoms in the column [there], and is the only such atom in the column [here]. */
    private fun isNumberedLike(argument: Argument, here: Column, there: Column): Boolean {
        val stem = argument.stem ?: return false
        return here.stemsLike(stem) == 1 && there.stemsLike(stem) >= MIN_PLANS
    }

    /**
     * Returns how strongly other literals suggest that [argument], in the column [here], belongs in the column [there] of its [neighbour].
     * A negative result means that [argument] is in the right column. If both columns contain numbers, an equal number suggests nothing:
     * `sum(1,2)`, `sum(2,N)`.
     */
    private fun strength(argument: Argument, here: Column, there: Column, neighbour: Argument): Int {
        val sign = argument.sign ?: return 0
        val same = there.signsLike(sign, neighbour)
        return when {
            here.signsLike(sign, argument) * (if (argument.isShort) MAX else MANY) > same -> AGAINST
            same == 0 || argument.term is NumberTerm && here.kindsLike(argument.kind.orEmpty(), argument) > 0 ->
                strengthOfKind(argument, here, there, neighbour)
            argument.isShort -> ALIKE + maxOf(0, strengthOfKind(argument, here, there, neighbour))
            else -> SAME
        }
    }

    private fun strengthOfKind(argument: Argument, here: Column, there: Column, neighbour: Argument): Int {
        val kind = argument.kind ?: return 0
        return if (here.kindsLike(kind, argument) > 0) AGAINST else if (there.kindsLike(kind, neighbour) > 0) ALIKE else 0
    }

    /** An argument counts as misplaced if the other column has it at least this many times as often. */
    private const val MANY = 5
    private const val MAX = 1_000_000
    private const val AGAINST = -10
    private const val SAME = 2
    private const val ALIKE = 1
    private const val ENOUGH = 2

    /** An order counts as usual if at least this many other plans have it. */
    private const val MIN_PLANS = 2
}
