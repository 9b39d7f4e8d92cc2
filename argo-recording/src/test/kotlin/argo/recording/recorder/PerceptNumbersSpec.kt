package argo.recording.recorder

import argo.recording.PerceivedSnapshot
import argo.recording.storage.RecordChannel
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class PerceptNumbersSpec : FunSpec({
    val told = ArrayList<String>()
    val schemas = HashMap<String, String>()
    fun channel(topic: String, name: String, schema: String) = RecordChannel(topic, name, schema).also { schemas[topic] = schema }
    val numbers = PerceptNumbers("bob", ::channel, told::add)

    fun messages(vararg percepts: String, namespace: String? = null) =
        numbers.of(listOf(PerceivedSnapshot("ttyACM0", namespace, 5, percepts.toList())), 100)
            .map { "${it.channel.topic} ${it.timeNs} ${it.data.decodeToString()}" }

    test("a number in a percept is a message of a topic of its own, when it changes") {
        messages("dist(front,38)", "dist(left,-1.5)", "hit", "door(open)") shouldBe
            listOf("""/bob/percept/dist/front 105 {"value":38}""", """/bob/percept/dist/left 105 {"value":-1.5}""")
        messages("dist(front,38)", "dist(left,2)") shouldBe listOf("""/bob/percept/dist/left 105 {"value":2}""")
        schemas["/bob/percept/dist/front"] shouldBe """{"type":"object","properties":{"value":{"type":"number"}}}"""
    }

    test("several numbers of a percept are in one message, and names have only letters that topics have") {
        messages("pos(1,\"a b\",2e3)", "no percept(", "far(1e999)", namespace = "left") shouldBe
            listOf("""/bob/percept/left/pos/_a_b_ 105 {"value1":1,"value2":2000}""")
    }

    test("of a thousand topics and more it is told once that the others have none") {
        repeat(1_010) { messages("made($it,up$it)") }
        messages("made(1,up1009)") shouldBe emptyList()
        told.single() shouldContain "more than 1000 percepts of agent bob have numbers; the others have no topic of their own"
    }
})
