package argo.boundary

import jason.asSemantics.Unifier
import jason.asSyntax.Term

/**
 * A call of an internal action.
 *
 * @property name the action as the agent writes it, such as `argo.act`
 * @property args its arguments, as Jason prepares them
 * @property un the unifier by which the call may bind the variables in [args]
 * @property suspend suspends the intention as a successful call does; null: the call suspends none
 */
class InternalCall(val name: String, val args: Array<Term>, val un: Unifier, val suspend: (() -> Unit)? = null) {
    override fun toString() = "$name(${args.joinToString(",")})"
}
