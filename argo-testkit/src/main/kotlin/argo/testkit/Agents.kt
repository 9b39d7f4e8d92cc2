package argo.testkit

import java.nio.file.Path

/**
 * Starts the agent in the file [source] in virtual time. Each of its ports has a simulated board:
 *
 *     val robot = agent("robot.asl")
 *     robot.perceives("dist(front,30)")
 *     robot.shouldSend("stop")
 *
 * Jason reads and runs the agent on `argo.Arch`, as in a project. Only time and the boards are simulated. The agent is named like its file.
 * Close the agent at the end of the test, with `use` or Kotest's `autoClose`.
 *
 * @param source a path from the test's working directory, or from `src/agt`, `src/main/asl` or `src/test/resources` below it
 * @param setUp configures the agent and its boards before the start
 * @throws IllegalArgumentException if the file does not exist, or if Jason cannot read it
 */
fun agent(source: String, setUp: AgentSetUp.() -> Unit = {}): TestAgent = mas { agent(source, setUp) }.first

/** Starts the agent in [file] as [agent] does. */
fun agent(file: Path, setUp: AgentSetUp.() -> Unit = {}): TestAgent = mas { agent(file, setUp) }.first

/** Starts an agent with the text [program] as [agent] does. The agent's name is `agent`, unless [setUp] sets another one. */
fun agentOf(program: String, setUp: AgentSetUp.() -> Unit = {}): TestAgent = mas { agentOf("agent", program, setUp) }.first

/**
 * Starts agents that exchange messages, in one virtual time:
 *
 *     val fleet = mas {
 *         agent("coordinator.asl")
 *         agent("scout.asl") { name = "scout1" }
 *     }
 *     fleet["coordinator"].hears("user", "achieve", "patrol")
 *     fleet["scout1"].shouldSend("goto(north)")
 *
 * All agents are made before the first one runs. Close the result at the end of the test, with `use` or Kotest's `autoClose`.
 *
 * @throws IllegalArgumentException if a file does not exist or cannot be read, or if two agents have one name
 */
fun mas(setUp: MasSetUp.() -> Unit): TestMas = TestMas().let { mas -> mas.begin { MasSetUp(mas).setUp() } }
