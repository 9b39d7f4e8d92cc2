package argo.orders

import argo.boundary.CompletionInbox
import argo.observing.Order
import argo.observing.Outcome
import jason.RevisionFailedException
import jason.asSemantics.TransitionSystem
import java.util.logging.Level
import java.util.logging.Logger

/**
 * Receives orders for one agent, from a person or from the agent's last run, and carries them out.
 *
 * @param wake wakes the agent until `seen` returns true
 */
internal class Orders(private val log: Logger, wake: (seen: () -> Boolean) -> Unit) {
    private class Given(val order: Order, val program: ProgramText?, val done: (Outcome) -> Unit)

    private val given = CompletionInbox<Given>(wake)
    private val taken = ArrayDeque<Given>()

    /** Returns true if no order waits. Any thread may call this function. */
    fun isEmpty(): Boolean = given.isEmpty()

    /**
     * Keeps [order] for the agent's next cycle. The agent's thread then calls [done] once. Any thread may call this function.
     *
     * @param program the program that was read from the files of a reload; if null, the agent's thread reads the files
     */
    fun give(order: Order, program: ProgramText? = null, done: (Outcome) -> Unit) = given.put(Given(order, program, done))

    /** Removes and returns the waiting orders, in sequence. Only for the agent's thread. */
    fun takeAll(): List<Order> = given.takeAll().also { taken += it }.map { it.order }

    /**
     * Lets the agent of [ts] carry out [order], and tells the outcome to the order's giver. A replayed order has no giver. Only for the
     * agent's thread.
     */
    fun carryOut(order: Order, ts: TransitionSystem) {
        val given = taken.find { it.order === order }?.also(taken::remove)
        val outcome = attempt(order) { outcomeOf(order, given?.program, ts) }
        attempt(order) { outcome.also { given?.done?.invoke(it) } }
    }

    private fun outcomeOf(order: Order, program: ProgramText?, ts: TransitionSystem): Outcome = when (order) {
        is Order.Believe -> ts.believe(order.literal)
        is Order.Forget -> ts.forget(order.literal)
        is Order.Begin -> ts.begin(order.goal)
        is Order.Drop -> ts.drop(order.goal)
        is Order.Reload -> ts.reload(order, program ?: ProgramText.of(order.files))
        is Order.Resume -> ts.resume(order.beliefs)
        is Order.BeginAnew -> ts.beginAnew(order.events)
    }

    /** Does [work] for [order]. An exception of [work] becomes the outcome, so the agent can continue. */
    fun attempt(order: Order, work: () -> Outcome): Outcome = try {
        work()
    } catch (refused: OrderRefusedException) {
        Outcome(refused.message)
    } catch (refused: RevisionFailedException) {
        Outcome("the agent's own belief revision refuses it: ${refused.message}")
    } catch (broken: Throwable) { // the project's own belief revision or belief base may throw anything
        log.log(Level.WARNING, broken) { "the order $order failed" }
        Outcome("it failed, perhaps in the middle: $broken")
    }
}

internal class OrderRefusedException(message: String) : Exception(message)
