package argo.check.syntax

/**
 * Returns an error for each term in [components] that Jason's parser refuses as an operand, a formula or a step. In a program with
 * registered functions or includes, any literal can be a number.
 */
internal fun operandErrors(components: List<Component>): List<SyntaxError> {
    val nodes = components.flatMap { it.withDescendants() }
    val hasFunctions = nodes.any { it is Directive && it.call?.functor in REGISTRATIONS }
    return nodes.flatMap { node ->
        when (node) {
            is Formula -> step(node)
            is Operation -> operands(node, hasFunctions)
            is Prefixed -> listOf(node.operand).let { if (node.operator.isKeyword("not")) formulas(it) else numbers(it, hasFunctions) }
            is Plan -> formulas(listOfNotNull(node.context))
            is Belief -> formulas(listOfNotNull(node.condition))
            else -> emptyList()
        }
    }
}

private fun step(formula: Formula): List<SyntaxError> =
    if (formula.operator == BodyOperator.DO && isConstant(formula.term)) listOf(refusal(formula.term, "no step of a plan")) else emptyList()

private fun operands(operation: Operation, hasFunctions: Boolean): List<SyntaxError> = when {
    operation.isArithmetic -> numbers(operation.operands, hasFunctions)
    operation.operators.all { it.text == "&" || it.text == "|" } -> formulas(operation.operands)
    else -> emptyList()
}

private fun numbers(operands: List<Term>, hasFunctions: Boolean): List<SyntaxError> =
    operands.filter { it is StringTerm || it is Literal && !it.isInternal && !hasFunctions }.map { refusal(it, "no number") }

private fun formulas(operands: List<Term>): List<SyntaxError> = operands.filter(::isConstant).map { refusal(it, "no formula") }

private fun isConstant(term: Term): Boolean = when (term) {
    is NumberTerm, is StringTerm -> true
    is Bracketed -> isConstant(term.term)
    else -> false
}

private fun refusal(term: Term, what: String) = SyntaxError(term.span, "this is $what")

private val REGISTRATIONS = setOf("register_function", "include")
