package argo.check.project

import argo.check.syntax.Literal
import argo.check.syntax.Span

/** The role of a literal in a program. */
enum class Role {
    /** A goal that the program posts: `!g`, `!!g`, an initial goal, or `{ +!g }` in `.at`. */
    POSTED,

    /** A goal that the program sends to another agent. */
    SENT_GOAL,

    /** A goal that is an argument of an internal action, as in `.desire(g)`. */
    NAMED_GOAL,

    /** The goal in a plan's trigger `+!g`. */
    HANDLED,

    /** The goal in a plan's trigger `-!g`. */
    FAILURE_HANDLED,

    /** The test goal in a plan's trigger `+?b`. */
    TEST_HANDLED,

    /** A belief that the program adds or initially has, or the head of a rule. */
    BELIEVED,

    /** A belief that the program tells another agent. */
    TOLD,

    /** A formula in a context, a rule, a test or a condition. */
    READ,

    /** A belief in a plan's trigger. */
    EVENT,

    /** A belief that a plan deletes. */
    DELETED,

    /** A belief for which the program asks another agent. */
    ASKED,

    /** An action of the environment. */
    ACTION,

    /** An internal action. */
    INTERNAL,

    /** An argument. The program may later use it in any other role. */
    DATA,
}

class Mention(val role: Role, val literal: Literal) {
    val functor: String get() = literal.functor
    val arity: Int get() = literal.arity
    val span: Span get() = literal.name.span

    override fun toString(): String = "$role ${literal.indicator}"
}
