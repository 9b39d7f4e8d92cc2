package argo.resuming

import argo.mind.Mind
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith

class StateSpec : FunSpec({
    val state = State(
        agent = "robot",
        writtenMs = 1_764_139_212_123,
        setUp = listOf("ports([port(ttyACM0,[baud(9600)])])", "limit(50)", "percepts(open)", "change_filter(\"front\")"),
        program = Mind(listOf("limit(40)[source(self)]"), listOf("!start[source(self)]")),
        mind = Mind(
            listOf("done(3)[source(self)]", "n::said(\"a. !b\\n\")[source(bob)]", "~open[source(self)]"),
            listOf("!patrol(X)[source(self)]", "+order(tea)[source(boss)]"),
        ),
    )

    test("is read as it was written") { State.of("robot", state.text()) shouldBe state }

    test("has a fact on each line, and comments") {
        val lines = state.text().lines()
        lines.first() shouldStartWith "// The state of agent robot at "
        lines shouldContain "argo.written(1764139212123)."
        lines shouldContain "argo.ports([port(ttyACM0,[baud(9600)])])."
        lines shouldContain "argo.program(limit(40)[source(self)])."
        lines shouldContain "argo.program(!start[source(self)])."
        lines shouldContain "done(3)[source(self)]."
        lines shouldContain "!patrol(X)[source(self)]."
    }

    test("with lines, blanks and comments of a person is read") {
        val changed = state.text().replace("done(3)[source(self)].", "  // back to the second\n\n  done(2)[source(self)].\r")
        val beliefs = listOf("done(2)[source(self)]") + state.mind.beliefs.drop(1)
        State.of("robot", changed) shouldBe state.copy(mind = state.mind.copy(beliefs = beliefs))
    }

    test("is refused wherever it is cut off") {
        val text = state.text().trimEnd()
        for (length in 0 until text.length) withClue("$length characters") {
            shouldThrow<UnreadableStateException> { State.of("robot", text.take(length)) }
        }
    }

    test("with a line that cannot be read is refused, with that line") {
        fun refusal(old: String, new: String) =
            shouldThrow<UnreadableStateException> { State.of("robot", state.text().replace(old, new)) }.message
        refusal("done(3)[source(self)].", "done(3[source(self)].") shouldContain "line 14: 'done(3[source(self)]' is not a literal"
        refusal("done(3)[source(self)].", "done(3)[source(self)]") shouldBe "line 14 does not end with a full stop: done(3)[source(self)]"
        refusal("argo.limit(50).", "argo.limit(50..") shouldContain "line 5: "
        refusal("argo.limit(50).", "argo.program(limit(40).") shouldContain "line 5: "
        refusal("argo.written(1764139212123).", "argo.written(soon).") shouldBe "it has no line argo.written(Ms)."
    }
})
