package javino.link

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import javino.PortGoneException
import javino.virtual.LineEnd

/** A link notices the loss of its device while nobody waits for a message. */
class LinkWatchSpec : FunSpec({
    val settings = LinkSettings.defaults().withBootMillis(0)

    test("a device that goes while a long message leaves a slow line is noticed within a second") {
        VirtualBench(settings.withBaud(300), LineEnd { end, now -> if (now > 500) end.close() }).use { bench ->
            shouldThrow<PortGoneException> { bench.link.sendAndAwait("x".repeat(200), 500) }
            bench.millis shouldBeLessThan 1500.0
            bench.link.isOpen shouldBe false
        }
    }

    test("a device that goes while a request waits for its turn on the line is noticed when the wait is over") {
        VirtualBench(settings.withSpacingMillis(5000), LineEnd { end, now -> if (now > 500) end.close() }).use { bench ->
            bench.link.sendAndAwait("ledOn", 6000)
            bench.awayFor(600)
            shouldThrow<PortGoneException> { bench.link.request("getPercepts", 300).text() }
        }
    }

    test("a check finds out that the device has gone") {
        VirtualBench(settings, LineEnd { end, now -> if (now > 500) end.close() }).use { bench ->
            bench.link.check()
            bench.awayFor(1000)
            shouldThrow<PortGoneException> { bench.link.check() }
            bench.link.isOpen shouldBe false
        }
    }

    test("a check leaves a message to who waits for it") {
        val board = VirtualBoard()
        VirtualBench(settings, board).use { bench ->
            board.say(0.0, "hello")
            bench.awayFor(100)
            bench.link.check()
            bench.link.listen(1).text() shouldBe "hello"
        }
    }
})
