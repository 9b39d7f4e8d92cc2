package argo.view

import kotlinx.serialization.Serializable
import java.net.URLDecoder
import java.util.concurrent.CopyOnWriteArrayList

/** The pages of all agents on one server, and the resources that they share. Safe for use by several threads. */
internal class Site {
    private val pages = CopyOnWriteArrayList<AgentPage>()

    val isEmpty: Boolean get() = pages.isEmpty()

    /** Adds [page], in front of the page of an ending agent with an equal name. */
    fun add(page: AgentPage) = pages.add(0, page)

    fun remove(page: AgentPage) = pages.remove(page)

    /** Returns the tabs of the first [MAX_TABS] agents by name, and the number of the other agents. */
    fun tabs(): Pair<List<AgentTab>, Int> {
        val all = pages.distinctBy { it.path }
        return all.sortedBy { it.agent.name }.take(MAX_TABS).map { it.tab() } to maxOf(0, all.size - MAX_TABS)
    }

    /** Finds the page to which [path] belongs, and the path within the page. [path] is still URL-encoded. */
    fun find(path: String): Found {
        val parts = path.split('/').drop(1) // without the empty text before the first slash
        val name = parts.takeIf { it.size == 2 }?.let { decoded(it[0]) }
        val page = pages.find { it.agent.name == name } ?: return Found(null, path)
        return Found(page, "/${parts[1]}")
    }

    /** Returns the response to [request] for a resource that belongs to no agent. */
    fun respond(request: Request): HttpResponse {
        val respond = when (request.path) {
            "/" -> ::toFirst
            "/agents" -> ({ HttpResponse.json(Agents(pages.map { it.agent.name }.distinct().sorted())) })
            "/view.css" -> ({ file("view.css", "text/css") })
            "/view.js" -> ({ file("view.js", "text/javascript") })
            "/course.js" -> ({ file("course.js", "text/javascript") })
            else -> return HttpResponse.message(404, "there is nothing at ${shown(request.path)}")
        }
        return if (request.method == "GET") respond() else HttpResponse.wrongMethod("GET")
    }

    private fun toFirst(): HttpResponse = pages.minByOrNull { it.agent.name }?.let { HttpResponse.seeOther(it.path) }
        ?: HttpResponse.message(404, "no agent has a view here any more")

    private fun decoded(name: String) = try {
        URLDecoder.decode(name.replace("+", "%2B"), Charsets.UTF_8)
    } catch (_: IllegalArgumentException) {
        null
    }

    /**
     * @property page the agent's page; null if [path] belongs to no agent
     * @property path the path within the page, such as `/events`, or within the site if there is no page
     */
    class Found(val page: AgentPage?, val path: String)

    @Serializable
    private class Agents(val agents: List<String>)

    companion object {
        private const val MAX_TABS = 200

        /** Responds with the resource [name] of this module. */
        fun file(name: String, type: String) =
            HttpResponse(200, type, checkNotNull(Site::class.java.getResource(name)) { "the resource $name is missing" }.readBytes())
    }
}
