package javino.link

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import javino.Frame

private const val LOOP = 1_000L

/** A board that reads the line every 1,000 ns from 0 on. */
private class Looks {
    val board = FieldBoardModel(10, LOOP, Frame.of("dist(f,1);"), startNanos = 5_000)
    private var now = 0L

    fun read(text: String) = apply {
        text.forEach { board.receive(it.code.toByte(), now) }
        now += LOOP
        board.advance(now)
    }
}

class FieldBoardModelSpec : FunSpec({
    val first = "${Frame.of("ledOn")}"
    val second = "${Frame.of("ledOff")}"

    test("a message that nothing follows is handled, also if it arrives in parts") {
        Looks().read(first).read(second.take(8)).read(second.drop(8)).board.handled shouldContainExactly listOf("ledOn", "ledOff")
    }

    test("one to four bytes of the next frame behind a message restart the board") {
        for (bytes in 1..4) {
            val board = Looks().read(first + second.take(bytes)).read(second.drop(bytes)).board
            board.restarts shouldBe 1
            board.lost shouldContainExactly listOf("ledOn")
            board.handled.shouldBeEmpty()
        }
    }

    test("more of the next frame loses the first message, and the next one is handled") {
        for (bytes in 5..second.length) {
            val board = Looks().read(first + second.take(bytes)).read(second.drop(bytes)).board
            board.restarts shouldBe 0
            board.lost shouldContainExactly listOf("ledOn")
            board.handled shouldContainExactly listOf("ledOff")
        }
    }

    test("a board that starts is deaf") {
        val looks = Looks().read(first + second.take(1)).read(second.drop(1)).read(first)
        looks.board.handled.shouldBeEmpty()
        repeat(5) { looks.read("") }
        looks.read(first).board.handled shouldContainExactly listOf("ledOn")
    }
})
