package javino

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private const val MILLI = 1_000_000L
private const val BYTE_9600 = 1_041_666L

private fun pacer(settings: LinkSettings = LinkSettings.defaults()) = Pacer(settings, 0)

class PacerSpec : FunSpec({
    test("the first frame goes at once") {
        pacer().nanosUntilAction(11, 0) shouldBe 0
        pacer().nanosUntilRequest(0) shouldBe 0
    }

    test("a frame has left when its bytes have had their time") {
        pacer().wroteAction(11, 0, 0) shouldBe 11 * BYTE_9600
        pacer().wroteRequest(17, 5, 5) shouldBe 5 + 17 * BYTE_9600
    }

    test("the next frame goes when the one before has left") {
        val pacer = pacer()
        pacer.wroteAction(11, 0, 0)
        pacer.nanosUntilAction(11, 0) shouldBe 11 * BYTE_9600
        pacer.nanosUntilAction(11, 11 * BYTE_9600 - 1) shouldBe 1
        pacer.nanosUntilAction(11, 11 * BYTE_9600) shouldBe 0
    }

    test("a driver that took its time moves the line on") {
        pacer().wroteAction(11, 0, 700 * MILLI) shouldBe 700 * MILLI
    }

    test("on a fast line actions end as far apart as the board needs") {
        val pacer = pacer(LinkSettings.defaults().withBaud(1_000_000))
        val end = pacer.wroteAction(10, 0, 0)
        end shouldBe 100_000
        pacer.nanosUntilAction(10, end) shouldBe 10 * MILLI - 100_000
    }

    test("a request goes only when the board has had time for the last action") {
        val pacer = pacer()
        val end = pacer.wroteAction(11, 0, 0)
        pacer.nanosUntilRequest(end) shouldBe 10 * MILLI
    }

    test("while the board may be busy with an answer it gets as many actions as it can hold") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        pacer.nanosUntilAction(11, asked) shouldBe 0
        val sent = pacer.wroteAction(11, asked, asked)
        pacer.nanosUntilAction(11, sent) shouldBe asked + 50 * MILLI - sent
    }

    test("a board with a longer queue gets more of them, but no more bytes than its receive buffer holds") {
        val pacer = pacer(LinkSettings.defaults().withBoardQueue(4))
        val asked = pacer.wroteRequest(17, 0, 0)
        val first = pacer.wroteAction(30, asked, asked)
        pacer.nanosUntilAction(30, first) shouldBe 0
        pacer.nanosUntilAction(31, first) shouldBe asked + 50 * MILLI - first
    }

    test("an action that is longer than the receive buffer waits for the answer") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        pacer.nanosUntilAction(61, asked) shouldBe 50 * MILLI
        pacer.answered(asked + 20 * MILLI)
        pacer.nanosUntilAction(61, asked + 20 * MILLI) shouldBe 0
    }

    test("after an answer the board has time for the action that it got meanwhile, and needs none if it got no action") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        val sent = pacer.wroteAction(11, asked, asked)
        pacer.answered(sent)
        pacer.nanosUntilAction(11, sent) shouldBe 10 * MILLI
        val again = pacer.wroteRequest(17, sent + 20 * MILLI, sent + 20 * MILLI)
        pacer.answered(again)
        pacer.nanosUntilAction(11, again) shouldBe 0
    }

    test("an answer that comes before its request can have left shows that the line is faster than its rate, and free") {
        val pacer = pacer()
        pacer.wroteRequest(17, 0, 0)
        pacer.answered(MILLI)
        pacer.nanosUntilAction(11, MILLI) shouldBe 0
    }

    test("an answer says nothing of an action that was written after its request") {
        val pacer = pacer()
        val late = pacer.wroteRequest(17, 0, 0) + 60 * MILLI // a slow board, which is taken to be silent
        val sent = pacer.wroteAction(11, late, late)
        pacer.answered(late + MILLI)
        pacer.nanosUntilAction(11, late + MILLI) shouldBe sent - (late + MILLI)
        pacer.nanosUntilRequest(late + MILLI) shouldBe sent + 10 * MILLI - (late + MILLI)
    }

    test("a message that nobody asked for says nothing of the line") {
        val pacer = pacer()
        val sent = pacer.wroteAction(11, 0, 0)
        pacer.answered(MILLI)
        pacer.nanosUntilAction(11, MILLI) shouldBe sent - MILLI
    }

    test("a board that looks at the line more seldom than messages are spaced gets them farther apart") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        pacer.received(1, asked + 30 * MILLI)
        pacer.answered(asked + 40 * MILLI)
        val sent = pacer.wroteAction(11, asked + 40 * MILLI, asked + 40 * MILLI)
        pacer.nanosUntilRequest(sent) shouldBe 60 * MILLI
        (pacer.nanosUntilAction(11, sent) > 48 * MILLI) shouldBe true
    }

    test("a board that takes long to measure is not taken for one that never looks, and one that holds messages is not waited for") {
        fun apart(settings: LinkSettings): Long {
            val pacer = pacer(settings)
            val asked = pacer.wroteRequest(17, 0, 0)
            pacer.received(1, asked + 400 * MILLI)
            pacer.answered(asked + 410 * MILLI)
            val sent = pacer.wroteAction(11, asked + 410 * MILLI, asked + 410 * MILLI)
            return pacer.nanosUntilRequest(sent)
        }
        apart(LinkSettings.defaults()) shouldBe 10 * MILLI
        apart(LinkSettings.defaults().withSpacingMillis(0)) shouldBe 0
    }

    test("only the last answers count for how often a board looks at the line") {
        val loop = LoopTime()
        loop.nanos() shouldBe 0
        loop.answeredAfter(20 * MILLI)
        loop.nanos() shouldBe 40 * MILLI
        repeat(LoopTime.SAMPLES) { loop.answeredAfter(-1) }
        loop.nanos() shouldBe 0
    }

    test("one answer among many that was late is not taken for a board that looks seldom") {
        val loop = LoopTime()
        repeat(63) { loop.answeredAfter(2 * MILLI) }
        loop.answeredAfter(45 * MILLI)
        loop.nanos() shouldBe 4 * MILLI
        loop.answeredAfter(45 * MILLI)
        loop.nanos() shouldBe 90 * MILLI
    }

    test("bytes that are read late, all at once, do not make the board late") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        pacer.received(30, asked + 40 * MILLI) // 30 bytes take 31.25 ms
        pacer.answered(asked + 50 * MILLI)
        val sent = pacer.wroteAction(11, asked + 50 * MILLI, asked + 50 * MILLI)
        pacer.nanosUntilRequest(sent) shouldBe 2 * (40 * MILLI - 29 * BYTE_9600)
    }

    test("bytes that arrive say that the board is still busy") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        val sent = pacer.wroteAction(11, asked, asked)
        pacer.received(1, asked + 40 * MILLI)
        pacer.nanosUntilAction(11, sent) shouldBe asked + 90 * MILLI - sent
    }

    test("a complete answer lets the other actions go when the board has had time for the first") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        pacer.wroteAction(11, asked, asked)
        val answered = asked + 40 * MILLI
        pacer.answered(answered)
        pacer.nanosUntilAction(11, answered) shouldBe 10 * MILLI
        pacer.nanosUntilRequest(answered) shouldBe 10 * MILLI
    }

    test("an answer that met no action holds nothing back") {
        val pacer = pacer()
        val asked = pacer.wroteRequest(17, 0, 0)
        pacer.answered(asked + 40 * MILLI)
        pacer.nanosUntilAction(11, asked + 40 * MILLI) shouldBe 0
        pacer.nanosUntilRequest(asked + 40 * MILLI) shouldBe 0
    }

    test("a line that is not paced holds nothing back") {
        val pacer = pacer(LinkSettings.defaults().withPaced(false))
        pacer.wroteAction(255, 0, 1) shouldBe 1
        pacer.wroteRequest(17, 1, 2) shouldBe 2
        repeat(5) {
            pacer.nanosUntilAction(255, 2) shouldBe 0
            pacer.wroteAction(255, 2, 2)
        }
        pacer.nanosUntilRequest(2) shouldBe 0
    }

    test("the origin of time does not matter") {
        val pacer = Pacer(LinkSettings.defaults(), Long.MAX_VALUE - 5)
        val end = pacer.wroteAction(11, Long.MAX_VALUE - 5, Long.MAX_VALUE - 5)
        pacer.nanosUntilAction(11, Long.MAX_VALUE - 5) shouldBe 11 * BYTE_9600
        pacer.nanosUntilRequest(end) shouldBe 10 * MILLI
    }
})
