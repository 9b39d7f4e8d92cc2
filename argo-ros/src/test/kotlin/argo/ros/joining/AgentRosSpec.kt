package argo.ros.joining

import argo.observing.ObservedAgent
import argo.ros.LIMIT
import argo.ros.Mas
import argo.ros.TestBridge
import argo.ros.bridge.part
import argo.ros.bridge.text
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.SimulatedBoards
import javino.sim.Sketch
import java.lang.reflect.Proxy
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.logging.Filter
import java.util.logging.Logger

private class Robot : Sketch {
    @Volatile
    var cm = 90
    val done = ConcurrentLinkedQueue<String>()

    override fun percepts() = listOf("dist(front,$cm)")

    override fun act(command: String) = (command == "stop" || command == "back").also { if (it) done += command }
}

class AgentRosSpec : FunSpec({
    lateinit var robot: Robot
    beforeTest { robot = Robot().also { SimulatedBoards.plugIn("ros_robot", it) } }
    afterTest { SimulatedBoards.unplug("ros_robot") }

    val program = """
        !start.
        +!start <- argo.port("sim:ros_robot"); argo.limit(20); argo.percepts(open).
        +dist(front, D) : D < 40 <- argo.act(stop); +stopped.
    """

    test("an agent with argo_ros takes part with what its board says, and commands from the graph go the way of its own") {
        TestBridge().use { bridge ->
            fun published(topic: String) = bridge.heard("publish").filter { it.text("topic") == topic }.map { it.part("msg")?.text("data") }

            suspend fun call(id: String, command: String): String? {
                bridge.say("""{"op":"call_service","id":"$id","service":"/bob/act","args":{"command":"$command"}}""")
                eventually(LIMIT) { bridge.heard("service_response").find { it.text("id") == id }.shouldNotBeNull() }
                return bridge.heard("service_response").find { it.text("id") == id }?.part("values")?.text("message")
            }
            Mas(program, "argo_ros" to "\"localhost:${bridge.number}\"").use { mas ->
                mas.awaitBelief("dist(front,90)")
                eventually(LIMIT) { published("/bob/dist/front") shouldContain "90.0" }
                eventually(LIMIT) { bridge.heard("advertise_service").mapNotNull { it.text("service") } shouldContain "/bob/act" }
                call("1", "back") shouldBe ""
                call("2", "fly").orEmpty() shouldContain "act_refused"
                robot.cm = 30
                mas.awaitBelief("stopped")
                eventually(LIMIT) { published("/bob/dist/front") shouldContain "30.0" }
                robot.done.toList() shouldBe listOf("back", "stop")
                eventually(LIMIT) { published("/bob/port/sim_ros_robot") shouldContain "on" }
            }
            eventually(LIMIT) { bridge.clients shouldBe 0 }
            bridge.heard("unadvertise_service").map { it.text("service") } shouldContain "/bob/act"
        }
    }

    listOf("9090" to "write its address, as \"localhost:9090\"", "a b" to "\"ros://a b\" names no robot").forEach { (value, reason) ->
        test("argo_ros=$value is refused with what to write, and the agent runs without it") {
            val told = ArrayList<String>()
            val log = Logger.getLogger("argo.ros.test").apply {
                useParentHandlers = false
                filter = Filter { told.add(it.message) && false }
            }
            val agent = Proxy.newProxyInstance(javaClass.classLoader, arrayOf(ObservedAgent::class.java)) { _, _, _ -> null }
            AgentRosProvider().open(value, agent as ObservedAgent, log) shouldBe null
            told.single() shouldContain reason
        }
    }
})
