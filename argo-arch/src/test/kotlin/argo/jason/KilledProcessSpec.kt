package argo.jason

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.longs.shouldBeLessThan
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import javino.sim.FakeBoard
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.random.Random

/**
 * Kills (`kill -9`) the process of an agent at random times and starts it again. The agent's board is on a pseudo-terminal. The agent must
 * continue from its state of a few seconds ago, if it lived that long. The board must carry out no command twice. The property
 * `argo.process.kills` is the number of kills.
 */
@Tags("Thorough")
class KilledProcessSpec : FunSpec({
    val folder = tempdir().toPath()
    val kills = Integer.getInteger("argo.process.kills", 8)
    val resumed = Regex("""resumed (\d+)""")
    val mostNs = TimeUnit.SECONDS.toNanos(20) // more than five seconds, since the machine may be slow; KilledAgentsSpec is exact
    val longMs = 5_500L // longer than the time between two states

    fun believedNs(log: String) = resumed.find(log).shouldNotBeNull().groupValues[1].toLong()

    fun project(device: Path) {
        folder.resolve("logging.properties").writeText(
            """
            handlers = java.util.logging.ConsoleHandler
            java.util.logging.ConsoleHandler.formatter = jason.runtime.MASConsoleLogFormatter
            """.trimIndent(),
        )
        folder.resolve("robots.mas2j").writeText(
            "MAS robots { agents: robot robot.asl [argo_resume=\"robot.state\"] agentArchClass argo.Arch; }",
        )
        folder.resolve("robot.asl").writeText("""
            born.
            !start.
            +!start <- argo.port("$device", [baud(115200), boot(0)]); argo.limit(20); argo.percepts(open); !!drive.
            +!drive <- .wait(at(_)); !step.
            +!step : at(N) <- argo.act(go(N + 1)); .wait(at(N + 1)); .nano_time(T); -+alive(T); .wait(math.random(100)); !drive.
            +resumed(_) : alive(T) <- .print("resumed ", T).
        """.trimIndent())
    }

    fun start(): Process = ProcessBuilder(
        ProcessHandle.current().info().command().orElse("java"), "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC",
        "-cp", System.getProperty("java.class.path"),
        "jason.infra.local.RunLocalMAS", "robots.mas2j", "--no-net", "--log-conf", "logging.properties",
    ).directory(folder.toFile()).redirectErrorStream(true).redirectOutput(folder.resolve("log").toFile()).start()

    test("kills, and a polite end").config(enabledOrReasonIf = { withTerminals }, blockingTest = true) {
        val chance = Random(33)
        FakeBoard.plugIn("far").use { plugged ->
            val board = plugged.lenient()
            fun driven() = board.received().filter { it.startsWith("go(") }
            board.whenAsked("getPercepts").answer { "at(${driven().size});" }
            TerminalBoard(board).use { terminal ->
                project(terminal.device)
                var killedNs = 0L
                repeat(kills + 1) { life ->
                    val before = driven().size
                    val process = start()
                    try {
                        eventually(LIMIT) { withClue({ folder.resolve("log").readText() }) { driven().size shouldBeGreaterThan before } }
                        val log = folder.resolve("log").readText()
                        withClue(log) {
                            if (life % 2 == 1) killedNs - believedNs(log) shouldBeLessThan mostNs
                            log.lines().filter { "SEVERE" in it || "argo_resume" in it }.shouldBeEmpty()
                        }
                        Thread.sleep(if (life % 2 == 0) longMs else chance.nextLong(longMs)) // the life of the process
                    } finally {
                        killedNs = System.nanoTime() // all processes of a computer have this clock
                        if (life < kills) process.destroyForcibly() else process.destroy()
                        process.waitFor(20, TimeUnit.SECONDS) shouldBe true
                    }
                    folder.listDirectoryEntries("*broken*").map { it.name }.shouldBeEmpty()
                }
                driven().size shouldBeGreaterThan kills
                driven().shouldBeUnique()
            }
        }
    }
})
