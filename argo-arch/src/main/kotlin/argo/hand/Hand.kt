package argo.hand

import argo.boundary.CompletionInbox
import argo.observing.Order
import argo.observing.Outcome
import jason.RevisionFailedException
import jason.asSemantics.TransitionSystem
import java.util.logging.Level
import java.util.logging.Logger

/**
 * Takes the orders of a person for one agent, and carries them out.
 *
 * @param wake wakes the agent until its argument returns true
 */
internal class Hand(private val log: Logger, wake: (seen: () -> Boolean) -> Unit) {
    private class Given(val order: Order, val done: (Outcome) -> Unit)

    private val given = CompletionInbox<Given>(wake)
    private val taken = ArrayDeque<Given>()

    /** Returns true if no order waits. Any thread. */
    fun isEmpty(): Boolean = given.isEmpty()

    /** Leaves [order] for the agent's next cycle. Then the agent's thread calls [done] once. Any thread. */
    fun give(order: Order, done: (Outcome) -> Unit) = given.put(Given(order, done))

    /** Takes the orders that wait, in their order. For the agent's thread, like [carryOut]. */
    fun takeAll(): List<Order> = given.takeAll().also { taken += it }.map { it.order }

    /** Has the agent of [ts] carry [order] out, and tells its outcome to the person who gave it: nobody, if a replay gives it. */
    fun carryOut(order: Order, ts: TransitionSystem) {
        val outcome = outcomeOf(order, ts)
        taken.removeFirstOrNull()?.done?.invoke(outcome)
    }

    private fun outcomeOf(order: Order, ts: TransitionSystem): Outcome = try {
        when (order) {
            is Order.Believe -> ts.believe(order.literal)
            is Order.Forget -> ts.forget(order.literal)
            is Order.Begin -> ts.begin(order.goal)
            is Order.Drop -> ts.drop(order.goal)
            is Order.Reload -> ts.reload(order)
            is Order.Resume -> ts.resume(order.beliefs)
            is Order.BeginAnew -> ts.beginAnew(order.events)
        }
    } catch (refused: OrderRefusedException) {
        Outcome(refused.message)
    } catch (refused: RevisionFailedException) {
        Outcome("the agent's own belief revision refuses it: ${refused.message}")
    } catch (broken: RuntimeException) { // the project's own code may revise beliefs
        log.log(Level.WARNING, broken) { "the order $order failed" }
        Outcome("it failed: $broken")
    }
}

/** The agent cannot carry out an order; the message says why. */
internal class OrderRefusedException(message: String) : Exception(message)
