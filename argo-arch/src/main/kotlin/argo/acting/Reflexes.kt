package argo.acting

import argo.calls.Failure
import argo.calls.failureOf
import argo.connecting.OpenPort
import argo.filters.CriticalRule
import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import argo.observing.RuleWatcher
import argo.platform.RateLimitedWarning
import jason.asSyntax.ASSyntax
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.Literal
import jason.asSyntax.Term
import javino.wire.ReflexOutcome
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The reflexes of critical rules, and the beliefs about their outcomes. Safe for use by several threads.
 *
 * If the computer watches a rule, it sends the reflex when a message first meets the rule. If the reflex fails, the next message that meets
 * the rule sends it again. The reflex ends when the command is sent or, in version 2, when the board has acted or refused. After its end,
 * the reflex is sent again only if a message has not met the rule in between.
 *
 * If the board watches a rule, the board carries out the reflex and reports it. The report can be lost, or the board may read an unusual
 * percept differently. If a second message meets the rule and no report has come, the computer sends the reflex.
 *
 * @param send sends a command to the board on a port, ahead of all waiting commands. Calls its last argument once with the outcome, on any
 * thread
 * @param isBoards returns true if the board on a port watches a rule
 * @param ended called by any thread with each outcome: null, or the reason of a failure
 * @param warning logs the failures of reflexes
 */
internal class Reflexes(
    private val send: (OpenPort, String, (Failure?) -> Unit) -> Unit,
    private val isBoards: (OpenPort, CriticalRule) -> Boolean,
    private val ended: (CriticalRule, RuleWatcher, Failure?) -> Unit,
    private val warning: RateLimitedWarning,
) {
    private enum class Phase { BEGUN, LEFT_TO_BOARD, UNDER_WAY, FAILED, DONE }

    /** The state of one reflex while its rule is met. */
    private class Run {
        var phase = Phase.BEGUN

        /** True if the reflex was carried out, false if it failed, null if no outcome is known yet. */
        var isDone: Boolean? = null
    }

    private val lock = ReentrantLock()
    private val runs = LinkedHashMap<CriticalRule, Run>()
    private var version = 0L
    private var believedVersion = 0L

    /**
     * Notes that the newest percepts of the board on [port] meet the rules in [met], and no others.
     *
     * @param isMessage true if the percepts come from a message, false if they come from the board's report
     */
    fun perceived(port: OpenPort, met: Collection<CriticalRule>, isMessage: Boolean = true) {
        val due = lock.withLock {
            keep(met)
            met.distinct().filter { it.reflex != null && isDue(runs.getOrPut(it, ::Run), isMessage, isBoards(port, it)) }
                .map { it to runs.getValue(it) }
        }
        due.forEach { (rule, run) -> start(port, rule, run) }
    }

    /** Handles a board's report that [rule] is now met, with the outcome of the rule's reflex. */
    fun reported(rule: CriticalRule, outcome: ReflexOutcome) {
        if (rule.reflex == null || outcome == ReflexOutcome.NONE) return
        val isDone = outcome == ReflexOutcome.CARRIED_OUT
        lock.withLock { note(runs.getOrPut(rule, ::Run), Phase.DONE, isDone) }
        tell(rule, RuleWatcher.BOARD, if (isDone) null else Failure("act_refused", "the board, which watches the rule, refuses it"))
    }

    /** Forgets which rules are met. */
    fun forget() = keepOnly(emptyList())

    /** Watches only [rules] from now on. A rule that is already met stays met. */
    fun keepOnly(rules: Collection<CriticalRule>) = lock.withLock { keep(rules) }

    private fun keep(rules: Collection<CriticalRule>) {
        if (runs.keys.retainAll(rules.toSet())) version++
    }

    /** Returns true if the beliefs have changed since the last call of [beliefs]. */
    fun hasNews(): Boolean = lock.withLock { version != believedVersion }

    /** Returns the outcomes of the reflexes of met rules, as `reflex(stop,done)` or `reflex(stop,failed)`. */
    fun beliefs(): List<Literal> = lock.withLock {
        believedVersion = version
        runs.mapNotNull { (rule, run) -> run.isDone?.let { belief(rule, it) } }.distinct()
    }

    /** Returns true if the computer must send the reflex of [run] now. The rule of [run] is met. */
    private fun isDue(run: Run, isMessage: Boolean, isBoards: Boolean): Boolean {
        val isDue = when (run.phase) {
            Phase.BEGUN, Phase.FAILED -> !isBoards
            Phase.LEFT_TO_BOARD -> !isBoards || isMessage
            Phase.UNDER_WAY, Phase.DONE -> return false
        }
        if (isDue) run.phase = Phase.UNDER_WAY else if (isMessage) run.phase = Phase.LEFT_TO_BOARD
        return isDue
    }

    private fun start(port: OpenPort, rule: CriticalRule, run: Run) {
        val command = rule.reflex ?: return
        try {
            send(port, command) { end(rule, run, it) }
        } catch (unforeseen: RuntimeException) { // sensing must continue
            end(rule, run, failureOf(unforeseen))
        }
    }

    private fun end(rule: CriticalRule, run: Run, failure: Failure?) {
        val isFinal = failure == null || failure.error == "act_refused" // the board would refuse it again
        lock.withLock { if (run.phase == Phase.UNDER_WAY) note(run, if (isFinal) Phase.DONE else Phase.FAILED, failure == null) }
        tell(rule, RuleWatcher.COMPUTER, failure)
    }

    private fun note(run: Run, phase: Phase, isDone: Boolean) {
        run.phase = phase
        if (run.isDone != isDone) version++
        run.isDone = isDone
    }

    private fun tell(rule: CriticalRule, watcher: RuleWatcher, failure: Failure?) {
        ended(rule, watcher, failure) // wakes the agent, so it comes before the line, for which a crowded log may take long
        if (failure != null) warning.report("$rule ${failure.error}") {
            "the reflex ${rule.reflex} of the critical rule on ${rule.rule} has failed: ${failure.cause}"
        }
    }

    companion object {
        const val FUNCTOR = "reflex"
        private const val DONE = "done"
        private const val FAILED = "failed"

        val OUTCOMES = setOf(DONE, FAILED)

        private fun belief(rule: CriticalRule, isDone: Boolean): Literal =
            ASSyntax.createLiteral(FUNCTOR, commandOf(rule.reflex.orEmpty()), ASSyntax.createAtom(if (isDone) DONE else FAILED))

        private fun commandOf(text: String): Term = try {
            PerceptReader.read(text).takeIf { it.isGround && it.isLiteral && it !is InternalActionLiteral } ?: ASSyntax.createString(text)
        } catch (_: PerceptSyntaxException) {
            ASSyntax.createString(text)
        }
    }
}
