package argo.ros.serving

import argo.links.JavinoLink
import argo.ros.LIMIT
import argo.ros.bridge.flag
import argo.ros.bridge.operationIn
import argo.ros.bridge.part
import argo.ros.bridge.text
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.Link
import javino.LinkSettings
import javino.sim.SimulatedBoards
import javino.sim.Sketch
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.TimeUnit
import kotlin.io.path.absolute

/** A board that counts its answers, and notes its actions. */
private class Blinker : Sketch {
    private var count = 0
    val done = ConcurrentLinkedQueue<String>()

    override fun percepts() = listOf("count(${++count})", "ready")

    override fun act(command: String) = command.startsWith("blink(").also { if (it) done += command }
}

/** A board behind its line, offered as `/uno`. */
private class Uno : AutoCloseable {
    val sketch = Blinker().also { SimulatedBoards.plugIn(NAME, it) }
    private val log = ConcurrentLinkedQueue<String>()
    private val graph = Graph(log::add)
    val server = RosServer(Access.of("0"), graph, log::add)
    private val board = ServedBoard("uno", "sim:$NAME", graph.topics, 20, 500, false, ::open, log::add).also {
        graph.add(it)
        it.start()
    }

    private fun open() = JavinoLink(Link.open("sim:$NAME", LinkSettings.defaults().withBaud(115_200), "ros-serve"))

    suspend fun awaitCount() = eventually(LIMIT) { graph.topics.newest("/uno/count").shouldNotBeNull() }

    override fun close() {
        board.close()
        server.close()
        SimulatedBoards.unplug(NAME)
    }

    private companion object {
        const val NAME = "blinker"
    }
}

private val FOLDER = Path.of("../.argo/ros-clients").absolute().normalize()
private val PYTHON = FOLDER.resolve("python/bin/python")
private val MODULES = FOLDER.resolve("node_modules")
private const val MESSAGES = 100

/** Programs of others that speak to a server. */
@Tags("Thorough")
class RosClientsSpec : FunSpec({
    fun isThere(file: Path) =
        if (Files.exists(file)) Enabled.enabled else Enabled.disabled("there is no $file; argo-ros/src/test/clients/install installs it")

    /** Runs a client, and returns all that it saw. */
    fun run(vararg command: String): JsonObject {
        val log = Files.createTempFile("ros-client", ".log")
        val process = ProcessBuilder(*command).redirectError(log.toFile()).start()
        try {
            val output = process.inputStream.readAllBytes().decodeToString()
            process.waitFor(10, TimeUnit.SECONDS)
            return withClue({ Files.readString(log) }) { output.lines().firstNotNullOfOrNull(::operationIn).shouldNotBeNull() }
        } finally {
            process.destroyForcibly()
            Files.delete(log)
        }
    }

    fun JsonObject.texts(name: String) = (this[name] as JsonArray).map { it.jsonPrimitive.content }

    test("roslibpy reads a board at 50 Hz, and each of its calls is carried out once").config(
        enabledOrReasonIf = { isThere(PYTHON) }, blockingTest = true,
    ) {
        Uno().use { uno ->
            uno.awaitCount()
            val seen = run("$PYTHON", "src/test/clients/roslibpy_client.py", "${uno.server.port}", "$MESSAGES")
            withClue(seen) {
                seen.texts("topics") shouldBe listOf("/uno/count", "/uno/percepts", "/uno/port", "/uno/ready")
                seen.text("type") shouldBe "std_msgs/Float64"
                seen.texts("services") shouldContain "/uno/act"
                seen.texts("fields") shouldBe listOf("data")
                seen.flag("hasTime") shouldBe true
                seen.flag("enough") shouldBe true
                seen.flag("increasing") shouldBe true
                seen.part("service")?.flag("success") shouldBe true
                (seen["action"] as JsonArray).map { (it as JsonObject).flag("success") } shouldBe listOf(true)
                seen.part("oldAction")?.flag("success") shouldBe true
                seen.text("refusal").orEmpty() shouldContain "there is no /nobody/blink"
            }
            eventually(LIMIT) { uno.sketch.done.toList() shouldBe (1..4).map { "blink($it)" } }
        }
    }
    test("roslib reads a board at 50 Hz, and each of its calls is carried out once").config(
        enabledOrReasonIf = { isThere(MODULES.resolve("roslib")) }, blockingTest = true,
    ) {
        Uno().use { uno ->
            uno.awaitCount()
            val seen = run("node", "src/test/clients/roslib_client.mjs", "$MODULES", "${uno.server.port}", "$MESSAGES")
            withClue(seen) {
                seen.texts("topics") shouldContain "/uno/count"
                seen.flag("enough") shouldBe true
                seen.flag("increasing") shouldBe true
                listOf("service", "action", "oldAction").forEach { withClue(it) { seen.part(it)?.flag("success") shouldBe true } }
            }
            eventually(LIMIT) { uno.sketch.done.toList() shouldBe (1..4).map { "blink($it)" } }
        }
    }
})
