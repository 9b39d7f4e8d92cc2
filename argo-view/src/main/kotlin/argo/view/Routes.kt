package argo.view

import argo.filters.FilterException
import argo.filters.FilterNotFoundException
import argo.filters.Problem
import argo.observing.CommandFailure
import argo.observing.ObservedAgent
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import java.net.URLDecoder
import java.util.ServiceConfigurationError
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * Responds to the requests of [agent]'s page and its buttons, except for the stream of states. The thread of a request finds and reads
 * filters; the agent's thread changes the agent. Safe for use by several threads.
 */
internal class Routes(private val agent: ObservedAgent) {
    private val routes: Map<String, Route> = mapOf(
        "/" to Route("GET") { Site.file("view.html", "text/html") },
        "/filters" to Route("GET") { filters() },
        "/explain" to Route("GET") { explain(parametersOf(it.query)["percept"]) },
        "/filter" to Route("POST") { request -> request.read<FilterRequest> { changeFilter(it.name) } },
        "/percepts" to Route("POST") { request -> request.read<PerceivingRequest> { perceive(it.open) } },
        "/command" to Route("POST") { request -> request.read<CommandRequest> { act(it.command) } },
    )

    private val lanes: AgentLanes? by lazy { AgentLanesProvider.find()?.open(agent.name) }

    fun respond(request: Request): HttpResponse {
        if (request.method == "GET") lanes?.respond(request.path, request.query)?.let { return it }
        val route = routes[request.path] ?: return HttpResponse.message(404, "there is nothing at ${shown(request.path)}")
        return if (request.method == route.method) route.respond(request) else HttpResponse.wrongMethod(route.method)
    }

    private inline fun <reified T> Request.read(respond: (T) -> HttpResponse): HttpResponse {
        if (type?.substringBefore(';')?.trim() != HttpResponse.JSON) {
            return HttpResponse.message(415, "the request must be JSON, of type ${HttpResponse.JSON}") // an HTML form cannot send JSON
        }
        if (body.size > MAX_BYTES) return HttpResponse.message(413, "the request is longer than $MAX_BYTES bytes")
        val content = try {
            Json.decodeFromString<T>(body.decodeToString())
        } catch (wrong: SerializationException) {
            return HttpResponse.message(400, "the request cannot be read: ${wrong.message.orEmpty().lineSequence().first()}")
        }
        return respond(content)
    }

    private fun filters() = findingFilters("filters") {
        HttpResponse.json(Filters(agent.filterNames()))
    }

    private fun changeFilter(name: String?) = findingFilters("the filter $name") {
        val filter = name?.let(agent::filter)
        val message = filter?.let { "the agent perceives through the filter ${it.name}" } ?: "the agent perceives everything"
        awaitDone(message) { agent.perceiveThrough(filter, it) }
    }

    private fun findingFilters(what: String, respond: () -> HttpResponse): HttpResponse = try {
        respond()
    } catch (missing: FilterNotFoundException) {
        HttpResponse.message(404, missing.message.orEmpty())
    } catch (refused: FilterException) {
        val files = refused.problems.groupBy { it.source }
        HttpResponse.message(422, files.map { (source, problems) -> listed(source, problems) }.joinToString("\n"))
    } catch (broken: ServiceConfigurationError) {
        HttpResponse.message(500, "a filter provider on the class path cannot be used: ${broken.message}")
    } catch (broken: Exception) { // an unreadable file, or a failure of a provider, which is a project's own code
        HttpResponse.message(500, "looking for $what ended in $broken")
    }

    private fun listed(source: String, problems: List<Problem>) =
        problems.joinToString("\n", "$source is refused:\n") { "line ${it.line}, column ${it.column}: ${it.message}" }

    private fun explain(percept: String?): HttpResponse = try {
        if (percept == null) HttpResponse.message(400, "name the percept: /explain?percept=…")
        else HttpResponse.message(200, agent.explain(percept))
    } catch (wrong: IllegalArgumentException) {
        HttpResponse.message(400, "the percept cannot be read: ${wrong.message}")
    }

    private fun perceive(open: Boolean): HttpResponse {
        val closed = "the agent perceives nothing new; it goes on acting on what it believes"
        return awaitDone(if (open) "the agent perceives again" else closed) { agent.perceive(open, it) }
    }

    /** Has the agent send [command], and waits a while for the outcome. The page's list of commands shows the outcome in any case. */
    private fun act(command: String): HttpResponse {
        val outcome = CompletableFuture<CommandFailure?>()
        agent.act(command, outcome::complete)
        return try {
            val failure = outcome.get(MAX_WAIT_S, TimeUnit.SECONDS) ?: return HttpResponse.message(200, "$command: done")
            HttpResponse.message(422, "$command: ${failure.error}: ${failure.cause}")
        } catch (_: TimeoutException) {
            HttpResponse.message(202, "$command: has not ended within $MAX_WAIT_S s; the list of commands shows its outcome")
        }
    }

    /** Has the agent do something, and waits a while for its thread, which may be busy or not yet running. */
    private fun awaitDone(message: String, ask: (done: () -> Unit) -> Unit): HttpResponse {
        val done = CountDownLatch(1)
        ask(done::countDown)
        if (done.await(MAX_WAIT_S, TimeUnit.SECONDS)) return HttpResponse.message(200, message)
        return HttpResponse.message(202, "asked for; the agent does it in its next reasoning cycle, which has not come for $MAX_WAIT_S s")
    }

    private class Route(val method: String, val respond: (Request) -> HttpResponse)

    @Serializable
    private class Filters(val filters: List<String>)

    @Serializable
    private class FilterRequest(val name: String?)

    @Serializable
    private class CommandRequest(val command: String)

    @Serializable
    private class PerceivingRequest(val open: Boolean)

    companion object {
        /** The longest request body that is read, in bytes. */
        const val MAX_BYTES = 10_000
        private const val MAX_WAIT_S = 3L
    }
}

/**
 * A request of a page.
 *
 * @property query the text behind `?`, still encoded
 * @property type the content type of [body]
 */
internal class Request(val method: String, val path: String, val query: String?, val type: String?, val body: ByteArray)

/** Returns the names and values in [query], the part of the address behind `?`; null: there is none. */
internal fun parametersOf(query: String?): Map<String, String> =
    query.orEmpty().split('&').filter { '=' in it }.associate { it.substringBefore('=') to decoded(it.substringAfter('=')) }

private fun decoded(value: String) = try {
    URLDecoder.decode(value, Charsets.UTF_8)
} catch (_: IllegalArgumentException) {
    value // the text was not encoded
}
