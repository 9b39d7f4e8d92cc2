package argo.debug

import argo.observing.ObservedAgent
import argo.observing.PausePhase
import argo.observing.PauseState
import jason.asSemantics.Intention
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit

/** An agent, which a debugger shows as a thread. Safe for use by several threads. */
internal class AgentThread(val number: Int, val agent: ObservedAgent) {
    val pausing get() = agent.pausing

    /** The agent's intentions, running and suspended ones. Use this only in [asking]. */
    val intentions: List<Intention>
        get() = agent.circumstance.allIntentions.asSequence().filterNot { it.isFinished }.distinctBy { it.id }.toList()

    /** The intention that a debugger shows; null if the agent has no intention. Use this only in [asking]. */
    val shown: Intention?
        get() {
            val all = intentions
            val first = pausing.state.intention ?: agent.circumstance.runningIntentions.firstOrNull()?.id
            return all.find { it.id == first } ?: all.firstOrNull()
        }

    /**
     * Calls [ask] on the agent's thread, and returns its result.
     *
     * @throws DebugException if the agent is not paused, or does not answer in time
     */
    fun <T> asking(ask: () -> T): T {
        val answer = CompletableFuture<T>()
        val stands = pausing.look {
            try {
                answer.complete(ask())
            } catch (failed: Throwable) { // a formula may throw any exception
                answer.completeExceptionally(failed)
            }
        }
        if (!stands) throw DebugException("agent ${agent.name} is not paused; pause it first")
        try {
            return answer.get(PATIENCE_S, TimeUnit.SECONDS)
        } catch (failed: java.util.concurrent.ExecutionException) {
            throw failed.cause ?: failed
        } catch (_: java.util.concurrent.TimeoutException) {
            throw DebugException("agent ${agent.name} has not answered for $PATIENCE_S s; the question may have no end")
        }
    }

    fun isPaused(state: PauseState = pausing.state) = state.phase == PausePhase.PAUSED

    private companion object {
        const val PATIENCE_S = 10L
    }
}

/** Reports that a debugger's request cannot be fulfilled. [message] tells the user the reason. */
internal class DebugException(message: String) : Exception(message)
