package argo.boundary

import argo.observing.CommandFailure
import argo.observing.Order
import jason.asSemantics.ActionExec
import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.Term

/**
 * The boundary between one agent and everything else. Each input of Jason's reasoning cycle passes the boundary once in a cycle, and does
 * not change within the cycle. [Live] passes inputs on unchanged. A recorder also notes them. In a replay, recorded inputs replace the live
 * ones.
 *
 * The agent's thread calls the functions between [cycleStarting] and [cycleFinished]. The exceptions are named at the functions.
 */
interface Boundary {
    /** Begins a reasoning cycle of the agent of [ts]. Completes work that has ended on other threads, such as [suspended] calls. */
    fun cycleStarting(ts: TransitionSystem)

    /**
     * Calls [carryOut] with each order to the agent in this cycle, in sequence. [live] returns the orders that have come. Called directly
     * after [cycleStarting].
     */
    fun orders(live: () -> List<Order>, carryOut: (Order) -> Unit)

    /** Returns the agent's perception in this cycle. [live] returns the perception of its boards and its environment. */
    fun perceive(live: () -> Perception): Perception

    /** Returns the percepts that meet critical rules and are new in this cycle. The agent handles their events first. */
    fun newlyCritical(live: () -> List<Literal>): List<Literal>

    /** Fills the agent's mailbox in this cycle. [live] adds the messages that have come. */
    fun takeMail(live: () -> Unit)

    /** Returns the result of [call], see [jason.asSemantics.InternalAction.execute]. [live] carries the call out. */
    fun call(call: InternalCall, live: () -> Any): Any

    /**
     * Returns the callback for an intention that waits for work on another thread. Any thread may call the callback, once, when the work
     * has ended. The agent's thread then calls [complete], at once or in a later cycle. The arguments are the failure, or null, and the
     * text of a robot's answer, or null.
     */
    fun suspended(complete: (failure: CommandFailure?, answer: String?) -> Unit): (failure: CommandFailure?, answer: String?) -> Unit

    /** Sends [message]. [live] gives the message to the infrastructure. */
    fun send(message: Message, live: () -> Unit)

    /** Sends [message] to all other agents. [live] gives the message to the infrastructure. */
    fun broadcast(message: Message, live: () -> Unit)

    /** Carries out [action]. Calls [live] with [action] or a replacement. [live] gives its argument to the environment. */
    fun act(action: ActionExec, live: (ActionExec) -> Unit)

    /** Returns true if the agent may sleep. Other threads also call this function, even between cycles. */
    fun canSleep(live: () -> Boolean): Boolean

    /** Notes that Jason may just have applied a rule of its cycle. Other threads also call this function, even between cycles. */
    fun ruleApplied()

    /**
     * Returns true if the agent must pause before it carries out an intention in this cycle. In a replay, the result of [live] is ignored.
     * Called between two rules of the cycle.
     */
    fun isHeld(live: () -> Boolean): Boolean

    /**
     * Returns the result of [ask], a person's question to the agent. The question does not affect the agent's cycles. Questions may come
     * between cycles.
     */
    fun <T> asking(ask: () -> T): T

    fun cycleFinished()
}

/**
 * The perception of an agent in one cycle.
 *
 * @property percepts all percepts of the agent now; null if nothing has changed
 * @property waiting the length of the event queue before the events of [percepts] are added; null if events do not take turns
 */
class Perception(val percepts: MutableCollection<Literal>?, val waiting: Int? = null)

/**
 * A call of an internal action.
 *
 * @property name the action as the agent writes it, such as `argo.act`
 * @property args the call's arguments, as Jason has prepared them
 * @property un the unifier in which the call may bind the variables of [args]
 * @property suspend suspends the intention, as a successful call does; null if the call does not suspend the intention
 */
class InternalCall(val name: String, val args: Array<Term>, val un: Unifier, val suspend: (() -> Unit)? = null) {
    override fun toString() = "$name(${args.joinToString(",")})"
}

/** Passes each input on at once, unchanged. */
internal object Live : Boundary {
    override fun cycleStarting(ts: TransitionSystem) = Unit
    override fun orders(live: () -> List<Order>, carryOut: (Order) -> Unit) = live().forEach(carryOut)
    override fun perceive(live: () -> Perception) = live()
    override fun newlyCritical(live: () -> List<Literal>) = live()
    override fun takeMail(live: () -> Unit) = live()
    override fun call(call: InternalCall, live: () -> Any) = live()
    override fun suspended(complete: (CommandFailure?, String?) -> Unit) = complete
    override fun send(message: Message, live: () -> Unit) = live()
    override fun broadcast(message: Message, live: () -> Unit) = live()
    override fun act(action: ActionExec, live: (ActionExec) -> Unit) = live(action)
    override fun canSleep(live: () -> Boolean) = live()
    override fun ruleApplied() = Unit
    override fun isHeld(live: () -> Boolean) = live()
    override fun <T> asking(ask: () -> T) = ask()
    override fun cycleFinished() = Unit
}
