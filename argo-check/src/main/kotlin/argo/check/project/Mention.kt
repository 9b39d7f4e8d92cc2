package argo.check.project

import argo.check.syntax.Literal
import argo.check.syntax.Span

/** What a program does with a literal. */
enum class Role {
    /** A goal that the program posts: `!g`, `!!g`, an initial goal, or `{ +!g }` in `.at`. */
    POSTED,

    /** A goal in a message that asks another agent to achieve it. */
    SENT_GOAL,

    /** A goal that is an argument of an internal action, as in `.desire(g)`. */
    NAMED_GOAL,

    /** The goal that a plan handles, `+!g`. */
    HANDLED,

    /** The goal whose failure a plan handles, `-!g`. */
    FAILURE_HANDLED,

    /** The test goal of a plan `+?b`. */
    TEST_HANDLED,

    /** A belief that the program has or adds, or the head of a rule. */
    BELIEVED,

    /** A belief in a message that tells it to another agent. */
    TOLD,

    /** A formula in a context, a rule, a test or a condition. */
    READ,

    /** A belief whose addition or deletion triggers a plan. */
    EVENT,

    /** A belief that a plan deletes. */
    DELETED,

    /** A belief in a message that asks another agent for it. */
    ASKED,

    /** An action of the environment. */
    ACTION,

    /** An internal action. */
    INTERNAL,

    /** An argument. The program may later use it as a literal in any other role. */
    DATA,
}

/** A literal in a program, and its [role] there. */
class Mention(val role: Role, val literal: Literal) {
    val functor: String get() = literal.functor
    val arity: Int get() = literal.arity
    val span: Span get() = literal.name.span

    override fun toString(): String = "$role ${literal.indicator}"
}
