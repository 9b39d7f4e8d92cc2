package argo.orders

import argo.platform.Plans
import jason.asSyntax.DefaultTerm
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.Pred
import jason.asSyntax.Rule
import jason.asSyntax.SourceInfo
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import jason.asSyntax.UnnamedVar
import jason.asSyntax.VarTerm

/**
 * Compares a part of a program with a part of the program's newer text. Two parts are alike if they differ only in lines, in numbers of
 * unnamed variables, and in labels given by Jason. An object compares only one pair of parts.
 */
internal class ProgramComparison {
    private val parts = ArrayList<Pair<DefaultTerm, DefaultTerm>>()
    private val there = HashMap<String, String>() // maps unnamed variables of the first part to those of the second part
    private val back = HashMap<String, String>()

    fun isAlike(one: Plan, other: Plan): Boolean = pair(one, other) && isAlikeLabel(one.label, other.label) &&
        isAlike(one.trigger, other.trigger) && isAlike(one.context as Any?, other.context) &&
        isAlike(one.goalCondition as Any?, other.goalCondition) && isAlike(one.body as Any?, other.body) &&
        isAllAlike(Plans.within(one)?.all.orEmpty(), Plans.within(other)?.all.orEmpty())

    fun isAlike(one: Rule, other: Rule): Boolean = isAlike(one as Any, other)

    /** Gives the terms of the first part their line numbers in the newer text. Returns true if any line number changes. */
    fun move(): Boolean = parts.filterNot { (one, other) -> isSame(one.srcInfo, other.srcInfo) }
        .onEach { (one, other) -> one.srcInfo = other.srcInfo }.isNotEmpty()

    private fun isSame(one: SourceInfo?, other: SourceInfo?) = one?.srcFile == other?.srcFile && one?.beginSrcLine == other?.beginSrcLine &&
        one?.endSrcLine == other?.endSrcLine

    private fun isAlikeLabel(one: Pred?, other: Pred?): Boolean {
        if (one == null || other == null) return one === other
        val isNamed = one.functor == other.functor || isJasons(one) && isJasons(other)
        return isNamed && isAllAlike(one.terms.orEmpty(), other.terms.orEmpty()) && isAllAlike(ownAnnotations(one), ownAnnotations(other))
    }

    private fun isJasons(label: Pred) = LABEL.matches(label.functor)

    /** Returns the annotations of [label] that are written in the program, without those that Jason adds. */
    private fun ownAnnotations(label: Pred) =
        if (label.hasAnnot()) label.annots.filterNot { it is Literal && it.functor in ADDED } else emptyList()

    private fun isAllAlike(one: List<Any?>, other: List<Any?>) = one.size == other.size && one.indices.all { isAlike(one[it], other[it]) }

    private fun isAlike(one: Any?, other: Any?): Boolean {
        if (one === other) return true
        if (one == null || other == null || one.javaClass != other.javaClass) return false
        if (one is Plan) return isAlike(one, other as Plan)
        if (one is DefaultTerm) pair(one, other as DefaultTerm)
        return when (one) {
            is VarTerm -> isAlikeName(one, other as VarTerm) && isAlike(one.ns as Any?, other.ns) && isAlikeAnnotations(one, other)
            is Trigger -> one.operator == (other as Trigger).operator && one.type == other.type &&
                isAlike(one.literal as Any?, other.literal)
            is PlanBody -> one.bodyType == (other as PlanBody).bodyType && isAlike(one.bodyTerm as Any?, other.bodyTerm) &&
                isAlike(one.bodyNext as Any?, other.bodyNext)
            is ListTerm -> isAllAlike(one.asList, (other as ListTerm).asList) && isAlike(one.tail as Any?, other.tail)
            is Literal -> isAlikeLiteral(one, other as Literal)
            else -> one == other
        }
    }

    private fun pair(one: DefaultTerm, other: DefaultTerm) = parts.add(one to other)

    private fun isAlikeName(one: VarTerm, other: VarTerm): Boolean = when {
        one !is UnnamedVar -> one.functor == other.functor && one.negated() == other.negated()
        else -> there.getOrPut(one.functor) { other.functor } == other.functor &&
            back.getOrPut(other.functor) { one.functor } == one.functor
    }

    private fun isAlikeLiteral(one: Literal, other: Literal): Boolean = one.functor == other.functor && one.negated() == other.negated() &&
        one.arity == other.arity && isAlike(one.ns as Any?, other.ns) && isAllAlike(termsOf(one), termsOf(other)) &&
        isAlikeAnnotations(one, other) && (one !is Rule || isAlike(one.body as Any?, (other as Rule).body))

    private fun termsOf(literal: Literal): List<Term> = (0 until literal.arity).map(literal::getTerm)

    private fun isAlikeAnnotations(one: Literal, other: Literal) =
        if (one.hasAnnot() && other.hasAnnot()) isAlike(one.annots as Any?, other.annots) else one.hasAnnot() == other.hasAnnot()

    private companion object {
        val LABEL = Regex("""p__\d+""")
        val ADDED = setOf("source", "url")
    }
}
