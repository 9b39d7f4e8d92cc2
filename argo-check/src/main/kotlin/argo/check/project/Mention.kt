package argo.check.project

import argo.check.syntax.Literal
import argo.check.syntax.Span

/** What a program does with a literal. */
enum class Role {
    /** `!g`, `!!g`, an initial goal, or `{ +!g }` at a time. */
    POSTED,

    /** A goal that another agent is asked to achieve. */
    SENT_GOAL,

    /** A goal that an internal action asks for, as `.desire(g)`. */
    NAMED_GOAL,

    /** The goal of a plan. */
    HANDLED,

    /** The failure of a goal, as `-!g`. */
    FAILURE_HANDLED,

    /** The goal of a plan for a test, as `+?b`. */
    TEST_HANDLED,

    /** A belief, a rule's head, or what a plan adds. */
    BELIEVED,

    /** A belief that another agent is told. */
    TOLD,

    /** A formula in a context, a rule, a test or a condition. */
    READ,

    /** A belief whose addition or deletion a plan awaits. */
    EVENT,

    /** A belief that a plan deletes. */
    DELETED,

    /** A belief that another agent is asked for. */
    ASKED,

    /** An action of the environment. */
    ACTION,

    /** An internal action. */
    INTERNAL,

    /** An argument. It may become anything. */
    DATA,
}

/** A literal in a program, and what the program does with it. */
class Mention(val role: Role, val literal: Literal) {
    val functor: String get() = literal.functor
    val arity: Int get() = literal.arity
    val span: Span get() = literal.name.span

    override fun toString(): String = "$role ${literal.indicator}"
}
