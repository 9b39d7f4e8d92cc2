package argo.exploring

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class EventsSpec : FunSpec({
    val all = listOf(
        Reads(1.seconds, "ttyACM0", "dist(front,%d)", "dist(front,30)"),
        Reads(1.seconds, "ttyACM0", "say(\"a\\b\")|", "say(\"a\\b\")"),
        Flickers(2.seconds, "ttyACM0", "lamp", "lamp(on)", "", 50.milliseconds, 1.seconds),
        Unplugged(3.seconds, "ttyACM0", 1.seconds),
        Hangs(4.seconds, "ttyACM0", 1.seconds),
        IgnoresRequests(5.seconds, "ttyACM0", 1.seconds),
        AnswersLate(6.seconds, "ttyACM0", 200.milliseconds, 1.seconds),
        Restarts(7.seconds, "ttyACM0", 500.milliseconds),
        Garbles(8.seconds, "ttyACM0", 20, 1.seconds),
        Floods(9.seconds, "ttyACM0", 10),
        Hears(10.seconds, "robot", "boss", "achieve", "go(3)"),
        MessagesLate(11.seconds, "robot", 300.milliseconds, 1.seconds),
    )

    test("each event is read back from its JSON as it was") {
        eventsOf(jsonOf(all)) shouldBe all
        all.map { it.form.kind }.toSet() shouldBe KINDS.toSet()
        eventsOf(jsonOf(emptyList())) shouldBe emptyList()
    }

    test("each event is a call in Kotlin") {
        all.first().form.kotlin shouldBe """Reads(1000.milliseconds, "ttyACM0", "dist(front,%d)", "dist(front,30)")"""
        all[1].form.kotlin shouldContain """"say(\"a\\b\")""""
    }

    mapOf(
        "[{\"event\":\"Flies\",\"at_ms\":1}]" to "there is no event Flies; there are Reads",
        "[{\"event\":\"Hangs\",\"at_ms\":1,\"board\":\"x\"}]" to "\"lasts_ms\" is a whole number of ms",
        "[{\"at_ms\":1}]" to "a field \"event\"",
        "[{\"event\":\"Hangs\"," to "these are no events in JSON: ",
        "[\n{\"event\":\"Hangs\" \"at_ms\":1}]" to "line no=2",
        "[{\"event\":\"Hangs\",\"at_ms\":1.5}]" to "\"at_ms\" is a text or a whole number, not 1.5",
        "[{\"event\":\"Floods\",\"messages\":99999999999}]" to "\"messages\" is a text or a whole number, not 99999999999",
        "[] x" to "these are no events in JSON: ",
        "{}" to "it is no array",
        "[1]" to "1 is no object",
        "" to "these are no events in JSON: ",
        "[{\"event\":\"\\u12" to "these are no events in JSON: ",
    ).forEach { (json, why) ->
        test("$json is refused in words") {
            shouldThrow<IllegalArgumentException> { eventsOf(json) }.message shouldContain why
        }
    }

    test("the same seed draws the same events, another one others") {
        val exploration = Exploration().apply { board("ttyACM0") { sensor("dist(front,%d)", 5..200) } }
        val source = RandomEvents(exploration, listOf("robot"))
        source.events(7) shouldBe RandomEvents(exploration, listOf("robot")).events(7)
        (1L..50L).map(source::events).distinct().size shouldBe 50
        (1L..50L).flatMap(source::events).all { it.at <= exploration.eventful } shouldBe true
    }

    test("all kinds of faults that are played are drawn, and none that is not") {
        fun kinds(vararg faults: Fault) = RandomEvents(
            Exploration().apply {
                board("ttyACM0") { sensor("dist(front,%d)", 5..200) }
                message("robot", "boss", "achieve", "go")
                faults(*faults)
            },
            listOf("robot", "other"),
        ).let { source -> (1L..400L).flatMap(source::events).map { it.form.kind }.toSet() }
        kinds(*Fault.entries.toTypedArray()) shouldBe KINDS.toSet()
        kinds(Fault.CABLES) shouldBe setOf("Reads", "Hears", "Unplugged")
        kinds() shouldBe setOf("Reads", "Hears")
    }

    test("a list is made as short and as plain as it may be") {
        val cause = listOf(Unplugged(3217.milliseconds, "a", 1234.milliseconds), Reads(4111.milliseconds, "a", "d(%d)", "d(37)"))
        val noise = (1..6).map { Hangs((it * 500 + 3).milliseconds, "a", 77.milliseconds) }
        var asked = 0
        val left = Shrinker(budget = 200) { events ->
            asked++
            val cable = events.filterIsInstance<Unplugged>().firstOrNull()
            cable != null && cable.lasts >= 600.milliseconds && events.any { it is Reads && it.at > cable.at }
        }.shrink(noise.take(3) + cause + noise.drop(3))
        left shouldBe listOf(Unplugged(3.seconds, "a", 1.seconds), Reads(4.seconds, "a", "d(%d)", "d(40)"))
        (asked <= 200) shouldBe true
    }
})
