package argo.watching

import argo.observing.AgentObserver
import argo.observing.ObservedAgent
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.logging.Logger

/**
 * Reloads [agent] whenever a file of its program, or of an active filter, is saved or gone. [log] gets the result. If a file has a mistake,
 * [log] gets the mistake, and the agent continues unchanged.
 */
internal class ProgramWatch(private val agent: ObservedAgent, private val log: Logger) : AgentObserver {
    private val closing = CountDownLatch(1)
    private val saved = SavedFiles()
    private val watcher = Thread(::watch, "argo-${agent.name}-watching").apply { isDaemon = true }

    init {
        val files = agent.sources() // also notes the stamps of the files that Jason has just read
        saved.look(files)
        if (files.isEmpty()) log.warning("no file of the agent is on this computer's disk, so none is watched") else watcher.start()
    }

    private fun watch() {
        while (!closing.await(SavedFiles.LOOK_EACH_MS, TimeUnit.MILLISECONDS)) {
            val files = saved.look(agent.sources())
            if (files.isNotEmpty()) reload(causeOf(files))
        }
    }

    private fun causeOf(files: List<Path>) =
        files.groupBy(::change).map { (change, its) -> its.joinToString { "${it.fileName}" } + change }.joinToString()

    private fun change(file: Path) = if (Files.isRegularFile(file)) " saved" else " gone"

    private fun reload(cause: String) = agent.reload { outcome ->
        val refusal = outcome.refusal
        if (refusal == null) log.info((listOf(cause) + outcome.told).joinToString("\n"))
        else log.warning("$cause, but the agent goes on as it is:\n$refusal")
    }

    override fun close() = closing.countDown()
}
