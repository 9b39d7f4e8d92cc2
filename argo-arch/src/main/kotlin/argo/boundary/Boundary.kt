package argo.boundary

import argo.observing.CommandFailure
import jason.asSemantics.ActionExec
import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal

/**
 * The boundary between one agent and everything else. All that enters Jason's reasoning cycle passes here, once in a cycle, and does not
 * change within it. [Live] hands on what comes. A recorder notes it besides, and a replay puts what was recorded in its place.
 *
 * Functions are called by the agent's thread unless they say otherwise, and within a cycle: between [cycleStarting] and [cycleFinished].
 */
interface Boundary {
    /** A reasoning cycle of the agent of [ts] begins. Completions of [suspended] and the like are carried out here. */
    fun cycleStarting(ts: TransitionSystem)

    /** What the agent perceives in this cycle; [live] gives what its boards and its environment have for it. */
    fun perceive(live: () -> Perception): Perception

    /** The percepts that meet critical rules and are new in this cycle; their events come first. */
    fun newlyCritical(live: () -> List<Literal>): List<Literal>

    /** The port whose board says [percept], of which an event waits; null: no board does. */
    fun boardOf(percept: Literal, live: () -> String?): String?

    /** [live] adds the messages that have come to the agent's mailbox. */
    fun takeMail(live: () -> Unit)

    /** What [call] gives, which [live] carries out: see [jason.asSemantics.InternalAction.execute]. */
    fun call(call: InternalCall, live: () -> Any): Any

    /**
     * An intention waits for something outside. Any thread may call what this returns, once, when that has ended; then [complete] is
     * called, at once or in a later cycle of the agent, with null or with the reason why it failed.
     */
    fun suspended(complete: (CommandFailure?) -> Unit): (CommandFailure?) -> Unit

    /** [live] hands [message] to the infrastructure. */
    fun send(message: Message, live: () -> Unit)

    /** [live] hands [message], for all other agents, to the infrastructure. */
    fun broadcast(message: Message, live: () -> Unit)

    /** [live] has the environment carry out [action], or what it is given in its place. */
    fun act(action: ActionExec, live: (ActionExec) -> Unit)

    /** Whether the agent may sleep. Also called outside of a cycle, and by other threads. */
    fun canSleep(live: () -> Boolean): Boolean

    /** Jason may have applied a rule of its cycle. Also called outside of a cycle, and by other threads. */
    fun ruleApplied()

    /** The cycle is over. */
    fun cycleFinished()
}

/**
 * What an agent perceives in one cycle.
 *
 * @property percepts all that it perceives now; null: nothing has changed
 * @property waiting how many events wait in its queue before those of [percepts], which take turns; null: they are of one board
 * @property hasNamespaces whether a percept of it has, or has had, a namespace of its own
 */
class Perception(val percepts: MutableCollection<Literal>?, val waiting: Int? = null, val hasNamespaces: Boolean = false)

/** All that comes is handed on at once. */
internal object Live : Boundary {
    override fun cycleStarting(ts: TransitionSystem) = Unit
    override fun perceive(live: () -> Perception) = live()
    override fun newlyCritical(live: () -> List<Literal>) = live()
    override fun boardOf(percept: Literal, live: () -> String?) = live()
    override fun takeMail(live: () -> Unit) = live()
    override fun call(call: InternalCall, live: () -> Any) = live()
    override fun suspended(complete: (CommandFailure?) -> Unit) = complete
    override fun send(message: Message, live: () -> Unit) = live()
    override fun broadcast(message: Message, live: () -> Unit) = live()
    override fun act(action: ActionExec, live: (ActionExec) -> Unit) = live(action)
    override fun canSleep(live: () -> Boolean) = live()
    override fun ruleApplied() = Unit
    override fun cycleFinished() = Unit
}
