package argo.view

import java.util.ServiceLoader

/** Responds to requests for the timeline of one running agent. Safe for use by several threads. */
internal interface AgentLanes {
    /** Returns the response to a GET of [path], such as `/timeline`; null if [path] is no part of the timeline. */
    fun respond(path: String, query: String?): HttpResponse?
}

/** Makes [AgentLanes]. The provider is a service, so recordings may be missing on the class path. */
internal interface AgentLanesProvider {
    fun open(agent: String): AgentLanes

    companion object {
        /** The provider of this program; null if there is none. */
        fun find(): AgentLanesProvider? =
            ServiceLoader.load(AgentLanesProvider::class.java, AgentLanesProvider::class.java.classLoader).firstOrNull()
    }
}
