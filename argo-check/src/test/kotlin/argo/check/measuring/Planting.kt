package argo.check.measuring

import argo.check.project.AgentProgram
import argo.check.project.Mention
import argo.check.project.Role
import argo.check.syntax.Belief
import argo.check.syntax.Literal
import argo.check.syntax.Plan
import argo.check.syntax.Span
import argo.check.syntax.Variable
import argo.check.syntax.withDescendants
import kotlin.random.Random

/** A planted fault: [text] replaces the text of [span]. */
class Fault(val kind: String, val program: AgentProgram, val span: Span, val text: String, val description: String) {
    val line: Int get() = program.program.lines.position(span.start).line

    val written: String get() = program.program.text.substring(span.start, span.end)

    val planted: String get() = program.program.text.replaceRange(span.start, span.end, text)
}

/**
 * Plants typing errors: a letter is missing, doubled, replaced by a neighbouring key or swapped with the next letter. Also swaps arguments.
 */
class Planting(private val random: Random) {
    fun next(bound: Int): Int = random.nextInt(bound)

    fun faultIn(program: AgentProgram): Fault? {
        val sites = names(program) + variables(program) + swaps(program)
        return sites.randomOrNull(random)?.invoke()
    }

    /** Leaves out names of tests, since a changed test name has no effect. */
    private fun names(program: AgentProgram): List<() -> Fault?> = program.mentions.all
        .filter { it.role != Role.DATA && it.span.start !in program.goalsOfTests && it.functor.length >= MIN_LENGTH &&
            it.functor.all { letter -> letter.isLetterOrDigit() || letter in "_." } }
        .map { { misspelt(kindOf(it), program, it.span, it.functor) } }

    private fun kindOf(mention: Mention) = when (mention.role) {
        Role.POSTED, Role.HANDLED, Role.FAILURE_HANDLED, Role.SENT_GOAL, Role.NAMED_GOAL -> "goal"
        Role.ACTION -> "action"
        Role.INTERNAL -> "internal action"
        else -> "belief"
    }

    /** Leaves out variables that occur once, since their names have no effect. */
    private fun variables(program: AgentProgram): List<() -> Fault?> = program.program.components
        .filter { it is Plan || it is Belief && it.condition != null }.flatMap { clause ->
            val all = clause.withDescendants().filterIsInstance<Variable>().filter { it.name.text.length >= MIN_LENGTH &&
                it.name.text[0] != '_' }.toList()
            val often = all.groupingBy { it.name.text }.eachCount()
            all.filter { often.getValue(it.name.text) > 1 }.map { { misspelt("variable", program, it.name.span, it.name.text) } }
        }

    private fun swaps(program: AgentProgram): List<() ->
    Fault?> = program.mentions.all.filter { it.arity >= 2 && it.functor !in FREE }.map { mention ->
        { swap(program, mention.literal) }
    }

    private fun swap(program: AgentProgram, literal: Literal): Fault? {
        val text = program.program.text
        fun of(index: Int) = literal.arguments[index].span.let { text.substring(it.start, it.end) }
        val pairs = (0 until literal.arity - 1).filter { of(it) != of(it + 1) }
        val first = pairs.randomOrNull(random) ?: return null
        if (literal.arguments[first] is Variable && literal.arguments[first + 1] is Variable &&
            (of(first)[0] == '_' || of(first + 1)[0] == '_')) return null
        val span = literal.arguments[first].span + literal.arguments[first + 1].span
        val between = text.substring(literal.arguments[first].span.end, literal.arguments[first + 1].span.start)
        return Fault(SWAP, program, span, of(first + 1) + between + of(first),
            "${literal.indicator}: ${of(first)}, ${of(first + 1)}")
    }

    private fun misspelt(kind: String, program: AgentProgram, span: Span, name: String): Fault? {
        val wrong = slip(name)
        val words = program.program.tokens.map { it.text }.toSet()
        if (wrong == name || wrong in words) return null
        return Fault(kind, program, span, wrong, "$name -> $wrong")
    }

    private fun slip(name: String): String {
        val at = random.nextInt(1, name.length) // the first letter decides the kind of a name
        return when (random.nextInt(4)) {
            0 -> name.removeRange(at, at + 1)
            1 -> name.substring(0, at) + name[at] + name.substring(at)
            2 -> name.replaceRange(at, at + 1, "${neighbour(name[at])}")
            else -> if (at + 1 < name.length) name.substring(0, at) + name[at + 1] + name[at] + name.substring(at + 2) else name.dropLast(1)
        }
    }

    private fun neighbour(letter: Char): Char {
        val row = ROWS.firstOrNull { letter.lowercaseChar() in it } ?: return letter
        val at = row.indexOf(letter.lowercaseChar())
        val next = row[if (at + 1 < row.length) at + 1 else at - 1]
        return if (letter.isUpperCase()) next.uppercaseChar() else next
    }

    companion object {
        const val SWAP = "swapped arguments"
        private const val MIN_LENGTH = 3
        private val ROWS = listOf("qwertyuiop", "asdfghjkl", "zxcvbnm")

        /** Leaves out literals whose arguments have no order, or an order that only their reader knows. */
        private val FREE = setOf(
            ".print", ".println", ".concat", ".union", ".intersection", ".log", ".printf", ".fail", ".max", ".min", "assert_equals",
        )
    }
}
