package argo.view

import argo.jason.TestMas
import argo.jason.eventually
import java.net.URI

/** Where the view of [agent] is, by the log. */
internal fun TestMas.viewOf(agent: String): URI {
    val line = Regex("the live view of $agent is at (http://127\\.0\\.0\\.1:\\d+/)")
    eventually({ log }) { line.containsMatchIn(log) }
    return URI(checkNotNull(line.find(log)).groupValues[1])
}

/** The view of [agent], as a project gets at it. */
internal fun TestMas.agentView(agent: String): AgentView = architecture(agent).observers.filterIsInstance<AgentView>().single()
