package argo.ros

import argo.links.JavinoLink
import argo.ros.bridge.LimitedWarnings
import argo.ros.bridge.flag
import argo.ros.bridge.operationIn
import argo.ros.bridge.text
import argo.ros.joining.BridgeAddress
import argo.ros.joining.JoinedBoard
import argo.ros.joining.Membership
import argo.ros.joining.Participant
import argo.ros.joining.Topics
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.booleans.shouldBeTrue
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.link.Link
import javino.link.LinkSettings
import javino.sim.SimulatedBoards
import javino.sim.Sketch
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.net.ServerSocket
import java.net.Socket
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.TimeUnit
import kotlin.time.Duration.Companion.minutes

private const val PYTHON = "/usr/bin/python3" // Debian's Python, which has rospy
private const val ROSCORE = "/usr/bin/roscore"
private const val NEEDED = "import rospy, rosservice, actionlib, tornado, sensor_msgs, std_srvs"

/** The sources of `rosbridge_suite`, branch `ros1`, if this folder exists. No package registry has them. */
private val SUITE: Path? = Path.of("build/rosbridge_suite").takeIf(Files::isDirectory)

/**
 * Runs a ROS 1 graph on this computer: a roscore, the robot of `src/test/ros/robot.py` and a bridge. The bridge is that of [SUITE] or else
 * `src/test/ros/bridge.py`.
 */
private class RosGraph : AutoCloseable {
    private val logs: Path = Files.createTempDirectory("argo-ros-core")
    private val messages = logs.resolve("messages")
    private val packages = logs.resolve("packages")
    private val master = freePort()
    private val processes = HashMap<String, Process>()
    val bridge = freePort()

    suspend fun start() {
        startCore()
        run("messages.py", "argo_msgs", "$messages")
        begin("robot", PYTHON, "src/test/ros/robot.py")
        if (SUITE == null) begin("bridge", PYTHON, "src/test/ros/bridge.py", "$bridge") else startSuite(SUITE)
        awaitPort(bridge)
    }

    private fun startSuite(suite: Path) {
        listOf("src/test/ros/rosauth", "$suite/rosbridge_msgs", "$suite/rosapi").forEach { run("messages.py", it, "$messages") }
        PACKAGES.forEach(::describe)
        beginApi(suite)
        begin("bridge", PYTHON, "$suite/rosbridge_server/scripts/rosbridge_websocket.py", "--address", "127.0.0.1", "--port", "$bridge")
    }

    private fun beginApi(suite: Path) = begin("rosapi", PYTHON, "$suite/rosapi/scripts/rosapi_node")

    /** Writes the description of the package [name]. Rosbridge needs it to load messages, and Debian's Python packages lack it. */
    private fun describe(name: String) {
        val maintainer = "<maintainer email=\"a@example.org\">a</maintainer>"
        val rest = "<version>0.0.0</version><description>$name</description>$maintainer<license>a</license>"
        val folder = Files.createDirectories(packages.resolve(name))
        Files.writeString(folder.resolve("package.xml"), "<package><name>$name</name>$rest</package>")
    }

    suspend fun startCore() {
        begin("core", PYTHON, ROSCORE, "-p", "$master")
        awaitPort(master)
        if (SUITE == null || "rosapi" !in processes) return
        end("rosapi") // rosapi does not register with a new roscore
        beginApi(SUITE)
    }

    private fun begin(name: String, vararg command: String) {
        processes[name] = builder(*command).redirectOutput(logs.resolve("$name.log").toFile()).redirectErrorStream(true).start()
    }

    fun run(script: String, vararg arguments: String): String {
        val process = builder(PYTHON, "src/test/ros/$script", *arguments).redirectErrorStream(true).start()
        val lines = process.inputStream.bufferedReader().readLines()
        withClue(lines) { process.waitFor() shouldBe 0 }
        return lines.lastOrNull().orEmpty()
    }

    private fun builder(vararg command: String) = ProcessBuilder(*command).apply {
        environment() += mapOf(
            "ROS_MASTER_URI" to "http://127.0.0.1:$master", "ROS_HOSTNAME" to "127.0.0.1", "ROS_LOG_DIR" to "$logs",
            "ROS_PACKAGE_PATH" to "/usr/share:$packages:$SUITE:argo_msgs", "PYTHONUNBUFFERED" to "1",
            "PYTHONPATH" to "$messages:$SUITE/rosbridge_library/src:$SUITE/rosbridge_server/src",
        )
    }

    fun end(name: String) {
        val process = processes.remove(name) ?: return
        val all = process.descendants().toList() + process.toHandle()
        all.forEach(ProcessHandle::destroy)
        process.waitFor(5, TimeUnit.SECONDS)
        all.filter { it.isAlive }.forEach(ProcessHandle::destroyForcibly)
    }

    private suspend fun awaitPort(number: Int) = eventually(LIMIT) { Socket("127.0.0.1", number).close() }

    /** Runs [block]. If it fails, prints [told] and the output of the processes. */
    suspend fun <T> showingLogs(told: Iterable<String> = emptyList(), block: suspend () -> T): T = try {
        block()
    } catch (failed: Throwable) {
        println((told + log()).joinToString("\n"))
        throw failed
    }

    private fun log(): String = Files.list(logs).use { files -> files.filter { "$it".endsWith(".log") }.toList() }
        .joinToString("\n") { "--- ${it.fileName}\n${Files.readString(it).takeLast(SHOWN)}" }

    override fun close() {
        listOf("bridge", "rosapi", "robot", "core").forEach(::end)
        logs.toFile().deleteRecursively()
    }

    private fun freePort() = ServerSocket(0).use { it.localPort }

    private companion object {
        const val SHOWN = 2_000
        val PACKAGES = listOf("actionlib", "rosauth", "roscpp", "std_srvs") +
            listOf("actionlib", "geometry", "rosgraph", "sensor", "std").map { "${it}_msgs" }
    }
}

private class Blinker : Sketch {
    private var count = 0
    val done = ConcurrentLinkedQueue<String>()

    override fun percepts() = listOf("count(${++count})", "ready")

    override fun act(command: String) = (command == "stop" || command.startsWith("blink(")).also { if (it) done += command }
}

/** A board of [sketch] that takes part in a graph as `/uno`, with known actions. */
private class Uno(bridge: Int, private val sketch: Blinker) : AutoCloseable {
    val told = ConcurrentLinkedQueue<String>()
    private val warn = LimitedWarnings { told += it }
    private val topics = Topics(warn)
    private val board = JoinedBoard("uno", "sim:$NAME", topics, 20, 500, false, ::open, { told += it }, warn)
    private val known = object : Participant by board {
        override val actions = listOf(BoardAction("stop", 0), BoardAction("blink", 1))
    }
    private val membership = Membership(known, topics, BridgeAddress.of("127.0.0.1:$bridge"), { told += it }, warn)

    init {
        SimulatedBoards.plugIn(NAME, sketch)
        board.start()
        membership.start()
    }

    private fun open() = JavinoLink(Link.open("sim:$NAME", LinkSettings.defaults().withBaud(115_200), "ros-join"))

    override fun close() {
        membership.close()
        board.close()
        SimulatedBoards.unplug(NAME)
    }

    private companion object {
        const val NAME = "blinker"
    }
}

@Tags("Thorough")
class RosCoreSpec : FunSpec({
    val missing: String? by lazy {
        when {
            !Files.exists(Path.of(ROSCORE)) -> "there is no roscore; Debian's package ros-core has it"
            ProcessBuilder(PYTHON, "-c", NEEDED).redirectErrorStream(true).start().waitFor() != 0 -> "Python cannot $NEEDED"
            else -> null
        }
    }

    test("an agent perceives and commands a robot on a real ROS graph").config(
        enabledOrReasonIf = { missing?.let(Enabled::disabled) ?: Enabled.enabled }, blockingTest = true,
    ) {
        RosGraph().use { graph ->
            graph.showingLogs {
                graph.start()
                val program = """
                    !start.
                    +!start <-
                        argo.port("ros://127.0.0.1:${graph.bridge}#graph"); argo.limit(50); argo.percepts(open).
                    +clients(N) : N > 0 & not begun <-
                        +begun;
                        !try(move(0.5, 0.25)); !try(horn); !try(lamp(true)); !try(lamp(false)); !try(none);
                        !try(drive(2)); !try(drive(-2)); !try(drive(0)); !try(dash(500)); +tried.
                    +!try(C) <- argo.act(C); +outcome(C, done).
                    -!try(C)[error(E)] <- +outcome(C, E).
                """
                Mas(program).use { mas ->
                    mas.awaitBelief("tried")
                    mas.beliefs().filter { it.startsWith("outcome(") }.toSet() shouldBe setOf(
                        "outcome(move(0.5,0.25),done)", "outcome(horn,done)", "outcome(lamp(true),done)", "outcome(lamp(false),act_failed)",
                        "outcome(none,act_failed)", "outcome(drive(2),done)", "outcome(drive(-2),act_failed)",
                        "outcome(drive(0),act_refused)", "outcome(dash(500),act_unconfirmed)",
                    )
                    mas.awaitBelief("scan(0.75)")
                    mas.awaitBelief("driven(0.5,0.25)")
                    withClue(mas.beliefs()) { mas.beliefs().any { it.startsWith("dist(f,") }.shouldBeTrue() }
                }
            }
        }
    }

    test("an agent binds the answers of eight services on a real ROS graph, and cancels the goal of a dropped intention").config(
        enabledOrReasonIf = { missing?.let(Enabled::disabled) ?: Enabled.enabled }, blockingTest = true,
    ) {
        RosGraph().use { graph ->
            graph.showingLogs {
                graph.start()
                val program = """
                    !start.
                    +!start <- argo.port("ros://127.0.0.1:${graph.bridge}#graph"); argo.limit(50); argo.percepts(open).
                    +clients(N) : N > 0 & not begun <-
                        +begun; !ask(horn); !ask(lamp(true)); !ask(rest); !ask(camera("fisheye")); !ask(loggers); !ask(level("info"));
                        !ask(topics); !ask(services); !ask(drive(2)); +asked; !far.
                    +!ask(C) <- argo.act(C, [answer(A)]); +answer(C, A).
                    -!ask(C)[error(E)] <- +answer(C, E).
                    +!far <- argo.act(drive(500)).
                    +driving(250) <- .drop_intention(far).
                """
                Mas(program).use { mas ->
                    mas.awaitBelief("asked")
                    mas.beliefs().filter { it.startsWith("answer(") }.toSet() shouldBe setOf(
                        "answer(horn,\"it sounds\")", "answer(lamp(true),[success(true),message(\"\")])", "answer(rest,[])",
                        "answer(camera(\"fisheye\"),said(true,\"fisheye\"))", "answer(loggers,\"INFO\")", "answer(level(\"info\"),[])",
                        "answer(topics,true)", "answer(services,true)", "answer(drive(2),2)",
                    )
                    mas.awaitBelief("cancelled(500)")
                    mas.awaitNoBelief("driving(250)")
                }
            }
        }
    }

    test("a board takes part in a real ROS graph, used by rostopic, rosservice and actionlib, and again after a restart of roscore").config(
        enabledOrReasonIf = { missing?.let(Enabled::disabled) ?: Enabled.enabled }, blockingTest = true,
    ) {
        RosGraph().use { graph ->
            graph.start()
            val sketch = Blinker()
            Uno(graph.bridge, sketch).use { uno ->
                graph.showingLogs(uno.told) {
                    suspend fun awaitUno() = eventually(3.minutes) {
                        graph.run("services.py").split(' ') shouldContainAll listOf("/uno/act", "/uno/blink", "/uno/stop")
                    }
                    awaitUno()
                    val seen = operationIn(graph.run("client.py")).shouldNotBeNull()
                    withClue(seen) {
                        seen.texts("topics") shouldContainAll
                            listOf("/uno/count", "/uno/ready", "/uno/percepts", "/uno/port", "/uno/blink/command", "/uno/command")
                        seen.texts("services") shouldContainAll listOf("/uno/act", "/uno/blink", "/uno/stop")
                        seen.text("type") shouldBe "std_msgs/Float64"
                        seen.text("port").orEmpty() shouldContain "data: \"on\""
                        seen.text("count").orEmpty().lines().first().toDouble() shouldBeGreaterThan 0.0
                        listOf("stop", "blink", "act").forEach { withClue(it) { seen.text(it).orEmpty() shouldContain "success: True" } }
                        seen.text("refused").orEmpty() shouldContain "act_refused"
                        seen.flag("server") shouldBe true
                        seen.texts("states") shouldBe listOf("3", "4") // succeeded, aborted
                        seen.text("result").orEmpty() shouldContain "act_refused"
                    }
                    sketch.done.toList() shouldBe listOf("stop", "blink(1)", "blink(2)", "blink(3)", "blink(4)")
                    graph.end("core")
                    graph.startCore()
                    awaitUno()
                    uno.told.any { "has lost its topics" in it }.shouldBeTrue()
                    operationIn(graph.run("client.py")).shouldNotBeNull().text("act").orEmpty() shouldContain "success: True"
                }
            }
        }
    }
})

private fun JsonObject.texts(name: String) = (get(name) as JsonArray).map { it.jsonPrimitive.content }
