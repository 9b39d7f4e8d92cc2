package argo.fleet.agents

import argo.fleet.cluster.Unreachable
import argo.fleet.node.Directory
import jason.JasonException
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentHashMap

/**
 * The unanswered questions of one agent to agents of other computers. Jason suspends the intention that asks, under the question's id,
 * until all answers have come or the question's time is over. Safe for use by several threads.
 */
internal class Questions {
    private class Question {
        val asked = ConcurrentHashMap<String, String>() // the asked agents that have not answered, each with its computer
        val end = CompletableFuture<JasonException?>()
    }

    private val open = ConcurrentHashMap<String, Question>()

    /** Notes that the question [id] goes to [agent] on another [computer], and perhaps to further agents. */
    fun ask(id: String, agent: String, computer: String) {
        open.computeIfAbsent(id) { Question() }.asked[agent] = computer
    }

    /** Returns the future end of the question [id]: an exception if it fails, otherwise null. If [id] is unknown, returns null. */
    fun end(id: String?): CompletableFuture<JasonException?>? = id?.let(open::get)?.end

    /** Notes that [agent] has answered the question [id]. */
    fun answered(id: String, agent: String) {
        open[id]?.asked?.remove(agent)
    }

    /** Fails the question [id], even before its action has called [end]. Returns false if the question is over or does not exist. */
    fun fail(id: String?, reason: Throwable): Boolean = id?.let(open::get)?.end?.complete(errorOf(reason)) ?: false

    /** Fails questions to agents that have not answered and, according to [now], have left the computer where they were asked. */
    fun failLost(now: Directory) = open.forEach { (id, question) ->
        question.asked.entries.find { (agent, computer) -> !now.runs(agent, computer) }?.let { (agent, computer) ->
            val reason = if (now.isMet(computer)) "it has ended there" else "its computer $computer is off"
            fail(id, Unreachable("$agent has not answered, and $reason"))
        }
    }

    /** Ends all questions except [waiting], for whose answers intentions still wait. The others are answered, too old or dropped. */
    fun endAllBut(waiting: Set<String>) = open.keys.filter { it !in waiting }.forEach { open.remove(it)?.end?.complete(null) }
}
