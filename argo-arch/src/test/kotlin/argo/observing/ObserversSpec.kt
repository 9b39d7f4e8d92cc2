package argo.observing

import argo.jason.TestMas
import argo.jason.eventually
import argo.jason.onRobot
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainInOrder
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

private const val LOOKS = """
    !start.
    +!start <- argo.port("sim:robot"); argo.limit(5); argo.change_filter(front); argo.percepts(open); argo.act(hello).
    +dist(f,_) <- argo.act(seen).
"""
private const val FRONT =
    """<PerceptionFilter><filter><predicate>dist</predicate><parameter id="0" operator="NE">f</parameter></filter></PerceptionFilter>"""

class ObserversSpec : FunSpec({
    fun TestMas.diary() = architecture("bob").observers.filterIsInstance<Diary>().single()
    fun TestMas.bob(vararg options: Pair<String, String>, program: String = LOOKS) {
        file("front.xml", FRONT)
        agent("bob", program, options = mapOf(*options))
    }

    test("an observer is called for messages, commands, ports and filters, and closed when the agent ends") {
        onRobot("dist(f,38);dist(b,90);X;") { board, mas ->
            mas.bob("argo_diary" to "yes")
            val diary = mas.diary()
            board.awaitMessage("seen", 20_000)
            eventually({ diary.lines }) { "ended 2 well" in diary.lines }
            mas.kill("bob")
            eventually({ diary.lines }) { "closed" in diary.lines }
            val message = "[dist(f,38), dist(b,90), X] kept [dist(f,38), X] unreadable [X] of sim:robot"
            diary.lines.toList().shouldContainInOrder(
                "port \"sim:robot\" on", "filter front", "filtered $message", "perceived $message", "issued 2 seen on sim:robot", "ended 2 well",
            )
            diary.lines.toList().shouldContainInOrder("issued 1 hello on sim:robot", "ended 1 well")
            diary.agent.name shouldBe "bob"
        }
    }

    test("an observer that throws at every call ends neither the agent nor its sensing nor another observer, and is reported once") {
        onRobot("dist(f,38);") { board, mas ->
            mas.bob("argo_broken" to "yes", "argo_diary" to "yes")
            board.awaitMessage("seen", 20_000)
            val diary = mas.diary()
            val messages = { diary.lines.count { it.startsWith("filtered") } }
            val before = messages()
            eventually(messages) { messages() > before + 3 }
            mas.kill("bob")
            eventually({ diary.lines }) { "closed" in diary.lines }
            mas.log.lines().filter { "an observer that throws failed" in it }.size shouldBe 1
        }
    }

    test("an observer that cannot be opened is reported, and the agent runs without") {
        onRobot("dist(f,38);") { board, mas ->
            mas.bob("argo_broken" to "open", "argo_diary" to "none")
            board.awaitMessage("seen", 20_000)
            mas.architecture("bob").observers.shouldBeEmpty()
            mas.log shouldContain "argo_broken=open: argo.observing.BrokenProvider failed, and the agent runs without"
        }
    }

    test("an option that nobody reads is reported with those that there are") {
        TestMas().use { mas ->
            mas.bob("argo_speed" to "9", program = "")
            mas.log shouldContain "argo_speed is not an option of argo.Arch, which has argo_sensing="
            mas.log shouldContain "argo_diary=a word"
        }
    }

    test("a live view without its module is reported with what is missing, and the agent runs") {
        onRobot("dist(f,38);") { board, mas ->
            mas.bob("argo_view" to "8080")
            board.awaitMessage("seen", 20_000)
            mas.log shouldContain "what reads it is in the module argo-view (argo.jar has it), which is not on the class path"
        }
    }

    test("an observer sees what it may ask of its agent") {
        onRobot("dist(f,38);") { _, mas ->
            mas.bob("argo_diary" to "yes")
            val diary = mas.diary()
            val agent = diary.agent
            eventually({ diary.lines }) { diary.lines.any { it.startsWith("perceived") } }
            agent.ports() shouldBe listOf(ObservedPort("\"sim:robot\"", "on", isInUse = true, isStale = false))
            agent.filterNames() shouldContain "front"
            agent.perceive(false) {}
            eventually({ agent.isPerceiving }) { !agent.isPerceiving }
        }
    }
})
