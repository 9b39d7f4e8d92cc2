package argo.fleet.agents

import argo.fleet.cluster.Overloaded
import argo.fleet.cluster.Refused
import argo.fleet.node.reason
import argo.recording.agent.AwaitedOutside
import jason.JasonException
import jason.asSemantics.TransitionSystem
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage
import java.util.logging.Logger

/**
 * A message on its way to another computer.
 *
 * @property id the message's id. If the message is a question, Jason suspends the asking intention under this id
 */
internal class Delivery(val id: String?, private val receiver: String, private val log: Logger, end: CompletionStage<Void>) {
    val end: CompletableFuture<Void> = end.toCompletableFuture()

    /** Logs a warning if the message does not arrive. Call this function if no action waits for the message. */
    fun tellFailure() {
        end.whenComplete { _, failed ->
            if (failed != null) log.warning("a message to $receiver has not arrived: ${failed.reason().message}")
        }
    }
}

/**
 * Collects the messages to other computers that an internal action sends. The action then waits for their outcomes. If no action waits for
 * a message, its failure is logged.
 */
internal object Deliveries {
    private val collected = ThreadLocal<MutableList<Delivery>>()

    /** Runs [action] and returns its result, with the messages that it sent. If [action] throws, [failed] gets these messages. */
    fun <T> during(failed: (List<Delivery>) -> Unit, action: () -> T): Pair<T, List<Delivery>> {
        val sent = ArrayList<Delivery>()
        val outer = collected.get()
        collected.set(sent)
        try {
            return action() to sent
        } catch (thrown: Throwable) {
            failed(sent)
            throw thrown
        } finally {
            if (outer == null) collected.remove() else collected.set(outer)
        }
    }

    /** Adds [delivery] to the action of the calling thread. If there is no action, only logs a failure of [delivery]. */
    fun add(delivery: Delivery) = collected.get()?.add(delivery) ?: delivery.tellFailure()
}

/**
 * Makes an internal action wait for its messages to other computers. The action fails if the arrival of a message is not confirmed. Only
 * the action's intention waits, but an atomic intention blocks all others. The cluster ends each wait. The longest wait is that for a
 * computer with an unplugged cable, which is lost after three rounds of signs of life (`failures` in JGroupsStack.kt). Belongs to one
 * agent.
 *
 * @param questions the agent's questions to other computers
 */
internal class DeliveryWait(private val questions: Questions) {
    /**
     * True if the last call of [carryOut] has suspended its intention until messages arrive. False if the intention waits for an answer.
     */
    var isWaiting = false
        private set

    fun carryOut(ts: TransitionSystem, action: () -> Any): Any {
        isWaiting = false
        val (result, sent) = Deliveries.during({ forget(ts, it) }, action)
        if (sent.isEmpty() || result != true) return result
        val answered = questions.end(sent.first().id)
        if (answered != null) {
            answered.thenAccept(AwaitedOutside.begin(ts))
            sent.forEach { delivery -> delivery.end.whenComplete { _, failed -> if (failed != null) questions.fail(delivery.id, failed) } }
        } else if (sent.any { !it.end.isDone || it.end.isCompletedExceptionally }) {
            isWaiting = true
            await(sent, AwaitedOutside.begin(ts))
        }
        return result
    }

    private fun await(sent: List<Delivery>, end: (JasonException?) -> Unit) {
        CompletableFuture.allOf(*sent.map { it.end }.toTypedArray()).whenComplete { _, _ ->
            val lost = sent.filter { it.end.isCompletedExceptionally }
            lost.drop(1).forEach(Delivery::tellFailure) // the plan gets the failure of the first one
            end(lost.firstOrNull()?.end?.handle { _, failed -> errorOf(failed) }?.join())
        }
    }

    /**
     * Undoes the suspension of the intention if sending failed: Jason suspends it before it sends a question, and no answer will come. With
     * a second suspension of one intention, a failure would end the wrong one, and an answer that comes later would end the agent's cycle.
     */
    private fun forget(ts: TransitionSystem, sent: List<Delivery>) {
        sent.forEach(Delivery::tellFailure)
        ts.c.pendingIntentions.filterValues { it === ts.c.selectedIntention }.keys.forEach(ts.c::removePendingIntention)
    }
}

/** Returns the exception for a message that did not arrive because of [reason]. The exception has the `error(…)` that plans match. */
internal fun errorOf(reason: Throwable): JasonException =
    reason.reason() as? JasonException ?: refusalOf(reason).let { AwaitedOutside.exceptionOf(it.error, it.message.orEmpty()) }

/** Converts [reason], the cause of a lost message, into a refusal that other computers understand. */
internal fun refusalOf(reason: Throwable): Refused = when (val cause = reason.reason()) {
    is Refused -> cause
    is Overloaded -> Refused("overloaded", cause.message.orEmpty())
    else -> Refused("unreachable", cause.message ?: "$cause")
}

/** Returns the exception for a message to an agent that does not exist. Jason without a fleet gives the same error. */
internal fun noAgent(message: String): JasonException = AwaitedOutside.exceptionOf(AwaitedOutside.NO_AGENT, message)
