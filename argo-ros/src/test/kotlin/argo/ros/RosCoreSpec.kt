package argo.ros

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.booleans.shouldBeTrue
import io.kotest.matchers.shouldBe
import java.net.ServerSocket
import java.net.Socket
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit

private const val PYTHON = "/usr/bin/python3" // Debian's, which has rospy
private const val ROSCORE = "/usr/bin/roscore"
private const val NEEDED = "import rospy, rosservice, actionlib, tornado, sensor_msgs, std_srvs"

/** A ROS 1 graph on this computer: a roscore, the robot of `src/test/ros/robot.py` and a bridge, `src/test/ros/bridge.py`. */
private class RosGraph : AutoCloseable {
    private val logs: Path = Files.createTempDirectory("argo-ros-core")
    private val master = freePort()
    private val processes = ArrayList<Process>()
    val bridge = freePort()

    suspend fun start() {
        begin("core", PYTHON, ROSCORE, "-p", "$master")
        awaitPort(master)
        begin("robot", PYTHON, "src/test/ros/robot.py")
        begin("bridge", PYTHON, "src/test/ros/bridge.py", "$bridge")
        awaitPort(bridge)
    }

    private fun begin(name: String, vararg command: String) {
        val builder = ProcessBuilder(*command).redirectErrorStream(true).redirectOutput(logs.resolve("$name.log").toFile())
        builder.environment() += mapOf(
            "ROS_MASTER_URI" to "http://127.0.0.1:$master", "ROS_HOSTNAME" to "127.0.0.1", "ROS_LOG_DIR" to "$logs",
            "ROS_PACKAGE_PATH" to "/usr/share", "PYTHONUNBUFFERED" to "1",
        )
        processes += builder.start()
    }

    private suspend fun awaitPort(number: Int) = eventually(LIMIT) { Socket("127.0.0.1", number).close() }

    /** Returns the output of its processes. */
    fun log(): String = Files.list(logs).use { files -> files.filter { "$it".endsWith(".log") }.toList() }
        .joinToString("\n") { "--- ${it.fileName}\n${Files.readString(it).takeLast(SHOWN)}" }

    override fun close() {
        for (process in processes.reversed()) {
            val all = process.descendants().toList() + process.toHandle()
            all.forEach(ProcessHandle::destroy)
            process.waitFor(5, TimeUnit.SECONDS)
            all.filter { it.isAlive }.forEach(ProcessHandle::destroyForcibly)
        }
        logs.toFile().deleteRecursively()
    }

    private fun freePort() = ServerSocket(0).use { it.localPort }

    private companion object {
        const val SHOWN = 2_000
    }
}

/** ARGO's client on a real ROS 1 graph. */
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
            withClue({ graph.log() }) {
                graph.start()
                val program = """
                    !start.
                    +!start <-
                        argo.port("ros://127.0.0.1:${graph.bridge}#transcripts/session"); argo.limit(50); argo.percepts(open).
                    +count(_) : not begun <-
                        +begun; .wait(500); // the robot finds who publishes /cmd_vel
                        !try(move(0.5, 0.25)); !try(horn); !try(lamp(true)); !try(lamp(false)); !try(none);
                        !try(drive(2)); !try(drive(-2)); !try(drive(0)); !try(drive(100)); +tried.
                    +!try(C) <- argo.act(C); +outcome(C, done).
                    -!try(C)[error(E)] <- +outcome(C, E).
                """
                Mas(program).use { mas ->
                    mas.awaitBelief("tried")
                    mas.beliefs().filter { it.startsWith("outcome(") }.toSet() shouldBe SESSION_OUTCOMES
                    mas.awaitBelief("scan(0.75)")
                    mas.awaitBelief("driven(0.5,0.25)")
                    withClue(mas.beliefs()) { mas.beliefs().any { it.startsWith("dist(f,") }.shouldBeTrue() }
                }
            }
        }
    }
})
