package argo.check.syntax

/** A part of a program with its place. [children] are the direct child nodes, in the order of the text. */
sealed interface Node {
    val span: Span
    val children: List<Node> get() = emptyList()
}

/** A term or a formula. */
sealed interface Term : Node

/** Stands for a missing term at an error. */
class Missing(override val span: Span) : Term

/** A name with its place. [text] is the name without quotes. */
class Name(override val span: Span, val text: String) : Node {
    override fun toString(): String = text
}

/** A term that begins with a name or a variable, and may have a namespace and annotations. */
sealed interface Named : Term {
    val namespace: Term?
    val isNegated: Boolean
    val name: Name
    val annotations: ListTerm?
}

/**
 * An atom, a structure, a belief, a goal, an action, `true` or `false`.
 *
 * @property isInternal true if the name has a dot and no quotes, as names of internal actions do
 */
class Literal(
    override val span: Span,
    override val namespace: Term?,
    override val isNegated: Boolean,
    override val name: Name,
    val arguments: List<Term>,
    override val annotations: ListTerm?,
    val isInternal: Boolean,
) : Named {
    override val children: List<Node> get() = listOfNotNull(namespace, name) + arguments + listOfNotNull(annotations)

    val functor: String get() = name.text

    val arity: Int get() = arguments.size

    /** Functor and number of arguments, such as `dist/2`. */
    val indicator: String get() = "$functor/$arity"

    override fun toString(): String = indicator
}

/** A variable. A name that begins with `_` marks an unused value. */
class Variable(
    override val span: Span,
    override val namespace: Term?,
    override val isNegated: Boolean,
    override val name: Name,
    override val annotations: ListTerm?,
) : Named {
    override val children: List<Node> get() = listOfNotNull(namespace, name, annotations)

    override fun toString(): String = name.text
}

/** @property text the digits as written, without a sign */
class NumberTerm(override val span: Span, val text: String) : Term {
    val value: Double get() = text.toDouble()

    override fun toString(): String = text
}

/** @property text the characters between the quotes, with escapes as written */
class StringTerm(override val span: Span, val text: String) : Term {
    override fun toString(): String = "\"$text\""
}

/** @property tail the term behind `|` */
class ListTerm(override val span: Span, val items: List<Term>, val tail: Term?) : Term {
    override val children: List<Node> get() = items + listOfNotNull(tail)
}

/** Operands with [operators] of one rank between them, such as `A + B - C` or `a & b`. There is one more operand than operators. */
class Operation(val operators: List<Token>, val operands: List<Term>) : Term {
    override val span: Span get() = operands.first().span + operands.last().span
    override val children: List<Node> get() = operands

    /** True if all operators are operators on numbers. */
    val isArithmetic: Boolean get() = operators.all { it.text in ARITHMETIC }

    fun isOf(symbol: String): Boolean = operators.all { it.text == symbol }

    private companion object {
        val ARITHMETIC = setOf("+", "-", "*", "/", "div", "mod", "**")
    }
}

/** An operand behind `not`, `+` or `-`. */
class Prefixed(val operator: Token, val operand: Term) : Term {
    override val span: Span get() = operator.span + operand.span
    override val children: List<Node> get() = listOf(operand)
}

/** A term or a formula in parentheses. */
class Bracketed(override val span: Span, val term: Term) : Term {
    override val children: List<Node> get() = listOf(term)
}

/** A term in braces. [content] is a [Body], a [Plan], a [Trigger], or a rule as a [Belief]. */
class Block(override val span: Span, val content: Node) : Term {
    override val children: List<Node> get() = listOf(content)
}
