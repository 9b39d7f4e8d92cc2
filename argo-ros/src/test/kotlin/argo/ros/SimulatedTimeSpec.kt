package argo.ros

import argo.links.Wish
import argo.ros.bridge.Bridge
import argo.ros.bridge.BridgeListener
import argo.ros.bridge.Outgoing
import argo.ros.bridge.operation
import argo.ros.bridge.operationIn
import argo.ros.bridge.text
import argo.ros.mapping.mappingOf
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.longs.shouldBeInRange
import io.kotest.matchers.shouldBe
import javino.LineClock
import kotlinx.serialization.json.Json
import java.util.concurrent.TimeUnit

private const val STEP_MS = 10L

private const val DELAY_MS = 30L

/** A robot in a simulator, in virtual time. Every fifth step it publishes `/clock` and a message that was true [DELAY_MS] ago. */
private class SimulatedRobot(private val hasClock: Boolean = true) : Bridge {
    private var nowMs = 1_000L
    private var simMs = 5_000.0
    private val history = ArrayDeque<Double>() // the simulated times of the last steps
    private val subscribed = HashSet<String>()
    private lateinit var listener: BridgeListener
    val link = RosLink.over("ros://sim", mappingOf("percepts:\n  - /d sensor_msgs/Range -> d(range)", "sim"), true, clock()) {
        this.also { _ -> listener = it }
    }

    private fun clock() = LineClock { TimeUnit.MILLISECONDS.toNanos(nowMs) }

    /**
     * Runs for [seconds] at [speed], and returns the ages of the messages in ms.
     * @param isShown true if `/clock` is published
     */
    fun run(seconds: Int, speed: Double, isShown: Boolean = true): List<Long> {
        val ages = ArrayList<Long>()
        repeat((seconds * 1_000 / STEP_MS).toInt()) { step ->
            nowMs += STEP_MS
            simMs += STEP_MS * speed
            history.addLast(simMs)
            if (history.size > DELAY_MS / STEP_MS + 1) history.removeFirst()
            if (isShown && step % 5 == 0) publish("/clock", """{"clock": ${time(simMs)}}""")
            if (step % 5 == 2) publish("/d", """{"header": {"stamp": ${time(history.first())}}, "range": $step}""")
            if (step % 5 == 2) link.listen(1_000)?.let {
                ages += TimeUnit.NANOSECONDS.toMillis(it.receivedNanos - it.seenNanos.getValue("d($step)"))
            }
        }
        return ages
    }

    fun jumpBack(ms: Long) {
        simMs -= ms
        history.clear()
    }

    val topics: Set<String> get() = subscribed

    private fun time(ms: Double): String =
        (ms * 1_000_000).toLong().let { """{"secs": ${it / 1_000_000_000}, "nsecs": ${it % 1_000_000_000}}""" }

    private fun publish(topic: String, message: String) {
        if (topic in subscribed) listener.text("""{"op": "publish", "topic": "$topic", "msg": $message}""")
    }

    override fun send(message: Outgoing) {
        val operation = checkNotNull(operationIn(message.text))
        when (operation.text("op")) {
            "subscribe" -> subscribed += operation.text("topic").orEmpty()
            "unsubscribe" -> subscribed -= operation.text("topic").orEmpty()
            "call_service" -> {
                val values = when (operation.text("service")) {
                    "/rosapi/get_time" -> """{"time": ${time(simMs)}}"""
                    "/rosapi/topic_type" -> """{"type": "${if (hasClock && "/clock" in message.text) "rosgraph_msgs/Clock" else ""}"}"""
                    else -> "{}"
                }
                val answer = Json.parseToJsonElement(values)
                listener.text(operation("service_response", "id" to operation.text("id"), "values" to answer, "result" to true))
            }
        }
        message.left.complete(Unit)
    }

    override fun queue(message: Outgoing) = send(message)
    override fun flush() = Unit
    override fun ping() = listener.isAlive()
    override fun close() = Unit
}

class SimulatedTimeSpec : FunSpec({
    fun robot(hasClock: Boolean = true) = SimulatedRobot(hasClock).apply {
        link.wants(Wish(true, 50, null))
        run(1, 1.0) // the link first has to detect the simulated time
    }

    fun List<Long>.shouldBeRight() = forEachIndexed { index, age -> withClue("message $index of $size") { age shouldBeInRange (0L..80L) } }

    for (speed in listOf(0.1, 0.5, 1.0, 2.0, 10.0)) {
        test("ages are right with a simulator of $speed times the speed, for minutes") {
            robot().apply { run(1, speed) }.run(120, speed).shouldBeRight()
        }
    }
    test("ages are right while the speed changes") {
        val robot = robot()
        for (speed in listOf(1.0, 0.3, 3.0, 0.5, 1.0)) robot.run(3, speed).shouldBeRight()
    }
    test("ages are right while the simulator stands, and when it goes on") {
        for (isShown in listOf(true, false)) {
            val robot = robot()
            robot.run(5, 0.5).shouldBeRight()
            val standing = robot.run(30, 0.0, isShown)
            // without /clock, the link detects the stop after one second
            withClue("/clock is shown: $isShown") { standing.drop(25).shouldBeRight() }
            robot.run(5, 0.5).shouldBeRight()
        }
    }
    test("ages are right from the message on that follows a jump back of the simulator's time") {
        val robot = robot().apply { run(20, 2.0) }
        robot.jumpBack(15_000)
        robot.run(20, 2.0).shouldBeRight()
    }
    test("the clock is subscribed to while the agent perceives") {
        val robot = robot()
        robot.topics shouldContain "/clock"
        robot.link.wants(Wish(false, 50, null))
        robot.topics shouldBe emptySet()
    }
    test("a clock that nobody shows leaves the answers of rosapi, of which a new one replaces those that do not fit it") {
        val robot = robot(hasClock = false)
        robot.topics shouldBe setOf("/d")
        robot.jumpBack(100_000)
        robot.run(20, 1.0).drop(300).shouldBeRight()
    }
})
