package argo.acting

import argo.calls.Failure
import argo.calls.failureOf
import argo.filters.CriticalRule
import argo.platform.RateLimitedWarning
import argo.ports.OpenPort
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Sends the reflexes of critical rules: once when a rule begins to be met, and again with each message that meets it until the command has
 * gone out or, in version 2, the board has acted or refuses it. Not again while the rule stays met. Safe for use by several threads.
 *
 * @param send sends a command to the board on a port before all that waits; calls its last argument once with the outcome, on any thread
 * @param warning takes the failures of reflexes
 */
internal class Reflexes(private val send: (OpenPort, String, (Failure?) -> Unit) -> Unit, private val warning: RateLimitedWarning) {
    private enum class Phase { UNDER_WAY, FAILED, DONE }

    /** One reflex from when its rule begins to be met until it ends to be. */
    private class Run {
        var phase = Phase.UNDER_WAY
    }

    private val lock = ReentrantLock()
    private val runs = HashMap<CriticalRule, Run>()

    /** The newest message of the board on [port] meets the rules [met], and no others. */
    fun perceived(port: OpenPort, met: Collection<CriticalRule>) {
        val due = lock.withLock {
            runs.keys.retainAll(met.toSet())
            met.distinct().filter { it.reflex != null }.mapNotNull { rule -> dueRun(rule)?.let { rule to it } }
        }
        due.forEach { (rule, run) -> start(port, rule, run) }
    }

    /** What was met is of another time, place or filter. */
    fun forget() = lock.withLock { runs.clear() }

    /** The run of [rule] if its command is to be sent now. */
    private fun dueRun(rule: CriticalRule): Run? = when (runs[rule]?.phase) {
        null, Phase.FAILED -> Run().also { runs[rule] = it }
        Phase.UNDER_WAY, Phase.DONE -> null
    }

    private fun start(port: OpenPort, rule: CriticalRule, run: Run) {
        val command = rule.reflex ?: return
        try {
            send(port, command) { end(rule, run, it) }
        } catch (unforeseen: RuntimeException) { // sensing must go on
            end(rule, run, failureOf(unforeseen))
        }
    }

    private fun end(rule: CriticalRule, run: Run, failure: Failure?) {
        val isFinal = failure == null || failure.error == "act_refused" // asking again would be refused again
        lock.withLock { run.phase = if (isFinal) Phase.DONE else Phase.FAILED }
        if (failure != null) warning.report("$rule ${failure.error}") {
            "the reflex ${rule.reflex} of the critical rule on ${rule.rule} has failed: ${failure.cause}"
        }
    }
}
