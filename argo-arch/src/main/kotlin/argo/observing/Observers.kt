package argo.observing

import argo.filters.CriticalRule
import java.util.concurrent.atomic.AtomicBoolean
import java.util.concurrent.atomic.AtomicLong
import java.util.logging.Level
import java.util.logging.Logger

/**
 * Calls all [observers] of an agent, in their order. If an observer throws, the others are still called. [log] gets each observer's first
 * exception. Safe for use by several threads.
 *
 * @param nanos the agent's clock, in ns
 */
internal class Observers(val observers: List<AgentObserver>, private val log: Logger, private val nanos: () -> Long) {
    private val guarded = observers.map(::Guarded)
    private val commands = AtomicLong()

    /** Reports that [text] is about to be sent on [port]. Returns the command; null if the agent has no observers. */
    fun commandIssued(port: String, text: String): IssuedCommand? {
        if (guarded.isEmpty()) return null
        return IssuedCommand(commands.incrementAndGet(), port, text, nanos()).also { command -> each { it.commandIssued(command) } }
    }

    fun reflexEnded(rule: CriticalRule, watcher: RuleWatcher, failure: CommandFailure?) {
        if (guarded.isEmpty()) return
        val reflex = EndedReflex(rule, watcher, failure, nanos())
        each { it.reflexEnded(reflex) }
    }

    inline fun each(event: (AgentObserver) -> Unit) {
        for (observer in guarded) {
            try {
                event(observer.observer)
            } catch (broken: Throwable) { // an observer is foreign code, and the agent must continue
                if (broken is InterruptedException) Thread.currentThread().interrupt()
                if (!observer.hasFailed.getAndSet(true)) {
                    log.log(Level.WARNING, broken) { "${observer.observer} failed, and is not reported again" }
                }
            }
        }
    }

    internal class Guarded(val observer: AgentObserver) {
        val hasFailed = AtomicBoolean()
    }
}
