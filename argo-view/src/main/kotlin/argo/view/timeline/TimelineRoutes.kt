package argo.view.timeline

import argo.view.HttpResponse
import argo.view.Site
import kotlinx.serialization.Serializable

/**
 * Responds to the requests of the page of [timeline].
 *
 * @param name the name of the recording, or of the running agent
 * @param problems the parts of the recording that cannot be read
 * @param why explains why a command was sent
 * @property number counts the timelines of a running agent, from 1; 0 for the timeline of a file
 */
internal class TimelineRoutes(
    private val timeline: Timeline,
    private val name: String,
    problems: List<String>,
    private val why: ToldWhy,
    val number: Int = 0,
) {
    private val contents = Contents(name, timeline.agents, timeline.seconds, timeline.items.size, problems, number)

    fun respond(path: String, parameters: Map<String, String>): HttpResponse = when (path) {
        "/" -> page()
        "/recording" -> HttpResponse.json(contents)
        "/items" -> items(parameters)
        "/item" -> item(parameters)
        "/why" -> why.respond(parameters)
        else -> file(path) ?: HttpResponse.message(404, "there is nothing here; the timeline is at /")
    }

    private fun items(parameters: Map<String, String>): HttpResponse {
        val from = parameters["from"]?.toDoubleOrNull()?.takeIf { it.isFinite() }
        val until = parameters["until"]?.toDoubleOrNull()?.takeIf { it.isFinite() }
        if (from == null || until == null || until <= from) {
            return HttpResponse.message(400, "from and until are seconds, as in /items?from=0&until=10")
        }
        val most = parameters["most"]?.toIntOrNull()?.coerceIn(1, MOST_ITEMS) ?: MOST_ITEMS
        return HttpResponse.json(timeline.between(from, until, most))
    }

    /** Responds with an item and its links. The item is `id`, or the item before or after it. */
    private fun item(parameters: Map<String, String>): HttpResponse {
        val command = parameters["command"]?.toLongOrNull()
        val id = if (command == null) parameters["id"]?.toIntOrNull() else timeline.command(name, command)
        val wanted = when (parameters["beside"]) {
            null -> id
            "after" -> id?.let { timeline.beside(it, isAfter = true) }
            else -> id?.let { timeline.beside(it, isAfter = false) }
        }
        val related = wanted?.let { timeline.related(it, MOST_RELATED) } ?: return HttpResponse.message(404, "there is no such item")
        return HttpResponse.json(related)
    }

    @Serializable
    private class Contents(
        val name: String, val agents: List<String>, val seconds: Double, val items: Int, val problems: List<String>, val number: Int,
    )

    companion object {
        private const val MOST_ITEMS = 2_000
        private const val MOST_RELATED = 300

        fun page(): HttpResponse = Site.file("timeline.html", "text/html")

        /** Responds with the file [path] of the page; null if the page has no file with this path. */
        fun file(path: String): HttpResponse? = when (path) {
            "/view.css" -> Site.file("view.css", "text/css")
            "/timeline.css" -> Site.file("timeline.css", "text/css")
            "/timeline.js" -> Site.file("timeline.js", "text/javascript")
            else -> null
        }
    }
}
