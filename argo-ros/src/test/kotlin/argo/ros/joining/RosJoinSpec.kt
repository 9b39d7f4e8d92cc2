package argo.ros.joining

import argo.ros.LIMIT
import argo.ros.TestBridge
import argo.ros.bridge.part
import argo.ros.bridge.text
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import io.kotest.matchers.string.shouldContain
import javino.sim.SimulatedBoards
import javino.sim.Sketch
import picocli.CommandLine
import java.io.PrintWriter
import java.io.StringWriter

class RosJoinSpec : FunSpec({
    test("the tool has boards take part until it is ended, and a board that goes is off until it is back") {
        val sketch = object : Sketch {
            override fun percepts() = listOf("dist(front,38)")

            override fun act(command: String) = true
        }
        SimulatedBoards.plugIn("join_one", sketch)
        TestBridge().use { bridge ->
            fun published(topic: String) = bridge.heard("publish").filter { it.text("topic") == topic }.map { it.part("msg")?.text("data") }
            val words = arrayOf("uno=sim:join_one", "due=sim:join_two", "--at", "127.0.0.1:${bridge.number}", "--interval", "20")
            val tool = Thread { CommandLine(RosJoinCommand()).setErr(PrintWriter(StringWriter())).execute(*words) }.apply { start() }
            eventually(LIMIT) { published("/uno/dist/front") shouldContain "38.0" }
            eventually(LIMIT) { published("/due/port") shouldBe listOf("off") }
            SimulatedBoards.unplug("join_one")
            eventually(LIMIT) { published("/uno/port") shouldBe listOf("on", "off") }
            SimulatedBoards.plugIn("join_one", sketch)
            eventually(LIMIT) { published("/uno/port") shouldBe listOf("on", "off", "on") }
            tool.interrupt()
            eventually(LIMIT) {
                bridge.heard("unadvertise_service").map { it.text("service") } shouldContainExactlyInAnyOrder listOf("/uno/act", "/due/act")
                bridge.clients shouldBe 0
            }
        }
        SimulatedBoards.unplug("join_one")
    }

    test("a number is no address of a bridge") {
        val errors = StringWriter()
        CommandLine(RosJoinCommand()).setErr(PrintWriter(errors)).execute("ttyACM0", "--at", "9090") shouldNotBe 0
        errors.toString() shouldContain "write its address, as \"localhost:9090\""
    }
})
