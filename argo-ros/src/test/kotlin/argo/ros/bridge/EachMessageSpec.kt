package argo.ros.bridge

import argo.ros.mapping.mappingOf
import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.util.concurrent.TimeUnit
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

private const val PORT = "ros://robot:9090#each"

class EachMessageSpec : FunSpec({
    val told = ArrayList<String>()
    fun messages(rule: String) = TopicMessages(mappingOf("percepts:\n  - $rule", "t").percepts, { null }, told::add)
    fun data(value: Any) = JsonObject(mapOf("data" to if (value is Boolean) JsonPrimitive(value) else JsonPrimitive("$value")))
    fun TopicMessages.texts() = generateSequence { if (hasNews(0)) take(0) else null }.map { it.text to it.event }.toList()
    beforeTest { told.clear() }

    test("each message is a message of the robot, with one without it between two that are alike") {
        val messages = messages("/said std_msgs/String -> said(data) all")
        for (word in listOf("a", "b", "b")) messages.add("/said", data(word), 0, 0)
        messages.texts() shouldBe
            listOf("said(\"a\")", "said(\"b\")", "", "said(\"b\")", null).map { (if (it.isNullOrEmpty()) "" else "$it;") to it }
    }
    test("of more events than may wait the oldest are lost, and counted") {
        val messages = messages("/said std_msgs/String -> said(data) all")
        repeat(1_003) { messages.add("/said", data(it), 0, 0) }
        messages.take(0).text shouldBe "said(\"3\");"
        told shouldBe listOf(1, 2).map { "$it events of /said and others are lost, since more than 1000 waited" }
    }
    test("a percept with a condition and a time lasts that long from the last message that meets the condition") {
        val ms = TimeUnit.MILLISECONDS.toNanos(1)
        val messages = messages("/bumper std_msgs/Bool -> hit if data == 'true' for 500 ms")
        messages.add("/bumper", data(true), 0, 0)
        messages.add("/bumper", data(false), 1 * ms, 1 * ms)
        messages.take(2 * ms).text shouldBe "hit;"
        messages.dueNanos() shouldBe 500 * ms
        messages.add("/bumper", data(true), 300 * ms, 300 * ms)
        messages.take(600 * ms).text shouldBe "hit;"
        messages.hasNews(800 * ms) shouldBe true
        messages.take(800 * ms).text shouldBe ""
    }

    test("an agent has an event for each message, in their order, whatever its interval, and sees the shortest press") {
        val program = """
            heard(0).
            !start.
            +!start <- argo.port("$PORT"); argo.limit(200); argo.percepts(open).
            +said(W) : heard(N) <- -+heard(N + 1); .print(N, W).
            +hit <- .print("hit").
        """
        agentOf(program) { board(PORT).playsItsMapping() }.use { robot ->
            robot.shouldBelieve("port(\"$PORT\",on)")
            robot.after(300.milliseconds)
            val words = listOf("a", "b", "b", "b", "a", "c")
            words.forEach { robot.board.publishes("/said", "${data(it)}") }
            robot.board.publishes("/bumper", "${data(true)}").publishes("/bumper", "${data(false)}")
            robot.shouldBelieve("heard(${words.size})", within = 5.seconds).shouldPrint("hit")
            robot.printed.filter { it != "hit" } shouldBe words.mapIndexed { index, word -> "$index$word" }
            robot.after(600.milliseconds)
            robot.shouldNotBelieve("hit")
        }
    }
})
