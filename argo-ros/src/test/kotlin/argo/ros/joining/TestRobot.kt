package argo.ros.joining

import argo.ros.LIMIT
import argo.ros.TestBridge
import argo.ros.bridge.LimitedWarnings
import argo.ros.bridge.part
import argo.ros.bridge.text
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.matchers.nulls.shouldNotBeNull
import javino.link.SendOptions
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonObject
import java.util.concurrent.ConcurrentLinkedQueue

internal class TestRobot : Participant {
    override val name = "uno"

    @Volatile
    override var actions: List<BoardAction>? = listOf(BoardAction("stop", 0), BoardAction("move", 2), BoardAction("fail", 0))

    val done = ConcurrentLinkedQueue<String>()

    override fun act(command: String, options: SendOptions, done: (Outcome) -> Unit) {
        this.done += if (options.latest()) "$command, the latest" else command
        if (command != "hang") done(if (command == "fail") Outcome("act_failed", "the wheel is stuck") else Outcome.DONE)
    }
}

internal class JoinedRobot(var bridge: TestBridge) : AutoCloseable {
    val robot = TestRobot()

    val told = ConcurrentLinkedQueue<String>()
    private val warn = LimitedWarnings { told += it }
    val topics = Topics(warn)
    private val publisher = PerceptPublisher("/uno", topics, warn)
    val membership = Membership(robot, topics, BridgeAddress.of("127.0.0.1:${bridge.number}"), { told += it }, warn).apply { start() }

    fun says(message: String) = publisher.publish(message)

    fun published(topic: String) = messages(topic).map { it.text("data") ?: "${it["data"]}" }

    fun messages(topic: String) = bridge.heard("publish").filter { it.text("topic") == topic }.mapNotNull { it.part("msg") }

    suspend fun heard(op: String, name: String, value: String): JsonObject {
        var found: JsonObject? = null
        eventually(LIMIT) { found = bridge.heard(op).find { it.text(name) == value }.shouldNotBeNull() }
        return checkNotNull(found)
    }

    suspend fun call(service: String, arguments: String = "{}"): JsonObject {
        heard("advertise_service", "service", service)
        val id = "call-${System.nanoTime()}"
        bridge.say("""{"op":"call_service","id":"$id","service":"$service","args":$arguments}""")
        return checkNotNull(heard("service_response", "id", id).part("values"))
    }

    override fun close() {
        membership.close()
        bridge.close()
    }
}
