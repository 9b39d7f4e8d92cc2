package argo.lsp.project

import argo.check.project.Mention
import argo.check.project.Role
import argo.check.syntax.Literal
import argo.check.syntax.Span

/** The kinds of names that a program defines. */
internal enum class Subject(val word: String) { BELIEF("belief"), GOAL("goal") }

/** A belief or a goal, by functor and number of arguments. */
internal data class Symbol(val subject: Subject, val functor: String, val arity: Int) {
    override fun toString(): String = "${if (subject == Subject.GOAL) "!" else ""}$functor/$arity"
}

/** A place of a symbol in a program. */
internal class Occurrence(val symbol: Symbol, private val role: Role, val literal: Literal) {
    val name: Span get() = literal.name.span

    /**
     * True if the place is a plan that handles the goal. For a belief, true if it is a belief, a rule, a step or a plan `+?b` that provides
     * it.
     */
    val isDefinition: Boolean get() = role in DEFINING

    /** True if the place is in a message to another agent. */
    val isSent: Boolean get() = role in SENT

    /** True if the place adopts the goal or reads the belief. */
    val isUse: Boolean get() = !isDefinition && role != Role.EVENT

    /** The namespace as written; empty if the literal has none. */
    val namespace: String get() = literal.namespace?.toString()?.substringBefore('/').orEmpty()

    companion object {
        private val OF_GOALS = setOf(Role.POSTED, Role.SENT_GOAL, Role.NAMED_GOAL, Role.HANDLED, Role.FAILURE_HANDLED)
        private val OF_BELIEFS = setOf(Role.BELIEVED, Role.TOLD, Role.READ, Role.EVENT, Role.DELETED, Role.ASKED, Role.TEST_HANDLED)
        private val DEFINING = setOf(Role.HANDLED, Role.BELIEVED, Role.TEST_HANDLED)
        private val SENT = setOf(Role.SENT_GOAL, Role.TOLD, Role.ASKED)

        /** Returns the place of [mention]; null if it is neither a belief nor a goal. */
        fun of(mention: Mention): Occurrence? {
            val subject = if (mention.role in OF_GOALS) Subject.GOAL else Subject.BELIEF.takeIf { mention.role in OF_BELIEFS }
            return subject?.let { Occurrence(Symbol(it, mention.functor, mention.arity), mention.role, mention.literal) }
        }
    }
}
