package argo.testkit

import java.nio.file.Path

/**
 * Starts the agent in the file [source] on simulated boards, one on each of its ports, in virtual time:
 *
 *     val robot = agent("robot.asl")
 *     robot.perceives("dist(front,30)")
 *     robot.shouldSend("stop")
 *
 * Jason reads the agent and runs it on `argo.Arch`, as in a project. Only time and the boards are simulated. The agent is named like its
 * file. Close the agent at the end of the test, with `use` or Kotest's `autoClose`.
 *
 * @param source a path from the directory in which the test runs, or from `src/agt`, `src/main/asl` or `src/test/resources` under it
 * @param setUp configures the agent and its boards before the agent starts
 * @throws IllegalArgumentException if there is no such file, or Jason cannot read it
 */
fun agent(source: String, setUp: AgentSetUp.() -> Unit = {}): TestAgent = mas { agent(source, setUp) }.first

/** Starts the agent in [file]: see [agent]. */
fun agent(file: Path, setUp: AgentSetUp.() -> Unit = {}): TestAgent = mas { agent(file, setUp) }.first

/** Starts an agent with [program], like [agent]. The agent's name is `agent` unless [setUp] sets another. */
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
 * All agents exist before the first one runs. Close the result at the end of the test, with `use` or Kotest's `autoClose`.
 *
 * @throws IllegalArgumentException if there is no such file, Jason cannot read it, or two agents have the same name
 */
fun mas(setUp: MasSetUp.() -> Unit): TestMas = TestMas().let { mas -> mas.begin { MasSetUp(mas).setUp() } }
