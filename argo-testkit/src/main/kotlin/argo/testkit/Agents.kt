package argo.testkit

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createTempDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.writeText

/**
 * Starts the agent in the file [source] with a board of the test's own on each of its ports, in a time of the test's own:
 *
 *     val robot = agent("robot.asl")
 *     robot.perceives("dist(front,30)")
 *     robot.shouldSend("stop")
 *
 * It is read by Jason and runs on `argo.Arch`, as in a project; only time and the far ends of its lines are not real. It is called as its
 * file is. Close it at the end of the test, by `use` or Kotest's `autoClose`.
 *
 * @param source looked for in the directory that the test runs in, in `src/agt`, `src/main/asl` and `src/test/resources` under it
 * @param setUp says what the agent is like and what it finds when it starts
 * @throws IllegalArgumentException if there is no such file, or Jason cannot read it
 */
fun agent(source: String, setUp: AgentSetUp.() -> Unit = {}): TestAgent {
    val places = DIRECTORIES.map { Path.of(it, source) }
    val file = places.firstOrNull { it.isRegularFile() }
        ?: throw IllegalArgumentException("there is no agent $source; looked for ${places.joinToString { "${it.toAbsolutePath().normalize()}" }}")
    return agent(file, setUp)
}

/** Starts the agent in [file]: see [agent]. */
fun agent(file: Path, setUp: AgentSetUp.() -> Unit = {}): TestAgent {
    require(file.isRegularFile()) { "there is no agent ${file.toAbsolutePath().normalize()}" }
    return TestAgent.start(file.toAbsolutePath().normalize(), file.nameWithoutExtension, setUp)
}

/** Starts an agent with [program], as [agent] does; it is called `agent` unless [setUp] says otherwise. */
fun agentOf(program: String, setUp: AgentSetUp.() -> Unit = {}): TestAgent {
    val directory = createTempDirectory("argo-testkit")
    val file = directory.resolve("agent.asl").apply { writeText(program) }
    try {
        return TestAgent.start(file, "agent", setUp)
    } finally {
        Files.delete(file)
        Files.delete(directory)
    }
}

private val DIRECTORIES = listOf("", "src/agt", "src/main/asl", "src/test/resources")
