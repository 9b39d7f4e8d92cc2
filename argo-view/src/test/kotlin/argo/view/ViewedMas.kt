package argo.view

import argo.jason.LocalMas
import java.net.URI
import kotlin.time.Duration.Companion.seconds

/** The longest wait of a test. Even a slow machine needs less time. */
internal val LIMIT = 60.seconds

/** A real Jason in this process, for agents with live views. Only one may exist at a time. */
internal class ViewedMas : LocalMas() {
    override fun agent(name: String, program: String, options: Map<String, String>, behind: String?) =
        super.agent(name, program, mapOf("argo_view" to "0") + options, behind)

    fun agentView(name: String): AgentView = arch(name).observers.filterIsInstance<AgentView>().single()

    fun viewOf(name: String): URI {
        val line = Regex("the live view of $name is at (http://127\\.0\\.0\\.1:\\d+/\\S+/)").find(log)
        return URI(checkNotNull(line) { log }.groupValues[1])
    }
}
