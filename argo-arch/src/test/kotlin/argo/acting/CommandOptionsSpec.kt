package argo.acting

import argo.calls.ArgumentException
import argo.calls.whole
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.ASSyntax

class CommandOptionsSpec : FunSpec({
    fun of(text: String) = CommandOptions.of(ASSyntax.parseTerm(text))

    test("no options: no limit, and not urgent") {
        of("[]") shouldBe CommandOptions(null, false)
    }

    test("each option sets what it names, in any order") {
        of("[urgent,timeout(200)]") shouldBe CommandOptions(200, true)
        of("[timeout(200),urgent]") shouldBe CommandOptions(200, true)
        of("[urgent]") shouldBe CommandOptions(null, true)
        of("[latest]") shouldBe CommandOptions(null, urgent = false, latest = true)
        of("[latest,urgent,timeout(200)]") shouldBe CommandOptions(200, urgent = true, latest = true)
    }

    test("an option that cannot be used is refused in words that say what can") {
        mapOf(
            "[timeout(0)]" to "whole number from 1",
            "[timeout(-5)]" to "whole number from 1",
            "[timeout(1.5)]" to "whole number",
            "[timeout(600001)]" to "to 600000",
            "[timeout(soon)]" to "whole number",
            "[timeout]" to "timeout is not an option; there are timeout(Ms), urgent, latest, port(P) and answer(R)",
            "[urgent(1)]" to "urgent(1) is not an option",
            "[latest(1)]" to "latest(1) is not an option",
            "[Urgent]" to "is not an option",
            "[3]" to "3 is not an option",
            "[\"urgent\"]" to "is not an option",
            "[timeout(1),port(a),timeout(2)]" to "timeout(2) is a second timeout",
            "urgent" to "a list of options",
            "Options" to "a list of options such as [timeout(200), latest], not Options",
            "[urgent|Rest]" to "a list of options",
        ).forEach { (text, words) -> shouldThrow<ArgumentException> { of(text) }.message shouldContain words }
    }
})
