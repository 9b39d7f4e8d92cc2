package benchmarks.stops

import argo.testkit.TestAgent
import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import java.nio.file.Files
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds

private const val BURSTS = 6
private const val LAMPS = 8
private val FIELD: Path = Bench.simulator.resolveSibling("avr/uno/Field.elf")
private val LIMIT = 120.seconds
private val QUIET = 5.seconds

/**
 * Tests the default link with firmware that receives like the old version 1 library. The sketch `Field` simulates it. Agent, line and
 * firmware run in virtual time, so that a busy machine does not push frames together.
 */
class FieldFirmwareSpec : FunSpec({
    val built: EnabledOrReasonIf = {
        if (Files.isExecutable(Bench.simulator) && Files.exists(FIELD)) Enabled.enabled
        else Enabled.disabled("the firmware is not built: ./argo firmware says what it needs")
    }

    for (buildMs in listOf(0, 11)) for (loopMs in listOf(0, 2, 3, 5, 10, 20, 50)) {
        test("a board of the field acts on every command and never restarts: loop() of $loopMs ms, answers built in $buildMs ms").config(
            tags = thorough, enabledOrReasonIf = built,
        ) {
            counted("[protocol(1)]", loopMs, buildMs) shouldBe listOf("done(${BURSTS * LAMPS})", "starts(1)")
        }
    }

    test("without the spacing of frames, the same board misses commands or restarts").config(tags = thorough, enabledOrReasonIf = built) {
        counted("[protocol(1), spacing(0)]", loopMs = 10, buildMs = 11) shouldNotBe listOf("done(${BURSTS * LAMPS})", "starts(1)")
    }
})

/** Sends bursts of commands to the sketch, and meanwhile perceives it. Returns the percepts at the end. */
private fun counted(options: String, loopMs: Int, buildMs: Int): List<String> = SteppedUno(Bench.simulator, FIELD).use { uno ->
    val program = """
        !start.
        +!start <- argo.port(uno, $options); argo.act(build$buildMs); argo.act(loop$loopMs); argo.percepts(open); !bursts($BURSTS).
        +!bursts(0) <- +sent.
        +!bursts(N) <- for (.range(L, 1, $LAMPS)) { argo.act(lamp(L, on)); }; .wait(500); !bursts(N - 1).
    """.trimIndent()
    val agent = agentOf(program) {
        board("uno").leadsTo { port, settings, clock -> SteppedLine(port, settings, clock, uno, Timeline(settings.byteNanos())) }
    }
    agent.use { it.shouldBelieve("sent", within = LIMIT).after(QUIET).counts() }
}

private fun TestAgent.counts() = beliefs.filter { it.startsWith("done(") || it.startsWith("starts(") }
