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

    fun messages(vararg percepts: String, namespace: String? = null, atMs: Long): List<String> {
        val snapshot = PerceivedSnapshot("ttyACM0", namespace, atMs * 1_000_000, percepts.toList())
        return numbers.of(listOf(snapshot), 7, atMs * 1_000_000 + 7)
            .map { "${it.channel.topic} ${it.timeNs / 1_000_000} ${it.data.decodeToString()}" }
    }

    test("a number in a percept is a message of a topic of its own, when it changes") {
        messages("dist(front,38)", "dist(left,-1.5)", "hit", "door(open)", atMs = 5) shouldBe
            listOf("""/bob/percept/dist/front 5 {"value":38}""", """/bob/percept/dist/left 5 {"value":-1.5}""")
        messages("dist(front,38)", "dist(left,2)", atMs = 200) shouldBe listOf("""/bob/percept/dist/left 200 {"value":2}""")
        schemas.getValue("/bob/percept/dist/front") shouldContain """"properties":{"value":{"type":"number"}}"""
    }

    test("of several changes within a tenth of a second the last one counts, also if the percept changes no more") {
        messages("light(1)", atMs = 300) shouldBe listOf("""/bob/percept/light 300 {"value":1}""")
        messages("light(2)", atMs = 350) shouldBe emptyList()
        messages("light(3)", atMs = 390) shouldBe emptyList()
        messages("light(3)", atMs = 400) shouldBe listOf("""/bob/percept/light 390 {"value":3}""")
        messages("light(3)", atMs = 900) shouldBe emptyList()
    }

    test("several numbers of a percept are in one message, and names have only letters that topics have") {
        messages("pos(1,\"a b\",2e3)", "no percept(", "far(1e999)", namespace = "left", atMs = 5) shouldBe
            listOf("""/bob/percept/left/pos/_a_b_ 5 {"value1":1,"value2":2000}""")
    }

    test("numbers by which percepts of one message differ are names") {
        messages("servo(1,90)", "servo(2,45)", atMs = 5) shouldBe
            listOf("""/bob/percept/servo/1 5 {"value":90}""", """/bob/percept/servo/2 5 {"value":45}""")
        messages("servo(2,50)", atMs = 200) shouldBe listOf("""/bob/percept/servo/2 200 {"value":50}""")
    }

    test("of a thousand topics and more it is told once that the others have none") {
        repeat(1_010) { messages("made($it,up$it)", atMs = 5) }
        messages("made(1,up1009)", atMs = 5) shouldBe emptyList()
        told.single() shouldContain "more than 1000 percepts of agent bob have numbers; the others have no topic of their own"
    }
})
