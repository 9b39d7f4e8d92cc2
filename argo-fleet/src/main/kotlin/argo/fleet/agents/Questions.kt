package argo.fleet.agents

import argo.fleet.cluster.Unreachable
import argo.fleet.node.Directory
import jason.JasonException
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentHashMap

/**
 * The open questions of one agent to agents of other computers. Jason suspends the asking intention under the question's id, until all
 * answers have arrived or the time is over. Safe for use by several threads.
 */
internal class Questions {
    private class Question {
        val asked = ConcurrentHashMap<String, String>() // the agents without an answer so far, with their computers
        val end = CompletableFuture<JasonException?>()
    }

    private val open = ConcurrentHashMap<String, Question>()

    /** Stores that the question [id] goes to [agent] on another [computer]. The question may also go to other agents. */
    fun ask(id: String, agent: String, computer: String) {
        open.computeIfAbsent(id) { Question() }.asked[agent] = computer
    }

    /** Returns the future end of the question [id]: null for success, or an exception. If [id] is unknown, returns null. */
    fun end(id: String?): CompletableFuture<JasonException?>? = id?.let(open::get)?.end

    /** Stores that [agent] has answered the question [id]. */
    fun answered(id: String, agent: String) {
        open[id]?.asked?.remove(agent)
    }

    /** Fails the question [id], even before its action has called [end]. Returns false if there is no such open question. */
    fun fail(id: String?, reason: Throwable): Boolean = id?.let(open::get)?.end?.complete(errorOf(reason)) ?: false

    /** Fails questions to agents that have left their computers, according to [now], without an answer. */
    fun failLost(now: Directory) = open.forEach { (id, question) ->
        question.asked.entries.find { (agent, computer) -> !now.runs(agent, computer) }?.let { (agent, computer) ->
            val reason = if (now.isMet(computer)) "it has ended there" else "its computer $computer is off"
            fail(id, Unreachable("$agent has not answered, and $reason"))
        }
    }

    /** Ends all questions except [waiting], which intentions still await. Other questions are answered, too old or dropped. */
    fun endAllBut(waiting: Set<String>) = open.keys.filter { it !in waiting }.forEach { open.remove(it)?.end?.complete(null) }
}
