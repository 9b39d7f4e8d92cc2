package samples.firmware

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.shouldBe
import javino.LineClock
import javino.Protocol
import javino.Transport
import javino.Transports
import javino.link.Link
import javino.link.LinkSettings
import java.util.concurrent.TimeUnit

private const val LIMIT_MS = 20_000
private const val ANSWER_MS = 2_000
private const val MAX_RUNS = 10
private const val FRAME_MS = 10
private const val CAUGHT_UP_MS = 5
private const val BURSTS = 6
private const val LAMPS = 8

/**
 * Tests the default link with firmware that receives like the old version 1 library. The sketch `Field` simulates it. Link and firmware use
 * the board's clock, so that a busy machine does not push frames together.
 */
@Tags("Thorough")
class FieldFirmwareSpec : FunSpec({
    val built: EnabledOrReasonIf = {
        if (BoardKind.UNO.isBuilt("Field")) Enabled.enabled
        else Enabled.disabled("the firmware is not built: ./argo firmware says what it needs")
    }

    for (buildMs in listOf(0, 11)) for (loopMs in listOf(0, 2, 3, 5, 10, 20, 50)) {
        test("a board of the field acts on every command and never restarts: loop() of $loopMs ms, answers built in $buildMs ms").config(
            enabledOrReasonIf = built,
        ) {
            // a write that stalls for longer than a frame pushes frames together, so such a run does not count
            generateSequence { burstsAt(loopMs, buildMs) }.take(MAX_RUNS).first { it.longestWriteMs < FRAME_MS }
                .percepts shouldBe "done(${BURSTS * LAMPS});starts(1);"
        }
    }
})

private class Run(val percepts: String, val longestWriteMs: Long)

private fun burstsAt(loopMs: Int, buildMs: Int): Run = SimulatedBoard("Field").use { uno ->
    val settings = LinkSettings.defaults().withProtocol(Protocol.V1)
    val line = TimedLine(Transports.open(uno.port, settings.line()), uno.clock)
    Link.over(line, settings, uno.clock).use { link ->
        link.request("getPercepts", LIMIT_MS)
        link.sendAndAwait("build$buildMs", LIMIT_MS)
        link.sendAndAwait("loop$loopMs", LIMIT_MS)
        repeat(BURSTS) {
            repeat(LAMPS) { lamp -> link.sendAndAwait("lamp($lamp,on)", LIMIT_MS) }
            runCatching { link.request("getPercepts", ANSWER_MS) } // a restarting board does not answer
        }
        Run(link.request("getPercepts", LIMIT_MS).text(), line.longestWriteMs)
    }
}

/** Measures the writes on [line]. A read without bytes proves that none arrived, also by the board's [clock]. */
private class TimedLine(private val line: Transport, private val clock: LineClock) : Transport by line {
    var longestWriteMs = 0L
        private set

    override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int {
        val count = line.read(b, off, len, timeoutMillis)
        if (count > 0) return count
        clock.nanos() // after a halt, the board catches up, and its bytes arrive only now
        return line.read(b, off, len, CAUGHT_UP_MS)
    }

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) {
        val start = clock.nanos()
        line.write(b, off, len, timeoutMillis)
        longestWriteMs = maxOf(longestWriteMs, TimeUnit.NANOSECONDS.toMillis(clock.nanos() - start))
    }
}
