package argo.ros.joining

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.wire.BoardAction
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject

class CommandTermSpec : FunSpec({
    val actions = listOf(BoardAction("stop", 0), BoardAction("move", 2), BoardAction("say", BoardAction.ANY))

    fun request(text: String) = Json.parseToJsonElement(text) as JsonObject

    fun command(name: String, request: String, known: List<BoardAction>? = actions) = commandOf(name, request(request), known)

    fun refusal(name: String, request: String) = shouldThrow<RefusedRequest> { command(name, request) }.message.orEmpty()

    test("a request without fields has no arguments") {
        listOf("{}", """{"arguments": []}""").forEach { command("stop", it) shouldBe "stop" }
    }
    test("arguments come as texts, as data or as a Twist") {
        listOf(
            """{"arguments": ["0.3", "-1"]}""", """{"layout": {}, "data": [0.3, -1]}""",
            """{"linear": {"x": 0.3, "y": 0, "z": 0}, "angular": {"x": 0, "y": 0, "z": -1}}""",
        ).forEach { command("move", it) shouldBe "move(0.3,-1)" }
    }
    test("a text is a term if it reads as one, else a string") {
        command("say", """{"arguments": ["hello"]}""") shouldBe "say(hello)"
        command("say", """{"arguments": ["Hello, you", true, ["a", 1]]}""") shouldBe """say("Hello, you",true,[a,1])"""
        command("say", """{"arguments": ["x); stop"]}""") shouldBe """say("x); stop")"""
    }
    test("what is no command of the board is refused with what there is") {
        refusal("fly", "{}") shouldBe "there is no action fly; there are stop, move, say"
        refusal("move", """{"data": 1}""") shouldBe "move has 2 arguments, not 1"
        refusal("say", """{"arguments": [{"a": 1}]}""") shouldContain "an argument is a number"
        refusal("say", """{"data": null}""") shouldContain "null"
        refusal("say", """{"data": 1e999}""") shouldContain "no number"
        shouldThrow<RefusedRequest> { command("Stop", "{}", null) }.message shouldBe "Stop is no command"
        shouldThrow<RefusedRequest> { command("stop(1); go", "{}", null) }
    }
    test("a written command is a literal") {
        writtenCommand(request("""{"command": " speed(120) "}""")) shouldBe "speed(120)"
        writtenCommand(request("""{"data": "left::stop"}""")) shouldBe "left::stop"
        listOf("", "X", "12", "a;b").forEach { text -> shouldThrow<RefusedRequest> { writtenCommand(request("""{"data": "$text"}""")) } }
        shouldThrow<RefusedRequest> { writtenCommand(request("{}")) }
    }
})
