package argo.acting

import argo.calls.Failure
import argo.filters.CriticalRule
import javino.wire.BoardRule
import javino.wire.CommandItem
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The critical rules that one board itself watches. The board is sent those rules of the agent that it can watch, in their order, until it
 * is full. Rules that it already holds are not sent again. Safe for use by several threads.
 *
 * The computer watches a rule until the board has acknowledged it, and again before its removal is sent. So around a change, both the board
 * and the computer may carry out a reflex, but at least one of them watches.
 *
 * If the board restarts, a command that still waits may reach the board in its next session. So in each session except the first, all rules
 * are removed first: the removal follows such late commands.
 *
 * @param wanted returns the critical rules that the agent wants to be watched now; called under this object's lock, by any thread
 * @param submit queues a command to the board, and calls `outcome` once, on any thread, when the outcome is known; called without the lock
 */
internal class BoardRules(
    private val wanted: () -> List<CriticalRule>,
    private val submit: (change: CommandItem.Rule, outcome: (Failure?) -> Unit) -> Unit,
) {
    private class Held(val number: Int, val rule: CriticalRule) {
        var isAcknowledged = false
    }

    /** A command to the board: it sets the rule [set] or, if that is null, removes rules. */
    private class Message(val change: CommandItem.Rule, val set: Held? = null)

    private val lock = ReentrantLock()
    private val held = LinkedHashMap<CriticalRule, Held>()
    private val numbered = HashMap<Int, CriticalRule>() // the rules of this session by number, with removed ones
    private val refused = HashSet<CriticalRule>()
    private var wishes: List<CriticalRule> = emptyList()
    private var room = 0
    private var lastNumber = 0
    private val unsent = ArrayDeque<Message>()
    private var isSending = false
    private var hasSent = false

    val isEmpty: Boolean get() = lock.withLock { held.isEmpty() }

    /** Notes that a session has begun, in which the board holds no rule yet and has room for [room] rules. */
    fun began(room: Int) = changing {
        this.room = room
        held.clear()
        numbered.clear()
        refused.clear()
        unsent.clear()
        if (hasSent && room > 0) unsent += Message(BoardRule.removal(ALL))
        adjust()
    }

    /** Sends the changes to the board if the agent now wants other rules. */
    fun renew() = changing { if (room > 0) adjust() }

    /** Returns true if the board watches [rule]. */
    fun isWatching(rule: CriticalRule): Boolean = lock.withLock { held[rule]?.isAcknowledged == true }

    /** Returns the rule that has, or had, [number] in this session; null: there is none. */
    fun ruleOf(number: Int): CriticalRule? = lock.withLock { numbered[number] }

    /** Returns true if the agent wants the board to watch [rule], and the board may be watching it. */
    fun isHeld(rule: CriticalRule): Boolean = lock.withLock { rule in held }

    private fun changing(change: () -> Unit) {
        lock.withLock(change)
        while (true) submit(nextToSend() ?: return)
    }

    /** Returns the message that this thread must send; null: there is none, or another thread is sending. So messages are sent in order. */
    private fun nextToSend(): Message? = lock.withLock {
        if (isSending) return null
        unsent.removeFirstOrNull()?.also {
            isSending = true
            hasSent = true
        }
    }

    private fun submit(message: Message) {
        try {
            submit(message.change) { failure -> message.set?.let { ended(it, failure) } }
        } finally {
            lock.withLock { isSending = false }
        }
    }

    private fun adjust() {
        val now = wanted().distinct()
        if (now != wishes) refused.clear() // the board may have room for the refused rules now
        wishes = now
        val next = now.asSequence().filter { it !in refused }
            .mapNotNull { rule -> boardRuleOf(rule)?.let { rule to it } }.take(room).toMap()
        val leaving = held.values.filter { it.rule !in next }
        leaving.forEach { held -= it.rule }
        if (held.isEmpty() && leaving.isNotEmpty()) unsent += Message(BoardRule.removal(ALL))
        else leaving.forEach { unsent += Message(BoardRule.removal(it.number)) }
        for ((rule, boardRule) in next) if (rule !in held) set(rule, boardRule)
    }

    private fun set(rule: CriticalRule, boardRule: BoardRule) {
        val new = Held(freeNumber(), rule)
        held[rule] = new
        numbered[new.number] = rule
        unsent += Message(boardRule.setting(new.number), new)
    }

    /** Returns the number that has been unused for longest, so a late report is not taken for a report of another rule. */
    private fun freeNumber(): Int {
        do lastNumber = lastNumber % MAX_NUMBER + 1 while (held.values.any { it.number == lastNumber })
        return lastNumber
    }

    /**
     * Handles the outcome of sending [entry]. If the board has not acknowledged the rule, the computer goes on watching it. The board may
     * watch it too, unless it has refused the rule.
     */
    private fun ended(entry: Held, failure: Failure?) = changing {
        if (held[entry.rule] === entry) {
            entry.isAcknowledged = failure == null
            if (failure?.error == "act_refused") {
                held -= entry.rule
                refused += entry.rule
                adjust()
            }
        }
    }

    private companion object {
        const val ALL = 0
        const val MAX_NUMBER = 255
    }
}
