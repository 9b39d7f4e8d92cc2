package argo.fleet.agents

import argo.fleet.cluster.Overloaded
import argo.fleet.cluster.Refused
import argo.fleet.node.reason
import jason.JasonException
import jason.ReceiverNotFoundException
import jason.asSemantics.ConcurrentInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSyntax.ASSyntax
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage
import java.util.logging.Logger

/**
 * A message on its way to another computer.
 *
 * @property id the message's id; if an intention asks a question, Jason suspends it under this id
 */
internal class Delivery(val id: String?, val receiver: String, val end: CompletionStage<Void>)

/**
 * Collects the messages that an internal action sends to other computers while the agent's thread carries it out. The action waits for the
 * ends of its messages. If no action waits for a message, the log tells its failure.
 */
internal object Deliveries {
    private val collected = ThreadLocal<MutableList<Delivery>>()

    /** Runs [action] and returns its result, with the messages that it has sent. If [action] throws, [failed] gets these messages. */
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

    /** Notes [delivery] for the action that the calling thread carries out; if there is none, [log] tells its failure. */
    fun add(delivery: Delivery, log: Logger) {
        collected.get()?.add(delivery) ?: delivery.end.whenComplete { _, failed ->
            if (failed != null) log.warning("a message to ${delivery.receiver} has not arrived: ${failed.reason().message}")
        }
    }
}

/**
 * Has an internal action wait for its messages to other computers, and fail if one is not known to have arrived. The intention is
 * suspended, the agent goes on. Belongs to one agent.
 */
internal class DeliveryWait {
    /** Whether the call that was carried out last has suspended its intention. */
    var isWaiting = false
        private set

    /**
     * Carries out [action].
     *
     * @param isAsk asked behind the action: whether it has suspended the intention by itself, until answers come
     */
    fun carryOut(ts: TransitionSystem, isAsk: () -> Boolean, action: () -> Any): Any {
        isWaiting = false
        val (result, sent) = Deliveries.during({ forget(ts, it) }, action)
        if (sent.isEmpty() || result != true) return result
        if (isAsk()) {
            sent.forEach { delivery -> delivery.end.whenComplete { _, failed -> if (failed != null) fail(ts, delivery.id, failed) } }
        } else if (sent.any { !it.end.toCompletableFuture().isDone || it.end.toCompletableFuture().isCompletedExceptionally }) {
            isWaiting = true
            val key = Suspension.suspendInt(ts, "fleet", 0)
            CompletableFuture.allOf(*sent.map { it.end.toCompletableFuture() }.toTypedArray()).whenComplete { _, failed ->
                if (failed == null) Suspension.resumeInt(ts, key) else fail(ts, key, failed)
            }
        }
        return result
    }

    /** Jason suspends an intention before it asks; if that fails, the intention fails, and nothing waits for an answer. */
    private fun forget(ts: TransitionSystem, sent: List<Delivery>) = sent.forEach { ts.c.removePendingIntention(it.id) }

    /** An action that suspends; only for its way to suspend an intention. */
    private object Suspension : ConcurrentInternalAction() {
        override fun timeout(ts: TransitionSystem, intentionKey: String) = failInt(ts, intentionKey)
    }

    companion object {
        /** Fails the intention that is suspended under [key], for the [reason]; nothing if there is none any more. */
        fun fail(ts: TransitionSystem, key: String?, reason: Throwable) =
            ConcurrentInternalAction.resume(ts, key, true, errorOf(reason.reason()).errorTerms)
    }
}

/** Returns the exception for a message that has not arrived for [reason], with the `error(…)` that plans match. */
internal fun errorOf(reason: Throwable): JasonException = when (reason) {
    is JasonException -> reason
    is Refused -> noAgent(reason.message.orEmpty())
    is Overloaded -> JasonException(reason.message, ASSyntax.createAtom("overloaded"))
    else -> JasonException(reason.message ?: "$reason", ASSyntax.createAtom("unreachable"))
}

/** Returns the exception for a message to an agent that does not exist. Its error is that of one computer, too. */
internal fun noAgent(message: String): JasonException = ReceiverNotFoundException(message).apply {
    addErrorAnnot(ASSyntax.createStructure("error", ASSyntax.createAtom("no_agent")))
}
