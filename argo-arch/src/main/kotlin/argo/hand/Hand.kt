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
    private class Given(val order: Order, val program: ProgramText?, val done: (Outcome) -> Unit)

    private val given = CompletionInbox<Given>(wake)
    private val taken = ArrayDeque<Given>()

    /** Returns true if no order waits. Any thread. */
    fun isEmpty(): Boolean = given.isEmpty()

    /**
     * Keeps [order] for the agent's next cycle. The agent's thread then calls [done] once. Any thread.
     * @param program the program that was read from the files of a reload; null: the agent's thread reads the files
     */
    fun give(order: Order, program: ProgramText? = null, done: (Outcome) -> Unit) = given.put(Given(order, program, done))

    /** Takes the orders that wait, in their order. For the agent's thread, like [carryOut]. */
    fun takeAll(): List<Order> = given.takeAll().also { taken += it }.map { it.order }

    /** Lets the agent of [ts] carry [order] out, and tells the outcome to the person who gave it; in a replay there is no such person. */
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

    /** Does [work] for [order]; an exception of the work becomes the outcome, so the agent goes on. */
    fun attempt(order: Order, work: () -> Outcome): Outcome = try {
        work()
    } catch (refused: OrderRefusedException) {
        Outcome(refused.message)
    } catch (refused: RevisionFailedException) {
        Outcome("the agent's own belief revision refuses it: ${refused.message}")
    } catch (broken: Throwable) { // the project's own code may revise beliefs and keep them
        log.log(Level.WARNING, broken) { "the order $order failed" }
        Outcome("it failed, perhaps in the middle: $broken")
    }
}

/** The agent cannot carry out an order; the message says why. */
internal class OrderRefusedException(message: String) : Exception(message)
