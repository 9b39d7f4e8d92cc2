package argo

import argo.acting.isPlainName
import argo.boards.Board
import argo.calls.Failure
import jason.asSyntax.ASSyntax
import jason.asSyntax.Atom
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.asSyntax.UnnamedVar
import javino.wire.BoardAction.ANY

/**
 * The internal action `argo.can(Action)`: true if a perceived board has registered an action with Action's functor and number of arguments.
 * The arguments' values do not matter. `argo.can(left::stop)` asks about the boards in the namespace `left`. `argo.can(B::stop)` binds B to
 * the namespace of each board with the action. The action is meant for contexts: `+!greet : argo.can(say(_)) <- argo.act(say("hello"))`.
 *
 * If Action is a variable, it is bound to each action in turn, such as `speed(_)`: `.findall(A, argo.can(A), All)`, or `.findall(left::A,
 * argo.can(left::A), All)` for one namespace. An action with any number of arguments appears without arguments.
 *
 * Boards of version 2 describe themselves. ARGO asks for the description at the beginning of a session. The description is unknown before
 * the board has answered. It stays unknown with version 1, with a sketch without a table of actions, or if no port is in use. If the
 * description is unknown, `argo.can` is false in a context. As a step of a plan, `argo.can` then fails the plan with
 * `error(no_vocabulary)`. Fails the plan also with `error(wrong_arguments)` or `error(not_argo)`.
 */
@Suppress("ClassName")
open class can : BoardQuery("argo.can", 1) {
    override fun answer(call: Call): Any {
        val action = call.args.single()
        if (action !is Literal || action.isList) throw call.wrong("an action is a literal such as speed(V), not $action")
        val namespace = action.ns.takeUnless { it.isVar || it == Literal.DefaultNS }
        val boards = call.arch.boards.current.filter { namespace == null || it.namespace == namespace.functor }
        return when {
            boards.all { it.actions == null } -> call.unanswered { noVocabulary(boards, namespace) }
            action.isVar -> boards.flatMap { literalsOf(it, namespace) }.distinctBy { it.predicateIndicator }
                .mapNotNull { known -> call.un.clone().takeIf { it.unifies(action, known) } }.iterator()
            action.ns.isVar -> boards.filter { it.knows(action) }.mapNotNull { it.namespace }.distinct()
                .mapNotNull { known -> call.un.clone().takeIf { it.unifies(action.ns, ASSyntax.createAtom(known)) } }.iterator()
            else -> boards.any { it.knows(action) }
        }
    }

    private fun noVocabulary(boards: List<Board>, namespace: Atom?): Failure {
        val ports = boards.joinToString(" and ") { it.port.link.port }
        return Failure(
            "no_vocabulary",
            when {
                boards.isEmpty() && namespace != null -> "no board has the namespace $namespace"
                boards.isEmpty() -> "no port is in use; choose one with argo.port first"
                boards.size == 1 -> "the board on port $ports has not described its actions; boards of version 2 with a table of actions do"
                else -> "the boards on ports $ports have not described their actions; boards of version 2 with a table of actions do"
            },
        )
    }
}

/** Returns literals in [namespace] for the actions of [board]. Leaves out actions with a name that is not an atom. */
private fun literalsOf(board: Board, namespace: Atom?) = board.actions.orEmpty().filter { isPlainName(it.name) }.map { action ->
    val arguments = if (action.arguments == ANY) 0 else action.arguments
    ASSyntax.createLiteral(namespace ?: Literal.DefaultNS, action.name, *Array<Term>(arguments) { UnnamedVar() })
}
