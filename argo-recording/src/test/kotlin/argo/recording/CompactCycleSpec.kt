package argo.recording

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import kotlinx.serialization.json.Json

private val texts = Arb.list(Arb.element("dist(1)", "dist(2)", "temp(21.50)", "light( 3 )", "say(\"a b\")"), 0..6)
private val snapshots = Arb.bind(texts, texts, Arb.int(0..1)) { texts, kept, isFiltered ->
    PerceivedSnapshot("ttyACM0", null, 5, texts, if (isFiltered == 1) kept else null)
}
private val changes = Arb.bind(Arb.int(0..3), texts.map { now -> now.map { it.replace(" )", ")").replace("( ", "(") } }, Arb.int(0..3)) {
        keep, now, keepLast ->
    PerceptChange(keep, now, keepLast)
}

class CompactCycleSpec : FunSpec({
    test("a cycle is read as it was") {
        val places = Arb.element(Place("go", "robot.asl", 3), Place("p__2", "robot.asl", 9), Place())
        checkAll(Arb.list(snapshots, 0..3), changes, places, places) { snapshots, change, plan, stepOf ->
            val step = Step(1, 1, if (stepOf == Place()) plan else stepOf, 4, "argo.act(stop)")
            val cycle = Cycle(1, 1, 7, input = Input(snapshots = snapshots, percepts = change), course = Course(plan = plan, step = step))
            val text = Json.encodeToString(Cycle.serializer(), cycle.compact())
            Json.decodeFromString(Cycle.serializer(), text).whole() shouldBe cycle
        }
    }

    test("percepts stand once, also where a board writes some in another way") {
        val texts = (1..12).map { "dist(front, $it)" } + "temp(21.50)"
        val now = (1..12).map { "dist(front,$it)" } + "temp(21.5)"
        val cycle = Cycle(1, 1, 7, input = Input(listOf(), listOf(PerceivedSnapshot("p", null, 5, texts)), PerceptChange(1, now, 1)))
        val text = Json.encodeToString(Cycle.serializer(), cycle.compact())
        text shouldContain """"percepts":{"keep":1,"keepLast":1,"take":13,"others":{"12":"temp(21.5)"}}"""
        text.split("dist(").size shouldBeLessThan 14
        Json.decodeFromString(Cycle.serializer(), text).whole() shouldBe cycle
    }

    test("the schema in the file has the type and the meaning of each field") {
        val schema = jsonSchema(Cycle.serializer().descriptor)
        schema shouldContain """"receivedNs":{"description":"when its last byte came, in ns of the agent's clock","type":"integer"}"""
        val fields = Regex(""""(\w+)":\{("description")?""").findAll(schema).filter { it.groupValues[1] !in setOf("properties", "items") }
        val unexplained = fields.filter { it.groupValues[2].isEmpty() && it.groupValues[1] != "additionalProperties" }
        unexplained.map { it.value }.toList().shouldBeEmpty()
    }
})
