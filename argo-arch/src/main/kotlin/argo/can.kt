package argo

import argo.acting.isPlainName
import argo.calls.Failure
import argo.calls.isStepOf
import argo.calls.wrongArgument
import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.asSyntax.UnnamedVar
import javino.wire.BoardAction.ANY
import javino.wire.BoardAction as RegisteredAction

/**
 * The internal action `argo.can(Action)`: true if the board in use has registered Action, that is its functor with this number of
 * arguments; their values do not matter. It is meant for contexts: `+!greet : argo.can(say(_)) <- argo.act(say("hello"))`.
 *
 * If Action is a variable, it is bound to one action after the other, as `speed(_)`: `.findall(A, argo.can(A), All)`. An action that takes
 * any number of arguments is given without any.
 *
 * Boards of version 2 describe themselves; ARGO asks for the description at the beginning of a session. If it is not known (version 1, a
 * sketch without a table of actions, no port in use, or no answer yet), the action is false in a context; as a step of a plan it fails the
 * plan with `error(no_vocabulary)`. Fails the plan also with `error(wrong_arguments)` or `error(not_argo)`.
 */
@Suppress("ClassName")
open class can : DefaultInternalAction() {
    override fun getMinArgs() = 1

    override fun getMaxArgs() = 1

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        checkArguments(args)
        val action = args[0] as? Literal
        if (action == null || action.isList) throw wrongArgument("an action is a literal such as speed(V), not ${args[0]}").of(call(args))
        val arch = archOf(ts) ?: throw notArgo(ts).of(call(args))
        val vocabulary = arch.io.vocabulary() ?: return if (isStepOf<can>(ts, un)) throw noVocabulary(arch).of(call(args)) else false
        val actions = vocabulary.associateBy { it.name } // the newest of a name counts
        if (!action.isVar) return actions[action.functor]?.let { it.arguments == ANY || it.arguments == action.arity } ?: false
        return actions.values.mapNotNull(::literalOf).mapNotNull { known -> un.clone().takeIf { it.unifies(action, known) } }.iterator()
    }

    private fun call(args: Array<Term>) = "argo.can(${args.joinToString(",")})"

    private fun noVocabulary(arch: Arch): Failure {
        val port = arch.io.portInUse()?.link?.port()
        return Failure(
            "no_vocabulary",
            if (port == null) "no port is in use; choose one with argo.port first"
            else "the board on port $port has not described its actions; boards of version 2 with a table of actions do",
        )
    }
}

/** A literal that the agent can act by; null: the board's name for the action is no atom. */
private fun literalOf(action: RegisteredAction): Literal? = action.name.takeIf(::isPlainName)?.let { name ->
    val arguments = if (action.arguments == ANY) 0 else action.arguments
    ASSyntax.createLiteral(name, *Array<Term>(arguments) { UnnamedVar() })
}
