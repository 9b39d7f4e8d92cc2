package argo.connecting

import argo.calls.ArgumentException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.ASSyntax
import javino.Protocol

class PortOptionsSpec : FunSpec({
    fun of(text: String) = PortOptions.of(ASSyntax.parseTerm(text))

    test("no options are the defaults: 9600 baud, asked, half a second for an answer") {
        val options = of("[]")
        options shouldBe PortOptions()
        options.link.baud() shouldBe 9600
        options.timeoutMs shouldBe 500
        options.listens shouldBe false
        options.link.protocol() shouldBe Protocol.AUTO
    }

    test("a line that is not paced is spoken to in version 1, unless version 2 is asked for") {
        of("[]").linkSettings(paced = true).protocol() shouldBe Protocol.AUTO
        of("[]").linkSettings(paced = false).protocol() shouldBe Protocol.V1
        of("[protocol(auto)]").linkSettings(paced = false).protocol() shouldBe Protocol.V1
        of("[protocol(2)]").linkSettings(paced = false).protocol() shouldBe Protocol.V2
        of("[]").linkSettings(paced = false).paced() shouldBe false
    }

    test("each option sets what it names") {
        val options = of("[baud(115200), timeout(1000), mode(listen), protocol(1), boot(0), spacing(3), queue(4)]")
        options.link.baud() shouldBe 115200
        options.timeoutMs shouldBe 1000
        options.listens shouldBe true
        options.link.bootMillis() shouldBe 0
        options.link.spacingMillis() shouldBe 3
        options.link.boardQueue() shouldBe 4
    }

    test("the text of options is read as the same options") {
        of("[]").text shouldBe "[]"
        val all = "[baud(115200),timeout(1000),stale(0),boot(0),spacing(3),queue(4),mode(listen),protocol(1),as(left)]"
        of(all).text shouldBe all
        of(of(all).text) shouldBe of(all)
        listOf("ttyACM0", "tcp://robot:4000", "tls://robot:4433").forEach { port ->
            of(of("[boot(0)]").on(port).text).on(port) shouldBe of("[boot(0)]").on(port)
        }
    }

    test("an option that cannot be used is refused in words that say what can") {
        mapOf(
            "[bauds(9600)]" to "bauds(9600) is not an option",
            "[baud(0)]" to "whole number from 1",
            "[baud(fast)]" to "whole number",
            "[baud(9600.5)]" to "whole number",
            "[timeout(-1)]" to "whole number",
            "[mode(push)]" to "request or listen",
            "[protocol(3)]" to "protocol is 1 or 2 or auto",
            "[baudrate(9600), timeout(0), stop(1)]" to "baudrate(9600) is not an option; " +
                "timeout(0): timeout takes a whole number from 1 to 600000; stop(1) is not an option; there are baud(Rate), timeout(Ms)",
            "[baud]" to "baud is not an option",
            "[X]" to "X is not an option",
            "baud(9600)" to "a list of options",
            "Options" to "a list of options such as [baud(115200)], not Options",
            "[baud(9600)|Rest]" to "a list of options",
        ).forEach { (text, words) -> shouldThrow<ArgumentException> { of(text) }.message shouldContain words }
    }
})
