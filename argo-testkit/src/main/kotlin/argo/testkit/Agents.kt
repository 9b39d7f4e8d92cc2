package argo.testkit

import java.nio.file.Path

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
fun agent(source: String, setUp: AgentSetUp.() -> Unit = {}): TestAgent = mas { agent(source, setUp) }.first

/** Starts the agent in [file]: see [agent]. */
fun agent(file: Path, setUp: AgentSetUp.() -> Unit = {}): TestAgent = mas { agent(file, setUp) }.first

/** Starts an agent with [program], as [agent] does; it is called `agent` unless [setUp] says otherwise. */
fun agentOf(program: String, setUp: AgentSetUp.() -> Unit = {}): TestAgent = mas { agentOf("agent", program, setUp) }.first

/**
 * Starts agents that speak with each other, in one time:
 *
 *     val fleet = mas {
 *         agent("coordinator.asl")
 *         agent("scout.asl") { name = "scout1" }
 *     }
 *     fleet["coordinator"].hears("user", "achieve", "patrol")
 *     fleet["scout1"].shouldSend("goto(north)")
 *
 * All are there before the first one runs. Close it at the end of the test, by `use` or Kotest's `autoClose`.
 *
 * @throws IllegalArgumentException if there is no such file, Jason cannot read it, or two agents have the same name
 */
fun mas(setUp: MasSetUp.() -> Unit): TestMas = TestMas().let { mas -> mas.begin { MasSetUp(mas).setUp() } }
