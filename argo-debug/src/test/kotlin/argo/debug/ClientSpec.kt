package argo.debug

import argo.testkit.agent
import com.google.gson.JsonElement
import com.google.gson.JsonParser
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.comparables.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldMatch
import jason.infra.local.RunLocalMAS
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import javino.LineSettings
import javino.PortException
import javino.Transports
import javino.sim.FakeBoard
import javino.sim.PseudoTerminals
import java.net.InetAddress
import java.net.ServerSocket
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import kotlin.concurrent.thread
import kotlin.io.path.absolute
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.minutes

/** Debugs an agent with a widely used client of the protocol, from npm. The agent's board is at the end of a pseudo-terminal. */
class ClientSpec : FunSpec({
    val folder = Path.of("build/client").absolute()
    val thorough = setOf(NamedTag("Thorough"))
    val client =
        if (folder.resolve("node_modules/@vscode/debugadapter-testsupport").exists()) Enabled.enabled
        else Enabled.disabled("there is no client: argo-debug/install-client installs it")
    val withTerminals = when {
        client.isDisabled -> client
        !PseudoTerminals.available() -> Enabled.disabled("needs pseudo-terminals, and socat, which makes them, is not installed")
        else -> Enabled.enabled
    }

    fun session(port: Int, file: Path): String {
        val script = Path.of("src/test/client/session.mjs").absolute()
        val command = listOf("node", "$script", "$folder", "$port", "$file", "5")
        val process = ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start()
        val said = process.inputStream.readBytes().decodeToString()
        process.waitFor(1, TimeUnit.MINUTES)
        return said
    }

    test("it stops a drive at a breakpoint, with the board made safe first, reads what the agent knows there, steps, and goes on")
        .config(enabledOrReasonIf = { withTerminals }, tags = thorough) {
            val free = freePort()
            val reading = AtomicInteger(1000)
            val board = FakeBoard.plugIn("debugged").lenient().version2().knows("forward/1", "stop/0")
                .apply { whenAsked("getPercepts").answer { "dist(f,${reading.decrementAndGet()});" } }
            val terminals = PseudoTerminals.open()
            val end = Transports.open(terminals.board().path, LineSettings(115_200))
            val program = thread(isDaemon = true) {
                try {
                    board.program().run(end)
                } catch (_: PortException) {
                    // the test is over
                }
            }
            val file = tempdir().toPath().toRealPath().resolve("bob.asl").apply { writeText(drive("${terminals.computer()}")) }
            val said = running(file, mapOf("argo_debug" to "$free", "argo_safe" to "stop")) {
                session(free, file).also {
                    eventually(1.minutes) { board.received().last { !it.startsWith("getPercepts") } shouldContain "forward" }
                }
            }
            terminals.close()
            end.close()
            program.join()
            val received = board.received().filter { !it.startsWith("getPercepts") }
            board.close()
            val seen = JsonParser.parseString(said).asJsonObject
            withClue("$said\n$received") {
                seen["breakpoints"].items.map { it.asJsonObject["verified"].asBoolean } shouldBe listOf(true, false)
                seen["threads"].items.map { it.asJsonObject["name"].asString } shouldBe listOf("bob")
                val stops = seen["stops"].items.map { it.asJsonObject }
                stops.map { it["reason"].asString } shouldBe listOf("breakpoint", "step", "pause")
                stops.forEach { it["text"].asString shouldMatch "the board on .* has got stop" }
                val frame = seen["frames"].items.first().asJsonObject
                frame["line"].asInt shouldBe 5
                frame["source"].asJsonObject["path"].asString shouldBe "$file"
                val x = seen["variables"].asJsonObject["Variables"].items.single { it.asJsonObject["name"].asString == "X" }
                    .asJsonObject["value"].asString
                seen["variables"].asJsonObject["Beliefs"].items.map { it.asJsonObject["name"].asString } shouldContain "dist(f,$x)"
                val answers = seen["answers"].items.map { it.asString }
                answers.take(3) shouldBe listOf(x, "D = $x", "false")
                answers[3] shouldContain "is an internal action"
                answers[4] shouldContain "is no formula"
                seen["after"].items.first().asJsonObject["line"].asInt shouldBe 6
                seen["late"].asString shouldContain "the agent has gone on since"
                // the board was safe before the step at the breakpoint was carried out
                received.indexOf("stop") shouldBeLessThan received.indexOf("forward($x)")
            }
        }

    test("it debugs the replay of a recorded agent, and the replay is identical").config(enabledOrReasonIf = { client }, tags = thorough) {
        val directory = tempdir().toPath().toRealPath()
        val file = directory.resolve("bob.asl").apply { writeText(drive("ttyACM0")) }
        val recording = directory.resolve("drive.mcap")
        agent(file) { options("argo_record" to "$recording") }.use { it.perceives("dist(f,38)").shouldSend("forward(38)") }
        file.writeText(file.readText() + "// another line\n")
        val free = freePort()
        val command = listOf("java", "-cp", System.getProperty("java.class.path"), "argo.tools.MainKt", "replay", "$recording")
        val replay = ProcessBuilder(command + listOf("--debug", "$free")).start()
        val errors = replay.errorStream.bufferedReader()
        val told = generateSequence { errors.readLine() }.takeWhile { "is paused before its first cycle" !in it }.toList()
        withClue(told) { told.single { "has changed since" in it } shouldContain "$file" }
        val said = session(free, file)
        val report = replay.inputStream.readBytes().decodeToString()
        replay.waitFor(1, TimeUnit.MINUTES)
        withClue("$said\n$report") {
            val seen = JsonParser.parseString(said).asJsonObject
            seen["stops"].items.map { it.asJsonObject["reason"].asString } shouldBe listOf("pause", "breakpoint", "step")
            seen["answers"].items.first().asString shouldBe "38"
            report shouldContain "identical: the same events"
            replay.exitValue() shouldBe 0
        }
    }
})

/** Returns a free port that the system does not hand out. Another program could take a handed-out port before the debugger. */
internal fun freePort() = (20_000..31_999).shuffled().first { port ->
    runCatching { ServerSocket(port, 1, InetAddress.getLoopbackAddress()).close() }.isSuccess
}

private val JsonElement.items: List<JsonElement> get() = asJsonArray.toList()

/** Runs an agent with the program [file] in Jason's Local infrastructure during [work]. */
private inline fun <T> running(file: Path, options: Map<String, String>, work: () -> T): T {
    val mas = RunLocalMAS()
    val logging = file.resolveSibling("logging.properties").apply { writeText("handlers =\n.level = INFO\n") }
    mas.init(arrayOf("--empty-mas", "--no-net", "--log-conf", "$logging"))
    mas.create()
    mas.start()
    val settings = Settings().apply { setOptions(HashMap<String, Any>(options)) }
    val services = RuntimeServicesFactory.get()
    services.startAgent(services.createAgent("bob", "$file", null, listOf("argo.Arch"), null, settings, null))
    try {
        return work()
    } finally {
        mas.finish(0, false, 0)
    }
}

private fun drive(port: String) = """!start.
+!start <- argo.port("$port"); argo.limit(20); argo.percepts(open).
+dist(f,X)
   // the step
   <- argo.act(forward(X));
      +done(X).
"""
