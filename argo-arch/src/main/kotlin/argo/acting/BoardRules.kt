package argo.acting

import argo.calls.Failure
import argo.filters.CriticalRule
import javino.wire.BoardRule
import javino.wire.CommandItem
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The critical rules that one board itself watches. The board gets those rules of the agent that it can watch, in their order, until it is
 * full. Rules that the board already holds are not sent again. Safe for use by several threads.
 *
 * The computer watches a rule until the board has acknowledged it. The computer watches it again before the rule's removal is sent. During
 * a change, board and computer may both carry out a reflex, but at least one of them watches.
 *
 * If the board restarts, a command of the old session may still reach it in the new session. Therefore each session except the first begins
 * with the removal of all rules. The removal arrives after commands of the old session.
 *
 * @param wanted returns the critical rules that the agent wants to be watched now. Called under this object's lock, by any thread
 * @param submit queues a command to the board, and calls `outcome` once, on any thread, when the outcome is known. Called without the lock
 */
internal class BoardRules(
    private val wanted: () -> List<CriticalRule>,
    private val submit: (change: CommandItem.Rule, outcome: (Failure?) -> Unit) -> Unit,
) {
    private class Held(val number: Int, val rule: CriticalRule) {
        var isAcknowledged = false
    }

    /** A command to the board, which sets the rule [set]. If [set] is null, the command removes rules. */
    private class Message(val change: CommandItem.Rule, val set: Held? = null)

    private val lock = ReentrantLock()
    private val held = LinkedHashMap<CriticalRule, Held>()
    private val numbered = HashMap<Int, CriticalRule>() // all rules of this session by number, even removed ones
    private val refused = HashSet<CriticalRule>()
    private var wishes: List<CriticalRule> = emptyList()
    private var room = 0
    private var lastNumber = 0
    private val unsent = ArrayDeque<Message>()
    private var isSending = false
    private var hasSent = false

    val isEmpty: Boolean get() = lock.withLock { held.isEmpty() }

    /** Notes that a session has begun. The board holds no rules yet, and can hold [room] rules. */
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

    /** Returns true if the board has acknowledged [rule]. */
    fun isWatching(rule: CriticalRule): Boolean = lock.withLock { held[rule]?.isAcknowledged == true }

    /** Returns the rule that has or had [number] in this session; null if no rule has had it. */
    fun ruleOf(number: Int): CriticalRule? = lock.withLock { numbered[number] }

    /** Returns true if the agent wants the board to watch [rule]. The board may not have acknowledged it. */
    fun isHeld(rule: CriticalRule): Boolean = lock.withLock { rule in held }

    private fun changing(change: () -> Unit) {
        lock.withLock(change)
        while (true) submit(nextToSend() ?: return)
    }

    /** Returns the message that this thread must send. To keep the order, returns null while another thread is sending. */
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
        if (now != wishes) refused.clear() // the board may now have room for them
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

    /** Returns the number that has been unused for longest. A late report of an old rule then does not count for a new rule. */
    private fun freeNumber(): Int {
        do lastNumber = lastNumber % MAX_NUMBER + 1 while (held.values.any { it.number == lastNumber })
        return lastNumber
    }

    /**
     * Handles the outcome of sending [entry]. If the board has not acknowledged the rule, the computer still watches it. If the board has
     * not refused the rule, board and computer may both watch it.
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
