package argo.recording.recorder

import argo.observing.AgentObserver
import argo.observing.AgentObserverProvider
import argo.observing.ObservedAgent
import java.io.IOException
import java.nio.file.InvalidPathException
import java.util.logging.Logger

/** Records agents with the option `argo_record`. Agents with equal values share one recording. */
class RecorderProvider : AgentObserverProvider {
    override val option = "argo_record"
    override val usage = "a file such as \"drive.mcap\", or \"last(5)\" for the last five minutes"

    override fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver? {
        val wanted = value.trim().removeSurrounding("\"").filterNot(Char::isWhitespace)
        fun refuse(reason: String) = null.also { log.severe("$option=$value: $reason; the agent runs without a recording") }
        if (!wanted.endsWith(".mcap") && !SharedRecording.LAST.matches(wanted)) return refuse("it takes $usage")
        refusalOfClasses(agent.reasoning)?.let { return refuse(it) }
        val recording = try {
            SharedRecording.join(wanted, log)
        } catch (trouble: IOException) {
            return refuse("the file cannot be made: ${wordsOf(trouble)}")
        } catch (trouble: InvalidPathException) {
            return refuse("that is no name of a file (${trouble.message})")
        }
        val program = try {
            storeProgram(agent.reasoning, recording.sink)
        } catch (trouble: IOException) {
            recording.leave()
            return refuse("the agent's program cannot be recorded: ${trouble.message}")
        }
        return Recorder(agent, program, AgentChannels(agent.name, recording, agent::nanos, log::warning), log)
    }
}
