package argo.view

import argo.observing.ObservedAgent
import java.net.URLEncoder

/** The page of one agent. [routes] responds to its requests, and the page receives [states] as a stream. */
internal class AgentPage(val agent: ObservedAgent) {
    val breakpoints = PageBreakpoints(agent)
    val routes = Routes(agent, ButtonRoutes(agent, breakpoints))
    val states = Broadcast()

    /** The page's path on its server, such as `/bob/`. */
    val path: String = "/${URLEncoder.encode(agent.name, Charsets.UTF_8).replace("+", "%20")}/"

    /** Returns the tab for this agent on the pages of other agents. */
    fun tab() = AgentTab(agent.name, agent.isPerceiving && agent.ports().any { it.isPerceived && (it.isStale || it.status != "on") })
}
