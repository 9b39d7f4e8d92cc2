package argo.ros.serving

import argo.links.BoardLink
import argo.links.BoardLinkProvider
import argo.links.Wish
import argo.ros.LIMIT
import argo.ros.RosLink
import argo.ros.mapping.mappingOf
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeSameInstanceAs
import javino.ActionFailedException
import javino.ActionRefusedException
import javino.LineClock
import javino.PortException
import javino.PortFaultException
import javino.SendOptions
import java.net.URI
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit

private val ROBOT = """
    percepts:
      - /uno/dist/front std_msgs/Float64 -> dist(f, data)
      - /uno/hit std_msgs/Bool -> hit if data == 'true'
      - /uno/door std_msgs/String -> door(data)
    commands:
      - stop -> service /uno/stop std_srvs/Trigger
      - fail -> service /uno/fail std_srvs/Trigger
      - fly -> service /uno/fly std_srvs/Trigger
      - move(V, W) -> /uno/move/command geometry_msgs/Twist
      - go(V, W) -> action /uno/move argo_msgs/action/Command(v = V, w = W) within 20 s
      - tire -> action /uno/fail argo_msgs/action/Command() within 20 s
      - went(V, W) -> action /uno/move argo_msgs/CommandAction(v = V, w = W) within 20 s
      - tired -> action /uno/fail argo_msgs/CommandAction() within 20 s
""".trimIndent()

/** An agent's link to a robot that is a server of this module. */
class RoundTripSpec : FunSpec({
    lateinit var server: TestServer
    beforeTest { server = TestServer() }
    afterTest { server.close() }

    fun open(mapping: String = ROBOT): RosLink {
        val port = server.server.port
        val read = mappingOf(mapping, "robot.ros.yaml")
        return RosLink.open("ros://127.0.0.1:$port", URI("ws://127.0.0.1:$port/"), read, true, LineClock.system())
    }

    fun BoardLink.outcomeOf(command: String): Throwable? = try {
        send(command, SendOptions.defaults()).outcome.get(20, TimeUnit.SECONDS)
        null
    } catch (failed: ExecutionException) {
        failed.cause
    }

    test("percepts arrive as they were, and one that is gone is gone") {
        open().use { link ->
            link.wants(Wish(true, 20, null))
            server.says("dist(front,38);hit;door(open);")
            eventually(LIMIT) { link.listen(1_000)?.text shouldBe "dist(f,38);hit;door(\"open\");" }
            server.says("dist(front,37.5);door(open);")
            eventually(LIMIT) { link.listen(1_000)?.text shouldBe "dist(f,37.5);door(\"open\");" }
        }
    }
    test("commands are carried out once each, by topics, services and actions of both kinds") {
        open().use { link ->
            listOf("stop", "move(0.3,-1)", "go(1,2)", "went(3,4)").forEach { link.outcomeOf(it) shouldBe null }
            eventually(LIMIT) {
                server.robot.done.toSet() shouldBe setOf("stop", "move(0.3,-1), the latest", "move(1,2)", "move(3,4)")
            }
            server.robot.done.size shouldBe 4
        }
    }
    test("failures have their reasons") {
        open().use { link ->
            listOf("fail", "tire", "tired", "fly").forEach { link.outcomeOf(it).shouldBeFailure() }
            link.outcomeOf("fail")?.message.orEmpty() shouldContain "the wheel is stuck"
            link.outcomeOf("tire")?.message.orEmpty() shouldContain "the wheel is stuck"
            link.outcomeOf("tired")?.message.orEmpty() shouldContain "the wheel is stuck"
            link.outcomeOf("fly")?.message.orEmpty() shouldContain "there is no action fly"
        }
    }
    test("a mapping is checked against what the server knows of its types") {
        val wrong = "percepts:\n  - /uno/limits std_msgs/Float64MultiArray -> limits(values)\n"
        shouldThrow<PortFaultException> { open(wrong).close() }.message.orEmpty() shouldContain
            "std_msgs/Float64MultiArray has no field values; it has layout, data"
    }
    test("a server that ends ends the link, and is found again when it is back") {
        val port = server.server.port
        val link = open()
        server.close()
        eventually(LIMIT) { shouldThrow<PortException> { link.check() } }
        link.close()
        server = TestServer(address = "$port")
        open().use { it.outcomeOf("stop") shouldBe null }
        server.robot.done.toList() shouldBe listOf("stop")
    }
    test("the provider of ros:// is made once for all ports") {
        BoardLinkProvider.of("ros://one").shouldNotBeNull() shouldBeSameInstanceAs BoardLinkProvider.of("ros://two")
    }
})

private fun Throwable?.shouldBeFailure() = (this is ActionFailedException || this is ActionRefusedException) shouldBe true
