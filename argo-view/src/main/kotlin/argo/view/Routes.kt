package argo.view

import argo.filters.FilterException
import argo.filters.FilterNotFoundException
import argo.filters.Problem
import argo.observing.CommandFailure
import argo.observing.ObservedAgent
import kotlinx.serialization.Serializable
import java.net.URLDecoder
import java.util.ServiceConfigurationError

/**
 * Responds to the requests of [agent]'s page and its buttons, except for the stream of states. The thread of a request finds and reads
 * filters. The agent's thread changes the agent. Safe for use by several threads.
 */
internal class Routes(private val agent: ObservedAgent, buttons: ButtonRoutes) {
    private val routes: Map<String, Route> = mapOf(
        "/" to Route.get { Site.file("view.html", "text/html") },
        "/filters" to Route.get { filters() },
        "/explain" to Route.get { explain(parametersOf(it.query)["percept"]) },
        "/filter" to Route.post<FilterRequest> { changeFilter(it.name) },
        "/percepts" to Route.post<PerceivingRequest> { perceive(it.open) },
        "/command" to Route.post<CommandRequest> { act(it.command) },
    ) + buttons.routes

    private val lanes: AgentLanes? by lazy { AgentLanesProvider.find()?.open(agent.name) }

    fun respond(request: Request): HttpResponse {
        if (request.method == "GET") lanes?.respond(request.path, request.query)?.let { return it }
        val route = routes[request.path] ?: return HttpResponse.message(404, "there is nothing at ${shown(request.path)}")
        return if (request.method == route.method) route.respond(request) else HttpResponse.wrongMethod(route.method)
    }

    private fun filters() = findingFilters("filters") {
        HttpResponse.json(Filters(agent.filterNames()))
    }

    private fun changeFilter(name: String?) = findingFilters("the filter $name") {
        val filter = name?.let(agent::filter)
        val message = filter?.let { "the agent perceives through the filter ${it.name}" } ?: "the agent perceives everything"
        Route.awaited { answer -> agent.perceiveThrough(filter) { answer(HttpResponse.message(200, message)) } }
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
    } catch (broken: Exception) { // the file is unreadable, or the project's own provider has failed
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
        val message = if (open) "the agent perceives again" else closed
        return Route.awaited { answer -> agent.perceive(open) { answer(HttpResponse.message(200, message)) } }
    }

    /** Makes the agent send [command], and waits some seconds for the outcome. The page's list of commands shows the outcome even later. */
    private fun act(command: String): HttpResponse {
        val later = "$command: has not ended within ${Route.MAX_WAIT_S} s; the list of commands shows its outcome"
        return Route.awaited(later) { answer -> agent.act(command) { answer(outcome(command, it)) } }
    }

    private fun outcome(command: String, failure: CommandFailure?) =
        if (failure == null) HttpResponse.message(200, "$command: done")
        else HttpResponse.message(422, "$command: ${failure.error}: ${failure.cause}")

    @Serializable
    private class Filters(val filters: List<String>)

    @Serializable
    private class FilterRequest(val name: String?)

    @Serializable
    private class CommandRequest(val command: String)

    @Serializable
    private class PerceivingRequest(val open: Boolean)
}

/**
 * A request of a page.
 *
 * @property query the text after `?`, still encoded
 * @property type the content type of [body]
 */
internal class Request(val method: String, val path: String, val query: String?, val type: String?, val body: ByteArray)

/** Returns the names and values in [query], the part of the address after `?`; null if there is none. */
internal fun parametersOf(query: String?): Map<String, String> =
    query.orEmpty().split('&').filter { '=' in it }.associate { it.substringBefore('=') to decoded(it.substringAfter('=')) }

private fun decoded(value: String) = try {
    URLDecoder.decode(value, Charsets.UTF_8)
} catch (_: IllegalArgumentException) {
    value // the text was not encoded
}
