package argo.exploring.command

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import kotlin.io.path.writeText

/** Tests the program of `explore` in this process. */
class ExploredSpec : FunSpec({
    val robot = tempdir().toPath().resolve("robot.asl").apply { writeText("!start. +!start <- argo.port(ttyACM0).") }
    val board = "--board=ttyACM0 dist(front,5..200)"

    mapOf(
        listOf("nobody.asl", board) to "there is no agent nobody.asl",
        listOf("$robot", "--board=ttyACM0 dist(front)") to "dist(front) always shows the same",
        listOf("$robot", "--board=ttyACM0 dist(9..5)") to "9..5 is no range",
        listOf("$robot", board, "--rule=stopsWhenBlind(stop)") to "is written as stopsWhenBlind(stop,[front])",
        listOf("$robot", board, "--rule=stops(") to "there is no rule stops(; there are staysAlive",
        listOf("$robot", board, "--faults=rain") to "there is no fault rain; there are cables",
        listOf("$robot", board, "--message=go") to "a message is AGENT SENDER PERFORMATIVE CONTENT",
        listOf("$robot", "--boards=RobotKt") to "there is no class RobotKt on the class path",
    ).forEach { (arguments, why) ->
        test("what is no exploration is refused in words: $why") {
            val (out, err) = List(2) { ByteArrayOutputStream() }
            explored(arguments, PrintStream(out), PrintStream(err)) shouldBe 2
            "$err" shouldContain why
            "$out" shouldBe ""
        }
    }
})
