package argo.view

import argo.filters.FilterException
import argo.filters.FilterNotFoundException
import argo.filters.PerceptionFilter
import argo.observing.ObservedAgent
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import java.io.IOException
import java.net.URLDecoder
import java.util.ServiceConfigurationError
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/**
 * Does for the page what its buttons ask for. Files are looked for and read by the browser's thread, and the agent's does what
 * concerns the agent. Safe for use by several threads.
 */
internal class ViewCommands(private val agent: ObservedAgent) {
    /**
     * Answers a request.
     *
     * @param query what stands behind `?`, still encoded
     * @param type the body's content type: JSON, which no form of another page can send
     */
    fun answer(method: String, path: String, query: String?, type: String?, body: ByteArray): Answer = when (path) {
        "/filters" -> if (method == "GET") filters() else Answer.wrongMethod("GET")
        "/explain" -> if (method == "GET") explain(query) else Answer.wrongMethod("GET")
        "/filter" -> if (method == "POST") asked<FilterWish>(type, body) { changeFilter(it.name) } else Answer.wrongMethod("POST")
        "/percepts" -> if (method == "POST") asked<PerceptsWish>(type, body) { perceive(it.open) } else Answer.wrongMethod("POST")
        else -> Answer.said(404, "there is nothing at ${shown(path)}")
    }

    private inline fun <reified T> asked(type: String?, body: ByteArray, act: (T) -> Answer): Answer {
        if (type?.substringBefore(';')?.trim() != "application/json") return Answer.said(415, "the request must be JSON, of type application/json")
        if (body.size > MOST_BYTES) return Answer.said(413, "the request is longer than $MOST_BYTES bytes")
        val wish = try {
            Json.decodeFromString<T>(body.decodeToString())
        } catch (wrong: SerializationException) {
            return Answer.said(400, "the request cannot be read: ${wrong.message.orEmpty().lineSequence().first()}")
        }
        return act(wish)
    }

    private fun filters(): Answer = try {
        Answer.json(200, Json.encodeToString(Filters.serializer(), Filters(agent.filterNames())))
    } catch (broken: ServiceConfigurationError) {
        Answer.said(500, "a filter provider on the class path cannot be used: ${broken.message}")
    } catch (broken: RuntimeException) { // a provider is a project's own code
        Answer.said(500, "looking for filters ended in $broken")
    }

    private fun explain(query: String?): Answer {
        val percept = query.orEmpty().split('&').find { it.startsWith(PERCEPT) }?.removePrefix(PERCEPT)
            ?: return Answer.said(400, "say which percept: /explain?$PERCEPT…")
        val text = try {
            URLDecoder.decode(percept, Charsets.UTF_8)
        } catch (wrong: IllegalArgumentException) {
            return Answer.said(400, "the percept cannot be read: ${wrong.message}")
        }
        return Answer.said(200, agent.explain(text))
    }

    private fun changeFilter(name: String?): Answer = try {
        changeFilter(name?.let(agent::filter))
    } catch (missing: FilterNotFoundException) {
        Answer.said(404, missing.message.orEmpty())
    } catch (refused: FilterException) {
        Answer.said(422, refused.message.orEmpty())
    } catch (broken: ServiceConfigurationError) {
        Answer.said(500, "a filter provider on the class path cannot be used: ${broken.message}")
    } catch (broken: RuntimeException) { // a provider is a project's own code
        Answer.said(500, "looking for the filter $name ended in $broken")
    } catch (unreadable: IOException) {
        Answer.said(500, "the filter $name cannot be read: $unreadable")
    }

    private fun changeFilter(filter: PerceptionFilter?): Answer =
        done(filter?.let { "the agent perceives through the filter ${it.name}" } ?: "the agent perceives everything") { agent.perceiveThrough(filter, it) }

    private fun perceive(open: Boolean): Answer =
        done(if (open) "the agent perceives again" else "the agent perceives nothing new; it goes on acting on what it believes") { agent.perceive(open, it) }

    /** Has the agent do something and waits a while for its thread, which may have no time or not run yet. */
    private fun done(words: String, wish: (done: () -> Unit) -> Unit): Answer {
        val done = CountDownLatch(1)
        wish(done::countDown)
        return if (done.await(PATIENCE_S, TimeUnit.SECONDS)) Answer.said(200, words)
        else Answer.said(202, "asked for; the agent's next reasoning cycle does it, and the last one has not ended for $PATIENCE_S s")
    }

    @Serializable
    private class Filters(val filters: List<String>)

    @Serializable
    private class FilterWish(val name: String?)

    @Serializable
    private class PerceptsWish(val open: Boolean)

    companion object {
        /** The longest body of a request that is read. */
        const val MOST_BYTES = 10_000
        private const val PERCEPT = "percept="
        private const val PATIENCE_S = 3L
    }
}
