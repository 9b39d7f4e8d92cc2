package argo.view

import argo.observing.AgentObserverProvider
import argo.observing.ObservedAgent
import jason.architecture.MindInspectorWeb
import java.io.IOException
import java.net.BindException
import java.util.concurrent.atomic.AtomicBoolean
import java.util.logging.Logger

/** Opens the live views of agents with the option `argo_view`. */
class AgentViewProvider : AgentObserverProvider {
    override val option = "argo_view"
    override val usage = "a port number"

    override fun open(value: String, agent: ObservedAgent, log: Logger): AgentView? {
        fun refuse(reason: String) = null.also { log.severe("$option=$value: $reason; the agent runs without a view") }
        val port = value.trim().toIntOrNull()?.takeIf { it in 0..MAX_PORT }
            ?: return refuse("a view has the number of a port from 0 to $MAX_PORT, 0 being any that is free, as in $option=8080")
        return try {
            AgentView(agent, port, log).also {
                log.info("the live view of ${agent.name} is at ${it.address}")
                if (MindInspectorWeb.isRunning() && !hasToldOfInspector.getAndSet(true)) log.info(besideInspector())
            }
        } catch (taken: BindException) {
            refuse("port $port cannot be had, it is in use or not allowed (${taken.message}); choose another, or 0 for any that is free")
        } catch (trouble: IOException) {
            refuse("the view cannot be opened ($trouble)")
        } catch (missing: LinkageError) { // this Java runtime was linked without the HTTP server
            refuse("this Java has no HTTP server, which is in its module jdk.httpserver ($missing)")
        }
    }

    private companion object {
        const val MAX_PORT = 65535
        val hasToldOfInspector = AtomicBoolean() // the program has one inspector for all agents

        fun besideInspector() =
            "the live view is for this computer only, but Jason's mind inspector beside it, at ${MindInspectorWeb.getURL()}, listens on " +
                "all network addresses and shows everybody what the agents believe and intend; the argument --no-net starts none"
    }
}
