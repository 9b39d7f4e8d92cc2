package argo.recording

import argo.recording.replay.Difference
import argo.recording.replay.Recording
import argo.recording.replay.RefusedCycle
import argo.recording.replay.Replay
import argo.testkit.AgentSetUp
import argo.testkit.TestAgent
import argo.testkit.TestMas
import argo.testkit.agentOf
import argo.testkit.mas
import io.kotest.assertions.withClue
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.nio.file.Path
import kotlin.io.path.createTempDirectory

/** The directory for all recordings, deleted after the tests. */
private val DIRECTORY: Path by lazy {
    createTempDirectory("argo-recording-spec").also { made ->
        Runtime.getRuntime().addShutdownHook(Thread { made.toFile().deleteRecursively() })
    }
}

internal fun recordingFile(): Path = createTempDirectory(DIRECTORY, "drive").resolve("drive.mcap")

internal fun recorded(program: String, setUp: AgentSetUp.() -> Unit = {}, drive: TestAgent.() -> Unit): Path {
    val file = recordingFile()
    agentOf(program) {
        setUp()
        options("argo_record" to "$file")
    }.use { it.drive() }
    return file
}

internal fun recordedMas(vararg agents: Pair<String, String>, drive: TestMas.() -> Unit): Path {
    val file = recordingFile()
    mas {
        for ((name, program) in agents) agentOf(name, program.trimIndent()) { options("argo_record" to "$file") }
    }.use { it.drive() }
    return file
}

/** Fails if the replay of [file] differs from the recording. [isChecking] is as in [replayOf]. */
internal fun shouldReplay(file: Path, isChecking: Boolean = false) {
    val outcome = replayOf(file, isChecking)
    withClue(outcome.differences.joinToString("\n")) { outcome.differences.shouldBeEmpty() }
    outcome.cycles shouldBe outcome.recorded.toLong()
    outcome.cycles shouldBeGreaterThan 0L
}

/** The outcome of a replay: the numbers of replayed and recorded cycles, the differences, and the refused cycles. */
internal class Outcome(val cycles: Long, val recorded: Int, val differences: List<Difference>, val refusals: List<RefusedCycle>)

/** Replays the whole recording [file]. With [isChecking], runs the test's own code again. */
internal fun replayOf(file: Path, isChecking: Boolean = false): Outcome = Recording(file).use { recording ->
    Replay(recording, isChecking).use { replay ->
        replay.run()
        Outcome(replay.cyclesRun, recording.agents.keys.sumOf { recording.cycles(it).count() }, replay.differences, replay.refusals)
    }
}
