package javino.link

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import javino.Frame
import javino.FrameDecoder
import javino.PortTimeoutException
import javino.Protocol
import javino.Transport
import javino.virtual.EventBoard
import javino.virtual.EventLine
import javino.virtual.OneFault
import javino.virtual.Piece
import javino.virtual.RandomFaults
import kotlin.math.roundToInt
import kotlin.time.Duration.Companion.minutes

private const val REQUEST = "getPercepts"
private val EXCHANGES = Integer.getInteger("argo.exchanges", 5_000)
private val FAST = LinkSettings.defaults().withBaud(115_200).withBootMillis(0).withProtocol(Protocol.V1)

/** An answer like that of a robot with twelve sensors. Two such answers do not fit into one frame. */
private fun percepts(n: Int) = "count($n);" + "dist(f,$n);".repeat(12)

/** A board of version 1 that answers each request with the next percepts. */
private class CountingBoard(private val said: (Int) -> Unit = { }) : EventBoard {
    override val dueMillis = Double.POSITIVE_INFINITY
    val actions = mutableListOf<String>()
    private var answers = 0
    private lateinit var end: Transport
    private val decoder = FrameDecoder(100_000_000) { if (it.text() == REQUEST) say(++answers) else actions += it.text() }

    override fun look(end: Transport, now: Double) {
        this.end = end
        val buffer = ByteArray(512)
        decoder.accept(buffer, 0, end.read(buffer, 0, buffer.size, 0), (now * 1e6).toLong())
    }

    private fun say(n: Int) {
        Frame.of(percepts(n)).toBytes().let { end.write(it, 0, it.size, 0) }
        said(n)
    }
}

/** A board of version 1 that sends percepts unasked, every [gapMillis] ms. */
private class Talker(private val frames: Int, private val gapMillis: Double, private val said: (Int) -> Unit) : EventBoard {
    private var count = 0
    override var dueMillis = 0.0
        private set

    override fun look(end: Transport, now: Double) {
        if (count == frames || now < dueMillis) return
        Frame.of(percepts(++count)).toBytes().let { end.write(it, 0, it.size, 0) }
        said(count)
        dueMillis = if (count == frames) Double.POSITIVE_INFINITY else now + gapMillis
    }
}

class FieldFaultSpec : FunSpec({
    for (rate in listOf(1e-5, 1e-4, 1e-3)) for (gap in listOf(13.8, 20.0)) {
        val wrong = "one bit in ${(1 / rate).roundToInt()} wrong"
        test("every intact frame of version 1 is delivered: $wrong, bytes lost, doubled and late, one frame every $gap ms")
            .config(timeout = 30.minutes) {
                val faults = RandomFaults(rate, lost = rate, doubled = rate, late = rate, latestNanos = 90_000_000, seed = 2026)
                val intact = mutableListOf<Int>()
                val whole = HashSet<Int>() // numbers of the undamaged messages
                var delivered = 0
                EventLine(FAST, Talker(EXCHANGES, gap) { if (faults.intact) intact += it }, toComputer = faults).use { line ->
                    val inbox = inboxOn(line.transport, line.clock)
                    for (message in generateSequence { inbox.next(line.clock.nanos() + 2_000_000_000) }) {
                        delivered++
                        val number = message.text().substringAfter('(').substringBefore(')').toIntOrNull()
                        if (number != null && message.text() == percepts(number)) whole += number
                    }
                }
                val missing = intact.filter { it !in whole }
                println("measured: $wrong, and as many bytes lost, doubled and late, in version 1: of $EXCHANGES frames every $gap ms " +
                    "${intact.size} intact, ${missing.size} of these not delivered; $delivered delivered in all")
                missing.shouldBeEmpty()
                intact.size shouldBeGreaterThan 0
            }

        if (gap == 20.0) test("an exchange of version 1 whose two frames are intact succeeds: $wrong").config(timeout = 30.minutes) {
            val there = RandomFaults(rate, seed = 1)
            val back = RandomFaults(rate, seed = 2)
            var last = 0
            var intactAnswer = 0
            val failed = mutableListOf<String>()
            var succeeded = 0
            val exchanges = EXCHANGES / 10
            EventLine(FAST, CountingBoard { last = it; if (back.intact) intactAnswer = it }, there, back).use { line ->
                repeat(exchanges) {
                    val before = intactAnswer
                    val answer = try { line.link.request(REQUEST, 100).text() } catch (_: PortTimeoutException) { null }
                    if (intactAnswer > before && answer != percepts(intactAnswer)) failed += "answer $intactAnswer: $answer"
                    if (answer == percepts(last)) succeeded++
                }
            }
            println("measured: $wrong, $exchanges exchanges in version 1: $succeeded answered, " +
                "${failed.size} of these whose frames were intact failed")
            failed.shouldBeEmpty()
            succeeded shouldBeGreaterThan 0
        }
    }

    test("an answer of version 1 may be cut anywhere, and the next one is read") {
        val length = Frame.of(percepts(2)).length()
        for (at in 0 until length) {
            val cut = OneFault(2) { listOf(Piece(it.copyOf(at))) }
            EventLine(FAST, CountingBoard(), toComputer = cut).use { line ->
                line.link.request(REQUEST, 200).text() shouldBe percepts(1)
                val second = try { line.link.request(REQUEST, 200).text() } catch (_: PortTimeoutException) { null }
                second shouldBe null
                line.link.request(REQUEST, 200).text() shouldBe percepts(3)
                line.link.request(REQUEST, 200).text() shouldBe percepts(4)
            }
        }
        println("measured: an answer of version 1 cut at $length places: the next was read each time")
    }

    test("a request of version 1 may be cut anywhere, and the next one reaches the board when it has given up the first") {
        for (at in 0 until Frame.of(REQUEST).length()) {
            val cut = OneFault(2) { listOf(Piece(it.copyOf(at))) }
            val board = CountingBoard()
            EventLine(FAST, board, toBoard = cut).use { line ->
                line.link.request(REQUEST, 200).text() shouldBe percepts(1)
                try { line.link.request(REQUEST, 200).text() } catch (_: PortTimeoutException) { null } shouldBe null
                line.link.sendAndAwait("stop", SendOptions(true, 200)) // a command that is not urgent would wait for an answer
                line.link.request(REQUEST, 200).text() shouldBe percepts(2)
            }
            board.actions shouldContainExactly listOf("stop")
        }
    }
})
