package argo.behaviour

import argo.filters.PerceptionFilter
import argo.observing.AgentObserver
import argo.observing.AgentObserverProvider
import argo.observing.CommandFailure
import argo.observing.EndedReflex
import argo.observing.IssuedCommand
import argo.observing.ObservedAgent
import argo.observing.PerceivedMessage
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.logging.Logger

/** Writes one line for each call except [cycleFinished]. */
internal class Diary(val agent: ObservedAgent) : AgentObserver {
    val lines = ConcurrentLinkedQueue<String>()

    override fun messageFiltered(message: PerceivedMessage) = note("filtered ${words(message)}")
    override fun messagePerceived(message: PerceivedMessage) = note("perceived ${words(message)}")
    override fun commandIssued(command: IssuedCommand) = note("issued ${command.number} ${command.text} on ${command.port}")
    override fun commandEnded(command: IssuedCommand, failure: CommandFailure?) =
        note("ended ${command.number} ${failure?.error ?: "well"}")
    override fun portChanged(port: String, status: String, reason: String?) = note("port $port $status")
    override fun filterChanged(filter: PerceptionFilter?) = note("filter ${filter?.name}")
    override fun reflexEnded(reflex: EndedReflex) =
        note("reflex ${reflex.rule.reflex} by ${reflex.watcher.word} ${reflex.failure?.error ?: "well"}")
    override fun close() = note("closed")

    private fun words(message: PerceivedMessage) =
        "${message.texts} kept ${message.kept} unreadable ${message.unreadable} of ${message.portName}"

    private fun note(line: String) {
        lines += line
    }
}

internal class Broken : AgentObserver {
    override fun messageFiltered(message: PerceivedMessage) = error("broken")
    override fun messagePerceived(message: PerceivedMessage) = throw StackOverflowError("broken")
    override fun commandIssued(command: IssuedCommand) = throw NoClassDefFoundError("broken")
    override fun commandEnded(command: IssuedCommand, failure: CommandFailure?) = error("broken")
    override fun portChanged(port: String, status: String, reason: String?) = error("broken")
    override fun filterChanged(filter: PerceptionFilter?) = error("broken")
    override fun reflexEnded(reflex: EndedReflex) = error("broken")
    override fun cycleFinished() = error("broken")
    override fun close() = error("broken")
    override fun toString() = "an observer that throws"
}

/** Opens a [Diary] for `argo_diary`, or nothing for the value `none`. */
internal class DiaryProvider : AgentObserverProvider {
    override val option = "argo_diary"
    override val usage = "a word"
    override fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver? =
        if (value == "none") null else Diary(agent).also { opened[value] = it }

    companion object {
        val opened = ConcurrentHashMap<String, Diary>()
    }
}

/** Opens a [Broken] for `argo_broken`, or throws for the value `open`. */
internal class BrokenProvider : AgentObserverProvider {
    override val option = "argo_broken"
    override val usage = "a word"
    override fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver? =
        if (value == "open") throw NoClassDefFoundError("org/missing/Library") else Broken()
}
