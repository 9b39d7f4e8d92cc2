package javino.link

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.longs.shouldBeGreaterThanOrEqual
import io.kotest.matchers.longs.shouldBeInRange
import io.kotest.matchers.shouldBe
import javino.LineSettings

private const val MILLI = 1_000_000L
private const val BYTE_9600 = 1_041_666L
private const val GAP = 50 * MILLI + 2 * BYTE_9600 // until answers have been timed

private fun pacer(settings: LinkSettings = LinkSettings.defaults()) = Pacer(settings, 0)

/** A pacer after answers with [delays] and no actions, and the present time. */
private fun timed(settings: LinkSettings, delays: List<Long>): Pair<Pacer, Long> {
    val pacer = pacer(settings)
    var now = 0L
    for (delay in delays) {
        val asked = pacer.wroteRequest(17, now, now)
        pacer.received(1, asked + delay)
        now = asked + delay + 100 * MILLI
        pacer.answered(now)
    }
    return pacer to now
}

private fun gapAfter(delays: List<Long>, settings: LinkSettings = LinkSettings.defaults()): Long {
    val (pacer, now) = timed(settings, delays)
    val sent = pacer.wroteAction(11, now, now)
    return pacer.nanosUntilAction(11, sent)
}

private fun ms(vararg delays: Int) = delays.map { it * MILLI }

class PacerSpec : FunSpec({
    test("the first frame goes at once") {
        pacer().nanosUntilAction(11, 0) shouldBe 0
        pacer().nanosUntilRequest(0, 0) shouldBe 0
    }

    test("a frame has left when its bytes have had their time") {
        pacer().wroteAction(11, 0, 0) shouldBe 11 * BYTE_9600
        pacer().wroteRequest(17, 5, 5) shouldBe 5 + 17 * BYTE_9600
    }

    test("the next frame starts a gap behind the end of the one before, however long both are") {
        for (length in listOf(7, 60)) for (baud in listOf(9_600, 1_000_000)) {
            val pacer = pacer(LinkSettings.defaults().withBaud(baud))
            val end = pacer.wroteAction(length, 0, 0)
            val gap = 50 * MILLI + 2 * LineSettings(baud).byteNanos()
            pacer.nanosUntilAction(length, 0) shouldBe end + gap
            pacer.nanosUntilAction(length, end + gap - 1) shouldBe 1
            pacer.nanosUntilAction(length, end + gap) shouldBe 0
            pacer.nanosUntilRequest(0, end) shouldBe gap
        }
    }

    test("the first action behind an answer starts at once, the next after the gap") {
        val (pacer, now) = timed(LinkSettings.defaults(), List(16) { 5 * MILLI })
        pacer.nanosUntilAction(11, now) shouldBe 0
        val end = pacer.wroteAction(11, now, now)
        pacer.nanosUntilAction(11, end) shouldBeGreaterThan 0
    }

    test("an action behind an answer keeps the gap where the board may have more to handle") {
        val (acted, then) = timed(LinkSettings.defaults(), List(16) { 5 * MILLI })
        val asked = acted.wroteRequest(17, then, then)
        acted.wroteAction(11, asked + 20 * MILLI, asked + 20 * MILLI)
        acted.answered(asked + 200 * MILLI)
        acted.nanosUntilAction(11, asked + 200 * MILLI) shouldBeGreaterThan 0

        val (asking, later) = timed(LinkSettings.defaults(), List(16) { 5 * MILLI })
        val again = asking.wroteRequest(17, asking.wroteRequest(17, later, later), later + 100 * MILLI)
        asking.answered(again + 200 * MILLI)
        asking.nanosUntilAction(11, again + 200 * MILLI) shouldBeGreaterThan 0
    }

    test("a driver that took its time moves the line on") {
        pacer().wroteAction(11, 0, 700 * MILLI) shouldBe 700 * MILLI
    }

    test("a frame that the driver took late, but sooner than it can have left, leaves as much later") {
        pacer().wroteAction(11, 0, 5 * MILLI) shouldBe 5 * MILLI + 11 * BYTE_9600
    }

    test("while the board may be busy with an answer it gets as many actions as it can hold, the first a gap behind the request") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        pacer.nanosUntilAction(11, asked) shouldBe GAP
        val sent = pacer.wroteAction(11, asked + GAP, asked + GAP)
        pacer.nanosUntilAction(11, sent) shouldBe asked + 150 * MILLI - sent
    }

    test("a board with a longer queue gets more of them, but no more bytes than its receive buffer holds") {
        val pacer = pacer(LinkSettings.defaults().withBoardQueue(4).withSpacingMillis(0))
        val asked = pacer.wroteRequest(17, 0, 0)
        val first = pacer.wroteAction(30, asked, asked)
        pacer.nanosUntilAction(30, first) shouldBe 0
        pacer.nanosUntilAction(31, first) shouldBe asked + 150 * MILLI - first
    }

    test("an action that is longer than the receive buffer waits for the answer") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        pacer.nanosUntilAction(61, asked) shouldBe 150 * MILLI
        pacer.answered(asked + 20 * MILLI)
        pacer.nanosUntilAction(61, asked + 20 * MILLI) shouldBe 0
    }

    test("a frame starts a gap behind an answer if an action went out meanwhile") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        val sent = pacer.wroteAction(11, asked, asked)
        pacer.answered(sent + MILLI)
        pacer.nanosUntilAction(11, sent + MILLI) shouldBe GAP
        pacer.nanosUntilRequest(sent, sent + MILLI) shouldBeGreaterThanOrEqual GAP
    }

    test("an answer that comes before its request can have left shows that the line is faster than its rate, and free") {
        val pacer = pacer()
        pacer.wroteRequest(17, 0, 0)
        pacer.answered(MILLI)
        pacer.nanosUntilAction(11, MILLI) shouldBe 0
    }

    test("an answer says nothing of an action that was written after its request") {
        val pacer = pacer()
        val late = pacer.wroteRequest(17, 0, 0) + 60 * MILLI // a slow board that counts as silent
        val sent = pacer.wroteAction(11, late, late)
        pacer.answered(late + MILLI)
        pacer.nanosUntilAction(11, late + MILLI) shouldBe sent + GAP - (late + MILLI)
    }

    test("a message that nobody asked for says nothing of the line") {
        val pacer = pacer()
        val sent = pacer.wroteAction(11, 0, 0)
        pacer.answered(MILLI)
        pacer.nanosUntilAction(11, MILLI) shouldBe sent + GAP - MILLI
    }

    test("until six answers have been timed the gap is fifty milliseconds, then at least two") {
        gapAfter(List(5) { 12 * MILLI }) shouldBe GAP
        gapAfter(List(6) { 12 * MILLI }) shouldBe 2 * BYTE_9600
        gapAfter(List(6) { 12 * MILLI }, LinkSettings.defaults().withBaud(115_200)) shouldBe 2 * MILLI
    }

    test("a request without an answer makes the loop unknown again") {
        val (pacer, now) = timed(LinkSettings.defaults(), List(40) { 12 * MILLI })
        val again = pacer.wroteRequest(17, pacer.wroteRequest(17, now, now), now + 500 * MILLI)
        pacer.received(1, again + 12 * MILLI)
        pacer.answered(again + 100 * MILLI)
        pacer.nanosUntilAction(11, again + 100 * MILLI) shouldBe GAP
    }

    test("the gap is twice the differences of the answers' delays, whatever they have in common") {
        val spread = List(40) { (it % 6) * MILLI } // a loop of 5 ms
        gapAfter(spread) shouldBe 10 * MILLI + 2 * BYTE_9600
        gapAfter(spread.map { it + 12 * MILLI }) shouldBe 10 * MILLI + 2 * BYTE_9600 // a library that takes 12 ms to build its answer
    }

    test("few answers may not have met the whole of a loop, so their differences count more") {
        fun gap(answers: Int) = gapAfter(List(answers) { (it % 4) * MILLI }) - 2 * BYTE_9600
        gap(6) shouldBeInRange (42 * MILLI..43 * MILLI)
        gap(8) shouldBeInRange (20 * MILLI..22 * MILLI)
        gap(16) shouldBeInRange (10 * MILLI..11 * MILLI)
        gap(32) shouldBe 6 * MILLI
    }

    test("one answer that is late does not slow commands down, two do") {
        for (others in listOf(15, 40, 200)) {
            val delays = List(others) { 12 * MILLI }
            gapAfter(delays + 42 * MILLI) shouldBe 2 * BYTE_9600
        }
        gapAfter(List(40) { 12 * MILLI } + ms(32, 32)) shouldBe 40 * MILLI + 2 * BYTE_9600
    }

    test("only the last answers count") {
        val slow = List(40) { (it % 6) * MILLI }
        gapAfter(slow + List(GapEstimate.SAMPLES) { 3 * MILLI }) shouldBe 2 * BYTE_9600
    }

    test("a board that takes ever different times to measure is taken for one whose loop takes fifty milliseconds") {
        gapAfter(ms(400, 300, 200, 100, 400, 300, 200, 100, 400)) shouldBe GAP
    }

    test("the gap that was asked for is kept at least, and none if none was asked for") {
        gapAfter(List(16) { 12 * MILLI }, LinkSettings.defaults().withSpacingMillis(70)) shouldBe 70 * MILLI
        gapAfter(List(40) { (it % 6) * MILLI }, LinkSettings.defaults().withSpacingMillis(5)) shouldBe 10 * MILLI + 2 * BYTE_9600
        gapAfter(List(40) { (it % 6) * MILLI }, LinkSettings.defaults().withSpacingMillis(0)) shouldBe 0
    }

    test("bytes that are read late, all at once, do not make the board late") {
        fun gap(pieces: Int): Long {
            val pacer = pacer()
            var now = 0L
            for (i in 0 until 30) {
                val asked = pacer.wroteRequest(17, now, now)
                val count = if (i % 2 == 0) 1 else pieces
                pacer.received(count, asked + 5 * MILLI + (count - 1) * BYTE_9600)
                now = asked + 100 * MILLI
                pacer.answered(now)
            }
            return pacer.nanosUntilAction(11, now)
        }
        gap(30) shouldBe gap(1)
    }

    test("requests that follow each answer at once still meet the whole of the loop: some go later than they may") {
        val (pacer, start) = timed(LinkSettings.defaults().withBaud(115_200), emptyList())
        var now = start
        val delays = List(100) {
            val wait = pacer.nanosUntilRequest(now, now)
            val asked = pacer.wroteRequest(17, now + wait, now + wait)
            pacer.received(1, asked + MILLI)
            now = asked + 2 * MILLI
            pacer.answered(now)
            if (it < GapEstimate.MIN_SAMPLES) wait - GAP else wait - 2 * MILLI
        }.drop(1)
        delays.take(31).map { it / (2_500_000L) }.toSet() shouldBe setOf(0L, 1L, 2L, 3L) // each quarter of 10 ms
        delays.drop(31).count { it > 0 } shouldBe 9
    }

    test("a line that is not paced, and a board that keeps messages, are asked when they may be") {
        for (settings in LinkSettings.defaults().run { listOf(withPaced(false), withSpacingMillis(0)) }) {
            val pacer = pacer(settings)
            var now = 0L
            repeat(20) {
                now = pacer.wroteRequest(17, now, now) + MILLI
                pacer.received(1, now)
                pacer.answered(now)
                pacer.nanosUntilRequest(now, now) shouldBe 0
            }
        }
    }

    test("bytes that arrive say that the board is still busy") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        val sent = pacer.wroteAction(11, asked, asked)
        pacer.received(1, asked + 120 * MILLI)
        pacer.nanosUntilAction(11, sent) shouldBe asked + 170 * MILLI - sent
    }

    test("a frame of version 2 goes out when the one before has left, or is known to have arrived") {
        val pacer = pacer()
        val left = pacer.wroteFrame(10, 0, 0)
        pacer.nanosUntilFrame(0) shouldBe left
        pacer.nanosUntilFrame(left) shouldBe 0
        pacer.wroteFrame(10, left, left)
        pacer.allArrived(left + MILLI)
        pacer.nanosUntilFrame(left + MILLI) shouldBe 0
    }

    test("a line that is not paced holds nothing back") {
        val pacer = pacer(LinkSettings.defaults().withPaced(false))
        pacer.wroteAction(255, 0, 1) shouldBe 1
        pacer.wroteRequest(17, 1, 2) shouldBe 2
        repeat(5) {
            pacer.nanosUntilAction(255, 2) shouldBe 0
            pacer.wroteAction(255, 2, 2)
        }
        pacer.nanosUntilRequest(2, 2) shouldBe 0
    }

    test("the origin of time does not matter") {
        val start = Long.MAX_VALUE - 5
        val pacer = Pacer(LinkSettings.defaults(), start)
        val end = pacer.wroteAction(11, start, start)
        pacer.nanosUntilAction(11, start) shouldBe 11 * BYTE_9600 + GAP
        pacer.nanosUntilRequest(start, end) shouldBe GAP
    }
})
