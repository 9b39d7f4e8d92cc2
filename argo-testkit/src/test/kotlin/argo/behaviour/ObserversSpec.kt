package argo.behaviour

import argo.observing.ObservedPort
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainInOrder
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.time.Duration.Companion.seconds

class ObserversSpec : FunSpec({
    val project = Project(tempdir().toPath())
    project.filter("front", """<filter><predicate>dist</predicate><parameter id="0" operator="NE">f</parameter></filter>""")

    fun bob(vararg options: Pair<String, String>) = project.agent("""
        !start.
        +!start <- argo.port(ttyACM0); argo.limit(5); argo.change_filter(front); argo.percepts(open); argo.act(hello).
        +dist(f,_) <- argo.act(seen).
    """) { options(*options) }

    test("an observer is called for messages, commands, ports and filters, and closed when the agent ends") {
        bob("argo_diary" to "all").use { bob ->
            bob.perceivesRaw("dist(f,38);dist(b,90);X;").shouldSend("hello").shouldSend("seen").after(1.seconds).stops()
            val diary = DiaryProvider.opened.getValue("all")
            val message = "[dist(f,38), dist(b,90), X] kept [dist(f,38), X] unreadable [X] of ttyACM0"
            diary.lines.toList().shouldContainInOrder(
                "port ttyACM0 on", "filter front", "filtered $message", "perceived $message", "issued 2 seen on ttyACM0", "ended 2 well",
                "closed",
            )
            diary.lines.toList().shouldContainInOrder("issued 1 hello on ttyACM0", "ended 1 well")
            diary.agent.name shouldBe "bob"
        }
    }

    test("an observer that throws at every call ends neither the agent nor its sensing nor another observer, and is reported once") {
        bob("argo_broken" to "yes", "argo_diary" to "other").use { bob ->
            bob.perceives("dist(f,38)").shouldSend("seen")
            val diary = DiaryProvider.opened.getValue("other")
            val before = diary.lines.count { it.startsWith("filtered") }
            bob.after(1.seconds)
            diary.lines.count { it.startsWith("filtered") } shouldBeGreaterThan before + 3
            bob.stops()
            diary.lines.last() shouldBe "closed"
            bob.log.filter { "an observer that throws failed" in it }.size shouldBe 1
        }
    }

    test("an observer that cannot be opened is reported, and the agent runs without") {
        bob("argo_broken" to "open", "argo_diary" to "none").use { bob ->
            bob.perceives("dist(f,38)").shouldSend("seen")
            DiaryProvider.opened["none"] shouldBe null
            bob.log.joinToString("\n") shouldContain
                "argo_broken=open: ${BrokenProvider::class.java.name} failed, and the agent runs without"
        }
    }

    test("an option that nobody reads is reported with those that there are") {
        bob("argo_speed" to "9").use { bob ->
            val log = bob.log.joinToString("\n")
            log shouldContain "argo_speed is not an option of argo.Arch, which has argo_sensing="
            log shouldContain "argo_diary=a word"
        }
    }

    test("a live view without its module is reported with what is missing, and the agent runs") {
        bob("argo_view" to "8080").use { bob ->
            bob.perceives("dist(f,38)").shouldSend("seen").log.joinToString("\n") shouldContain
                "the module argo-view, which argo.jar holds, is not on the class path"
        }
    }

    test("an observer sees what it may ask of its agent") {
        bob("argo_diary" to "asking").use { bob ->
            bob.perceives("dist(f,38)").shouldBelieve("dist(f,38)")
            val diary = DiaryProvider.opened.getValue("asking")
            diary.lines.filter { it.startsWith("perceived") }.size shouldBeGreaterThan 0
            val agent = diary.agent
            agent.ports() shouldBe
                listOf(ObservedPort("ttyACM0", "on", isInUse = true, isStale = false, intervalMs = 5, filter = "front"))
            agent.filterNames() shouldContain "front"
            agent.perceive(false) {}
            bob.after(1.seconds)
            agent.isPerceiving shouldBe false
        }
    }

    test("an observer learns the kinds of percepts that a board describes, once it has asked for them") {
        project.agent("""
            !start.
            +!start <- argo.port(ttyACM0); argo.limit(50); argo.percepts(open).
        """) {
            options("argo_diary" to "kinds")
            board("ttyACM0").version2().describes("dist(f|b, cm 0..400)", "ready")
        }.use { bob ->
            bob.perceives("dist(f,38)").after(1.seconds)
            val agent = DiaryProvider.opened.getValue("kinds").agent
            agent.perceptKinds("ttyACM0").shouldBeEmpty()
            bob.after(1.seconds)
            agent.perceptKinds("ttyACM0").map { "$it" } shouldBe listOf("dist(f|b, cm 0..400)", "ready")
            agent.perceptKinds("ttyACM1").shouldBeEmpty()
            bob.perceives("dist(b,500)").shouldBelieve("dist(b,500)")
        }
    }

    test("a person's command goes the way of argo.act, and its outcome is reported") {
        bob("argo_diary" to "acting").use { bob ->
            bob.perceives("dist(f,38)").shouldSend("seen")
            val agent = DiaryProvider.opened.getValue("acting").agent
            val outcomes = LinkedHashMap<String, String?>()
            fun command(text: String) = agent.act(text) { outcomes[text] = it?.run { "$error: $cause" } ?: "done" }
            command("speed(120)")
            command("\"any text\"")
            bob.shouldSend("speed(120)").shouldSend("any text")
            listOf("speed(", "X", "getPercepts", "\"a\", \"b\"", "left::stop", "", "a. b", "1").forEach(::command)
            bob.after(1.seconds)
            outcomes.filterValues { it == "done" }.keys shouldBe setOf("speed(120)", "\"any text\"")
            outcomes["left::stop"].orEmpty() shouldContain "unknown_board: no board has the namespace left"
            outcomes["getPercepts"].orEmpty() shouldContain "wrong_arguments: a board takes getPercepts for the request for percepts"
            outcomes["\"a\", \"b\""].orEmpty() shouldContain "more than one string"
            outcomes.size shouldBe 10
        }
    }

    test("a person's command without a board fails as that of a plan does") {
        project.agent("likes(tea).") { options("argo_diary" to "alone") }.use { bob ->
            var error: String? = null
            DiaryProvider.opened.getValue("alone").agent.act("stop") { error = it?.error }
            bob.after(1.seconds)
            error shouldBe "no_port"
        }
    }
})
