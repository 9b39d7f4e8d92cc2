package argo.ros.joining

import argo.ros.LIMIT
import argo.ros.TestBridge
import argo.ros.bridge.OnceEach
import argo.ros.bridge.part
import argo.ros.bridge.text
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.matchers.nulls.shouldNotBeNull
import javino.link.SendOptions
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonObject
import java.util.concurrent.ConcurrentLinkedQueue

/** A robot in this program. */
internal class TestRobot : Participant {
    override val name = "uno"

    @Volatile
    override var actions: List<BoardAction>? = listOf(BoardAction("stop", 0), BoardAction("move", 2), BoardAction("fail", 0))

    /** The commands that it has carried out, in their order. */
    val done = ConcurrentLinkedQueue<String>()

    override fun act(command: String, options: SendOptions, done: (Outcome) -> Unit) {
        this.done += if (options.latest()) "$command, the latest" else command
        if (command != "hang") done(if (command == "fail") Outcome("act_failed", "the wheel is stuck") else Outcome.DONE)
    }
}

/** A robot that takes part in the graph behind [bridge]. */
internal class JoinedRobot(var bridge: TestBridge) : AutoCloseable {
    val robot = TestRobot()

    /** The lines for a person. */
    val told = ConcurrentLinkedQueue<String>()
    private val warn = OnceEach { told += it }
    val topics = Topics(warn)
    private val publisher = PerceptPublisher("/uno", topics, warn)
    val membership = Membership(robot, topics, BridgeAddress.of("127.0.0.1:${bridge.number}"), { told += it }, warn).apply { start() }

    /** Publishes [message] as the robot's board. */
    fun says(message: String) = publisher.publish(message)

    /** Returns the data that the bridge has got for [topic]. */
    fun published(topic: String) = messages(topic).map { it.text("data") ?: "${it["data"]}" }

    /** Returns the messages that the bridge has got for [topic]. */
    fun messages(topic: String) = bridge.heard("publish").filter { it.text("topic") == topic }.mapNotNull { it.part("msg") }

    /** Waits until the bridge has got an operation [op] in which the field [name] is [value], and returns it. */
    suspend fun heard(op: String, name: String, value: String): JsonObject {
        var found: JsonObject? = null
        eventually(LIMIT) { found = bridge.heard(op).find { it.text(name) == value }.shouldNotBeNull() }
        return checkNotNull(found)
    }

    /** Calls [service], which has been advertised, and returns its response. */
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
