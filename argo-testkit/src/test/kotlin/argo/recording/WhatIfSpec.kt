package argo.recording

import argo.recording.replay.CommandDifference
import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.TimedCommand
import argo.recording.replay.WhatIf
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class WhatIfSpec : FunSpec({
    val folder = tempdir().toPath()
    val robot =
        """
        !start.
        +!start <- argo.port(ttyACM0); argo.percepts(open); .wait(200); !patrol.
        +!patrol <- argo.act(forward); .wait(300); !patrol.
        +dist(front,Cm) : Cm < 40 <- argo.act(stop); .print("stopped at ", Cm).
        +!turn[source(_)] <- .send(boss, askOne, side(S), side(S)); argo.act(S).
        """.trimIndent()

    fun drive(program: String = robot) = recorded(program) {
        perceives("dist(front,80)", "light(back,140)")
        after(1.seconds)
        perceives("dist(front,38)", "light(back,140)")
        after(1.seconds)
        perceives("dist(front,20)", "light(back,140)")
        after(500.milliseconds)
    }

    fun <T> whatIf(file: Path, program: String?, see: WhatIf.() -> T): T = Recording(file).use { recording ->
        val source = program?.let { folder.resolve("new.asl").apply { writeText(it) } }
        WhatIf(recording, "agent", source).use { it.run().see() }
    }

    fun difference(file: Path, program: String?): CommandDifference? = whatIf(file, program) { difference(Duration.ofMillis(100)) }

    fun edited(old: String, new: String): String = robot.replace(old, new).also { check(it != robot) { "there is no $old" } }

    val file = drive()

    test("the recorded program sends what was recorded, at the same times") {
        whatIf(file, null) {
            commandsNow.map { it.copy(port = "ttyACM0") } shouldContainExactly commands
            commands.map { it.text }.toSet() shouldBe setOf("forward", "stop")
            difference(Duration.ZERO) shouldBe null
        }
    }

    test("so does a program that differs in what is no command") {
        val other = edited(".print(\"stopped at \", Cm)", "+stopped(Cm); .print(Cm); !!rest(Cm)")
        difference(file, "// a line\n\n$other\n+!rest(_) <- .wait(50).") shouldBe null
    }

    test("another limit: a command is missing, and the one that comes later is the same as the recorded one") {
        val found = difference(file, edited("Cm < 40", "Cm < 30")).shouldNotBeNull()
        found.kind shouldBe "missing"
        found.recorded?.text shouldBe "stop"
        found.recorded?.place shouldBe "agent.asl:4"
        found.same shouldBe whatIf(file, null) { commands.indexOfFirst { it.text == "stop" } }
    }

    test("another command in the place of a recorded one") {
        val found = difference(file, edited("argo.act(stop)", "argo.act(brake(1))")).shouldNotBeNull()
        found.kind shouldBe "other"
        found.now?.text shouldBe "brake(1)"
        found.now?.place shouldBe "new.asl:4"
    }

    test("an additional command, and one that comes at another time") {
        difference(file, edited(".print(\"stopped at \", Cm)", "argo.act(lamp)")).shouldNotBeNull().run {
            kind shouldBe "additional"
            now?.text shouldBe "lamp"
        }
        difference(file, edited(".wait(300)", ".wait(500)")).shouldNotBeNull().kind shouldBe "later"
        difference(file, edited(".wait(300)", ".wait(100)")).shouldNotBeNull().kind shouldBe "additional"
    }

    test("a command that was not recorded succeeds, and one that was fails as it did") {
        fun program(handling: String) =
            "!start. +!start <- argo.port(ttyACM0); !!go; .wait(2000); .print(over). " +
                "+!go <- argo.act(forward); .wait(200); !go. -!go[error(E)] <- $handling."
        val failing = recorded(program("+gone(E)")) {
            after(500.milliseconds)
            board.disconnects()
            after(2.seconds)
        }
        whatIf(failing, program("+gone(E); argo.act(left); +went")) {
            val believed = beliefs.map { it.substringBefore('[') }
            believed shouldContainAll listOf("gone(port_gone)", "went")
        }
    }

    test("chance and the ages of percepts are as recorded") {
        val asking =
            "!start. +!start <- argo.port(ttyACM0); argo.percepts(open); .random(R); .wait(dist(_)); !say(R). " +
                "+!say(R) : argo.age(dist(_),Ms) <- argo.act(say(R,Ms))."
        val asked = recorded(asking) {
            perceives("dist(3)")
            after(300.milliseconds)
        }
        difference(asked, asking.replace("+!start <-", "+!start <- .print(now); .wait(3);")) shouldBe null
    }

    test("commands are compared in their order and by their times") {
        fun sent(text: String, ms: Int, port: String? = null) = TimedCommand(1, ms * 1_000_000L, port, text, null)
        fun kind(recorded: List<TimedCommand>, now: List<TimedCommand>) =
            CommandDifference.first(recorded, now, Duration.ofMillis(100), Duration.ofSeconds(2).toNanos())?.kind
        kind(emptyList(), emptyList()) shouldBe null
        kind(listOf(sent("go", 0, "a")), listOf(sent("go", 90))) shouldBe null
        kind(listOf(sent("go", 0, "a")), listOf(sent("go", 0, "b"))) shouldBe "other"
        kind(listOf(sent("go", 0)), emptyList()) shouldBe "missing"
        kind(emptyList(), listOf(sent("go", 0))) shouldBe "additional"
        kind(listOf(sent("go", 0), sent("stop", 500)), listOf(sent("stop", 500))) shouldBe "missing"
        kind(listOf(sent("stop", 500)), listOf(sent("go", 0), sent("stop", 500))) shouldBe "additional"
        kind(listOf(sent("go", 0)), listOf(sent("go", 101))) shouldBe "later"
        kind(listOf(sent("go", 101)), listOf(sent("go", 0))) shouldBe "earlier"
        kind(listOf(sent("go", 0), sent("stop", 1999)), listOf(sent("go", 0))) shouldBe "missing"
        kind(listOf(sent("go", 0)), listOf(sent("go", 0), sent("stop", 2001))) shouldBe null // after the end of the recording
    }

    test("what cannot be run is refused in words") {
        Recording(file).use { recording ->
            shouldThrow<RecordingException> { WhatIf(recording, "eve") }.message shouldBe
                "the recording has no agent eve; those that it has: agent"
            val broken = folder.resolve("broken.asl").apply { writeText("!start. +!start <- ((.") }
            shouldThrow<RecordingException> { WhatIf(recording, "agent", broken) }.message shouldContain "Jason cannot read"
        }
    }
})
