package argo.ros.serving

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.wire.BoardAction
import kotlinx.serialization.json.Json

class CommandTermSpec : FunSpec({
    val actions = listOf(BoardAction("stop", 0), BoardAction("move", 2), BoardAction("say", BoardAction.ANY))

    fun command(name: String, request: String?, known: List<BoardAction>? = actions) =
        commandOf(name, request?.let(Json::parseToJsonElement), known)

    fun refusal(name: String, request: String?) = shouldThrow<RefusedRequest> { command(name, request) }.message.orEmpty()

    test("a request without fields has no arguments") {
        listOf(null, "{}", "[]", "null", """{"arguments": []}""").forEach { command("stop", it) shouldBe "stop" }
    }
    test("arguments come as an array, as a field, as data, as a Twist or as any fields in their order") {
        listOf(
            "[0.3, -1]", """{"arguments": [0.3, -1]}""", """{"data": [0.3, -1]}""", """{"v": 0.3, "w": -1}""",
            """{"linear": {"x": 0.3, "y": 0, "z": 0}, "angular": {"x": 0, "y": 0, "z": -1}}""", """["0.3", "-1"]""",
        ).forEach { command("move", it) shouldBe "move(0.3,-1)" }
    }
    test("a text is a term if it reads as one, else a string") {
        command("say", """["hello"]""") shouldBe "say(hello)"
        command("say", """["Hello, you", true, ["a", 1]]""") shouldBe """say("Hello, you",true,[a,1])"""
        command("say", """["x); stop"]""") shouldBe """say("x); stop")"""
    }
    test("a namespace stands before the action") { command("left/stop", null, null) shouldBe "left::stop" }
    test("what is no command of the board is refused with what there is") {
        refusal("fly", null) shouldBe "there is no action fly; there are stop, move, say"
        refusal("move", "[1]") shouldBe "move has 2 arguments, not 1"
        refusal("say", """[{"a": 1}]""") shouldContain "an argument is a number"
        refusal("say", "[null]") shouldContain "null"
        refusal("say", "[1e999]") shouldContain "no number"
        shouldThrow<RefusedRequest> { command("Stop", null, null) }.message shouldBe "Stop is no command"
        shouldThrow<RefusedRequest> { command("stop(1); go", null, null) }
    }
    test("a written command is a literal") {
        writtenCommand(" speed(120) ") shouldBe "speed(120)"
        listOf(null, "", "X", "12", "a;b").forEach { text -> shouldThrow<RefusedRequest> { writtenCommand(text) } }
    }
})
