package javino.link

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import javino.Frame

private const val STEP = 20_000L // ns
private const val MILLI = 1_000_000L

private data class Order(val atMillis: Int, val length: Int)

/** A link and a field board in virtual time. The link requests percepts repeatedly and sends the ordered actions. */
private class FieldExchange(
    baud: Int,
    loopNanos: Long,
    answerLength: Int,
    private val intervalNanos: Long,
    orders: List<Order>,
    buildNanos: Long = 0,
) {
    private val settings = LinkSettings.defaults().withBaud(baud)
    private val byteNanos = settings.line().byteNanos()
    private val answer = Frame.of("x".repeat(answerLength))
    private val pacer = Pacer(settings, 0)
    private val request = Frame.of(FieldBoardModel.REQUEST).toBytes()
    private val due = orders.sortedBy { it.atMillis }.mapIndexed { i, order -> order.atMillis * MILLI to "$i".padEnd(order.length, '.') }
    private val queue = ArrayDeque<ByteArray>()
    private val onLine = ArrayDeque<Pair<Long, Byte>>()
    private var requestDue = 0L
    private var asking = false
    private var answerBytes = 0
    val board = FieldBoardModel(byteNanos, loopNanos, answer, buildNanos)
    val actions = due.map { it.second }
    var requests = 0
        private set
    var answers = 0
        private set

    fun runUntil(endNanos: Long) {
        var next = 0
        for (now in 0L..endNanos step STEP) {
            while (next < due.size && due[next].first <= now) queue += Frame.of(due[next++].second).toBytes()
            if (!asking && now >= requestDue) {
                asking = true
                queue += request
            }
            write(now)
            while (onLine.isNotEmpty() && onLine.first().first <= now) board.receive(onLine.removeFirst().second, now)
            repeat(board.advance(now)) { answerByte(now) }
        }
    }

    private fun write(now: Long) {
        val bytes = queue.firstOrNull() ?: return
        val isRequest = bytes === request
        if ((if (isRequest) pacer.nanosUntilRequest(requestDue, now) else pacer.nanosUntilAction(bytes.size, now)) > 0) return
        queue.removeFirst()
        val end = if (isRequest) pacer.wroteRequest(bytes.size, now, now) else pacer.wroteAction(bytes.size, now, now)
        bytes.forEachIndexed { i, byte -> onLine += end - (bytes.size - 1 - i) * byteNanos to byte }
        if (isRequest) requests++
    }

    private fun answerByte(now: Long) {
        pacer.received(1, now)
        if (++answerBytes == answer.length()) {
            answerBytes = 0
            answers++
            pacer.answered(now)
            asking = false
            requestDue = now + intervalNanos
        }
    }
}

class FieldBoardPacingSpec : FunSpec({
    val bauds = Arb.element(9_600, 19_200, 57_600, 115_200, 1_000_000)
    val loops = Arb.element(listOf(0, 1, 2, 3, 5, 8, 10, 15, 20, 35, 50)).map { it * MILLI }
    val builds = Arb.element(0L, 0L, 1 * MILLI, 11 * MILLI, 40 * MILLI)
    val answers = Arb.element(0, 37, 150, 200, 255)
    val intervals = Arb.element(0L, 0L, 5 * MILLI, 20 * MILLI)
    val orders = Arb.list(Arb.int(0..600), 0..25)

    test("a field board loses no message and never restarts, whatever comes when") {
        checkAll(30, bauds, loops, answers, intervals, orders, builds) { baud, loop, answer, interval, times, build ->
            val longest = if (loop == 0L) 150 else 50 // no link can help a board whose receive buffer is shorter than a message
            val exchange = FieldExchange(baud, loop, answer, interval, times.mapIndexed { i, at -> Order(at, 2 + i * 37 % longest) }, build)
            exchange.runUntil(8_000 * MILLI)
            exchange.board.restarts shouldBe 0
            exchange.board.lost.shouldBeEmpty()
            exchange.board.overflowed shouldBe 0
            exchange.board.handled.filter { it != FieldBoardModel.REQUEST } shouldContainExactly exchange.actions
            exchange.answers shouldBeGreaterThan 5
        }
    }

    test("an agent that acts all the time still perceives, and one that perceives all the time still acts") {
        val exchange = FieldExchange(9_600, 5 * MILLI, 150, 0, (0 until 1_000 step 10).map { Order(it, 5) })
        exchange.runUntil(8_000 * MILLI)
        exchange.board.handled.filter { it != FieldBoardModel.REQUEST } shouldContainExactly exchange.actions
        exchange.answers shouldBeGreaterThan 5
    }
})
