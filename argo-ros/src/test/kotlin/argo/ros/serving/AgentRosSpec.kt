package argo.ros.serving

import argo.observing.ObservedAgent
import argo.ros.LIMIT
import argo.ros.Mas
import argo.ros.bridge.part
import argo.ros.bridge.text
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.SimulatedBoards
import javino.sim.Sketch
import java.lang.reflect.Proxy
import java.net.ConnectException
import java.net.ServerSocket
import java.net.Socket
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

    fun freePort() = ServerSocket(0).use { it.localPort }
    val program = """
        !start.
        +!start <- argo.port("sim:ros_robot"); argo.limit(20); argo.percepts(open).
        +dist(front, D) : D < 40 <- argo.act(stop); +stopped.
    """

    test("an agent with argo_ros offers what its board says, and commands of clients go the way of its own") {
        val port = freePort()
        Mas(program, "argo_ros" to "$port").use { mas ->
            mas.awaitBelief("dist(front,90)")
            RawClient(port).use { client ->
                client.send("""{"op":"subscribe","topic":"/bob/dist/front"}""")
                client.await("publish").part("msg")?.text("data") shouldBe "90.0"
                client.send("""{"op":"call_service","id":"1","service":"/bob/back"}""")
                client.await("service_response").part("values").toString() shouldBe """{"success":true,"message":""}"""
                client.send("""{"op":"call_service","id":"2","service":"/bob/fly"}""")
                client.await("service_response").part("values")?.text("error") shouldBe "act_refused"
                robot.cm = 30
                mas.awaitBelief("stopped")
                eventually(LIMIT) { client.heard.any { it.part("msg")?.text("data") == "30.0" } shouldBe true }
                robot.done.toList() shouldBe listOf("back", "stop")
                client.send("""{"op":"subscribe","topic":"/bob/port/sim_ros_robot"}""")
                eventually(LIMIT) { client.heard.any { it.part("msg")?.text("data") == "on" } shouldBe true }
            }
        }
        eventually(LIMIT) { shouldThrow<ConnectException> { Socket("127.0.0.1", port).close() } }
    }
    test("an address that others reach without a token is refused, and the agent runs without") {
        val told = ArrayList<String>()
        val log = Logger.getLogger("argo.ros.test").apply {
            useParentHandlers = false
            filter = Filter { told.add(it.message) && false }
        }
        val agent = Proxy.newProxyInstance(javaClass.classLoader, arrayOf(ObservedAgent::class.java)) { _, _, _ -> null } as ObservedAgent
        AgentRosProvider().open("0.0.0.0:${freePort()}", agent, log) shouldBe null
        told.single() shouldContain "argo_ros: whoever reaches 0.0.0.0 can drive the robot: give a token"
    }
})
