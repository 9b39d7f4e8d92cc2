package argo.testkit

import argo.filters.dropFilter
import argo.recording.recorded
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldMatch
import io.kotest.matchers.string.shouldStartWith
import java.nio.file.Path
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class ReplayedDriveSpec : FunSpec({
    val program = "!start.\n+!start <- argo.port(ttyACM0); argo.percepts(open); argo.act(forward).\n+dist(Cm) : Cm < 40 <- argo.act(stop)."

    val drive = recorded(program) {
        perceives("dist(80)")
        after(1.seconds)
        perceives("dist(30)")
        after(500.milliseconds)
    }

    fun now(text: String): Path = drive.resolveSibling("now.asl").apply { writeText(text) }

    test("the agent sends the same") {
        val same = replayed("$drive", program = "${now("// the same\n$program")}")
        same.shouldSendTheSame(within = 20.milliseconds).sent shouldContain "stop"
    }

    test("the agent sends something else, and the failure has the first command that differs") {
        val message = shouldThrow<AssertionError> {
            replayed("$drive", program = "${now(program.replace("argo.act(stop)", ".print(stop)"))}").shouldSendTheSame()
        }.message.orEmpty()
        message shouldStartWith "expected that agent agent sends what is recorded in $drive, but it does not send stop at 1"
        message shouldContain "(agent.asl:3)"
        message shouldContain "1 command before is the same\nrecorded: \n    0 ms: forward (agent.asl:2)\n    1"
        message.lines().last() shouldMatch Regex(""" {4}\d ms: forward \(now\.asl:2\)""")
    }

    test("the agent perceives its boards through another filter") {
        val path = "${now(program)}"
        val careless = dropFilter("careless") { drop("dist") { argument(0) lt 50 } }
        replayed("$drive", program = path, filter = careless).sent shouldBe listOf("forward")
        val dull = dropFilter("dull") { drop("dist") { argument(0) deadband 5 } }
        replayed("$drive", program = path, filter = dull).shouldSendTheSame()
    }

    test("what cannot be replayed is refused in words") {
        shouldThrow<IllegalArgumentException> { replayed("absent.mcap") }.message shouldStartWith
            "there is no recording absent.mcap; looked for"
        shouldThrow<IllegalArgumentException> { replayed("$drive") }.message shouldStartWith "there is no agent agent.asl; looked for"
        shouldThrow<IllegalArgumentException> { replayed("$drive", "eve", "${now(program)}") }.message shouldBe
            "the recording has no agent eve; those that it has: agent"
    }
})
