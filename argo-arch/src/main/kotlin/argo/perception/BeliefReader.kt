package argo.perception

import argo.filters.foreignText
import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import argo.filters.matching.INFINITE
import argo.filters.matching.hasComment
import argo.filters.matching.piecesOf
import argo.filters.matching.whyClaimed
import argo.filters.matching.whyUnreadable
import jason.asSemantics.Unifier
import jason.asSyntax.ArithExpr
import jason.asSyntax.ArithFunctionTerm
import jason.asSyntax.Atom
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.Literal
import jason.asSyntax.NumberTerm
import jason.asSyntax.Term

/**
 * Turns the text of a percept into the literal for the agent's beliefs.
 *
 * A text that Jason cannot read, or that makes no sense as a percept, is left out. Each distinct text causes one warning. Literals are
 * cached and reused, since Jason copies a literal when it adds the literal to a belief base. Not safe for use by several threads at once.
 *
 * @param namespace the namespace of the percepts; if null, each percept has the namespace in its text, mostly the default one
 * @param warn logs one line for each text that is left out
 */
internal class BeliefReader(private val namespace: Atom? = null, private val warn: (String) -> Unit) {
    private val known = object : LinkedHashMap<String, Reading>(16, 0.75f, true) {
        override fun removeEldestEntry(eldest: Map.Entry<String, Reading>) = size > room
    }
    private var room = MIN_CACHED
    private val reported = HashSet<String>()

    /** Sets the size of the cache for messages with [percepts] percepts. Older percepts leave the cache. */
    fun expect(percepts: Int) {
        room = (2 * percepts).coerceIn(MIN_CACHED, MAX_CACHED)
    }

    /**
     * Returns the literal of [percept]. Returns none if it is left out, and several if a stray quote or bracket had joined several
     * percepts.
     */
    fun read(percept: String): List<Literal> = when (val reading = known[percept] ?: parsed(percept)) {
        is Reading.Belief -> listOf(reading.literal)
        is Reading.Unreadable -> {
            val pieces = piecesOf(percept)
            if (pieces.size > 1) pieces.flatMap(::read) else emptyList<Literal>().also { report(percept, reading.why) }
        }
    }

    private fun parsed(percept: String) = parse(percept).placed().also { if (percept.length <= MAX_CACHED_LENGTH) known[percept] = it }

    private fun Reading.placed() =
        if (namespace != null && this is Reading.Belief) Reading.Belief(literal.cloneNS(namespace) as Literal) else this

    private fun report(percept: String, why: String) {
        if (reported.size > MAX_REPORTED || !reported.add(foreignText(percept))) return
        if (reported.size > MAX_REPORTED) warn("further percepts that cannot be read are not reported")
        else warn("percept ${foreignText(percept)} is left out: $why")
    }

    private companion object {
        const val MIN_CACHED = 128
        const val MAX_CACHED = 4096
        const val MAX_REPORTED = 100

        /** Longer texts are not cached, since 4096 of the longest messages would fill the heap of a small computer. */
        const val MAX_CACHED_LENGTH = 1024
    }
}

/**
 * Explains why an agent leaves out the percept with the text [percept]; null if the agent believes it. Any thread may call this function.
 */
fun whyLeftOut(percept: String): String? = (parse(percept) as? Reading.Unreadable)?.why

private sealed interface Reading {
    data class Belief(val literal: Literal) : Reading
    data class Unreadable(val why: String) : Reading
}

private fun parse(percept: String): Reading = try {
    val literal = PerceptReader.read(percept)
    when {
        hasComment(percept) -> Reading.Unreadable("it holds a comment, // or /*, and the text of that would be lost; put it in quotes")
        literal === Literal.LTrue || literal === Literal.LFalse -> Reading.Unreadable(whyUnreadable(percept).orEmpty())
        literal.isVar || literal is InternalActionLiteral || !literal.isLiteral -> Reading.Unreadable("it is not a predicate")
        !literal.isGround || literal.ns.isVar ->
            Reading.Unreadable("it holds a variable; a sensor's words begin in lower case or stand in quotes")
        else -> (whyNoValue(literal) ?: claim(literal))?.let(Reading::Unreadable) ?: Reading.Belief(ownSource(literal))
    }
} catch (refused: PerceptSyntaxException) {
    val detail = if (refused.cause is StackOverflowError) "it is nested too deep"
    else whyUnreadable(percept) ?: (refused.cause ?: refused).message.orEmpty().lineSequence().first()
    Reading.Unreadable("Jason cannot read it" + if (detail.isEmpty()) "" else ": ${foreignText(detail)}")
}

/** Explains why [term] has no fixed value; null if it has one. The value of a sum of numbers is a number. */
private fun whyNoValue(term: Term): String? = when {
    term is ArithExpr -> term.terms.firstNotNullOfOrNull(::whyNoValue) ?: whyNoNumber(term.capply(Unifier()) as NumberTerm)
    term is ArithFunctionTerm -> "it holds a function, which would be computed anew each time that the agent looks at it"
    term is NumberTerm -> whyNoNumber(term)
    term is Literal ->
        (0 until term.arity).firstNotNullOfOrNull { whyNoValue(term.getTerm(it)) }
            ?: if (term.hasAnnot()) term.annots.firstNotNullOfOrNull(::whyNoValue) else null
    else -> null
}

private fun whyNoNumber(number: NumberTerm) = if (number.solve().isFinite()) null else INFINITE

/** Explains why a percept must not be [literal], which is reserved for ARGO. As the last argument, `off[x]` counts as `off`. */
private fun claim(literal: Literal): String? {
    val last = if (literal.arity == 0) null else literal.getTerm(literal.arity - 1) as? Literal
    return whyClaimed("${literal.functor}/${literal.arity}", last?.functor)
}

/** Removes the sources that the text of [literal] names, since the only source of a board's literal is `percept`. */
private fun ownSource(literal: Literal): Literal {
    val claimed = literal.getAnnots("source")
    if (!claimed.isEmpty()) literal.delAnnots(ArrayList(claimed))
    return literal
}
