package argo.ros.serving

import argo.ros.LIMIT
import argo.ros.bridge.part
import argo.ros.bridge.text
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.net.Socket
import java.net.URI
import java.net.http.WebSocketHandshakeException
import java.util.concurrent.ExecutionException
import kotlin.random.Random

class RosServerSpec : FunSpec({
    lateinit var server: TestServer
    beforeTest { server = TestServer() }
    afterTest { server.close() }

    suspend fun with(work: suspend RawClient.() -> Unit) {
        RawClient(server.server.port).use { it.work() }
    }

    suspend fun RawClient.call(service: String, args: String = "{}"): JsonObject {
        send("""{"op":"call_service","id":"7","service":"$service","args":$args}""")
        return await("service_response").also { it.text("id") shouldBe "7" }
    }

    /** Checks that the client is still served. */
    suspend fun RawClient.isServed() {
        call("/uno/stop").part("values")?.text("success") shouldBe "true"
        server.says("dist(front,38);")
        send("""{"op":"subscribe","topic":"/uno/dist/front"}""")
        await("publish").part("msg")?.text("data") shouldBe "38.0"
    }

    context("topics") {
        test("come to who subscribes, the newest at once") {
            with {
                server.says("dist(front,38);")
                send("""{"op":"subscribe","topic":"/uno/dist/front","type":"std_msgs/Float64"}""")
                await("publish").toString() shouldBe """{"op":"publish","topic":"/uno/dist/front","msg":{"data":38.0}}"""
                server.says("dist(front,37);light(140);")
                await("publish").part("msg")?.text("data") shouldBe "37.0"
                send("""{"op":"unsubscribe","topic":"/uno/dist/front"}""")
                isServed()
                heard.shouldBeEmpty()
            }
        }
    }
    test("a subscription of another type than the topic's is reported") {
        with {
            server.says("dist(front,38);")
            send("""{"op":"subscribe","topic":"/uno/dist/front","type":"std_msgs/String"}""")
            await("status").text("msg") shouldBe "/uno/dist/front is of type std_msgs/Float64, and not std_msgs/String"
            send("""{"op":"subscribe","topic":"/uno/dist/front","type":"std_msgs/msg/Float64"}""")
            isServed()
            heard.filter { it.text("op") == "status" }.shouldBeEmpty()
        }
    }
    test("a name without its first slash is the same name, and messages come by the name that the client gave") {
        with {
            server.says("dist(front,38);")
            send("""{"op":"subscribe","topic":"uno/dist/front"}""")
            await("publish").text("topic") shouldBe "uno/dist/front"
            call("uno/stop").text("service") shouldBe "uno/stop"
            call("rosapi/nodes").text("result") shouldBe "true"
        }
    }
    context("services") {
        test("carry commands out, and respond with the outcome") {
            with {
                call("/uno/move", "[0.3, -1]").part("values").toString() shouldBe """{"success":true,"message":""}"""
                call("/uno/act", """{"command":"move(1,2)"}""").text("result") shouldBe "true"
                call("/uno/fail").part("values").toString() shouldBe
                    """{"success":false,"message":"the wheel is stuck","error":"act_failed"}"""
                server.robot.done.toList() shouldBe listOf("move(0.3,-1)", "move(1,2)", "fail")
            }
        }
        test("that there are not are refused with those that there are") {
            with {
                call("/uno/fly").run {
                    text("result") shouldBe "false"
                    text("values") shouldBe "there is no action fly; there are stop, move, fail"
                }
                call("/due/stop").text("values") shouldBe "there is no /due/stop; services are below /uno"
                call("/rosapi/fly").text("result") shouldBe "false"
                call("/uno/act", """{"command":"X"}""").text("values").orEmpty() shouldContain "'X' is no command"
                server.robot.done.shouldBeEmpty()
            }
        }
    }
    test("a command that is published replaces those that wait") {
        with {
            send("""{"op":"advertise","topic":"/uno/move/command","type":"geometry_msgs/Twist"}""")
            send("""{"op":"publish","topic":"/uno/move/command","msg":{"linear":{"x":0.5},"angular":{"z":0}}}""")
            isServed()
            server.robot.done.first() shouldBe "move(0.5,0), the latest"
            send("""{"op":"publish","topic":"/uno/fail/command","msg":{}}""")
            await("status").text("msg") shouldBe "/uno/fail/command: the wheel is stuck"
        }
    }
    context("actions") {
        test("of ROS 2 are carried out once and have a result") {
            with {
                send("""{"op":"send_action_goal","id":"g1","action":"/uno/move","action_type":"x/action/Y","args":{"arguments":[1,2]}}""")
                await("action_result").toString() shouldBe
                    """{"op":"action_result","id":"g1","action":"/uno/move","values":{"success":true,"message":""},"status":4,"result":true}"""
                send("""{"op":"send_action_goal","id":"g2","action":"/uno/fail"}""")
                await("action_result").run { text("status") to text("result") } shouldBe ("6" to "false")
                send("""{"op":"send_action_goal","id":"g3","action":"/uno/fly"}""")
                await("action_result").part("values")?.text("error") shouldBe "act_refused"
                server.robot.done.toList() shouldBe listOf("move(1,2)", "fail")
            }
        }
        test("of ROS 1 have states and results as topics, and a goal that comes twice is carried out once") {
            with {
                send("""{"op":"subscribe","topic":"/uno/move/status"}""")
                await("publish").part("msg")?.get("status_list") shouldBe JsonArray(emptyList())
                send("""{"op":"subscribe","topic":"/uno/move/result"}""")
                repeat(2) {
                    send("""{"op":"publish","topic":"/uno/move/goal","msg":{"goal_id":{"id":"g"},"goal":{"arguments":[1,2]}}}""")
                }
                await("status").text("msg") shouldBe "the goal g has come before, and is not begun again"
                eventually(LIMIT) {
                    val result = heard.last { it.text("topic") == "/uno/move/result" }.part("msg")
                    result?.part("status")?.text("status") shouldBe "3"
                }
                server.robot.done.toList() shouldBe listOf("move(1,2)")
                send("""{"op":"publish","topic":"/uno/move/cancel","msg":{"id":"g"}}""")
                await("status").text("msg").orEmpty() shouldContain "cannot be taken back"
            }
        }
    }
    test("rosapi tells what there is") {
        with {
            server.says("dist(front,38);hit;")
            fun JsonObject.texts(name: String) = (part("values")?.get(name) as JsonArray).map { it.jsonPrimitive.content }
            call("/rosapi/topics").run {
                texts("topics") shouldBe listOf("/uno/dist/front", "/uno/hit", "/uno/percepts")
                texts("types") shouldBe listOf("std_msgs/Float64", "std_msgs/Bool", "std_msgs/String")
            }
            call("/rosapi/topic_type", """{"topic":"/uno/hit"}""").part("values")?.text("type") shouldBe "std_msgs/Bool"
            call("/rosapi/topics_for_type", """{"type":"std_msgs/msg/Bool"}""").texts("topics") shouldBe listOf("/uno/hit")
            call("/rosapi/services").texts("services") shouldContainAll listOf("/uno/stop", "/uno/move", "/uno/act", "/rosapi/topics")
            call("/rosapi/service_type", """{"service":"/uno/stop"}""").part("values")?.text("type") shouldBe "std_srvs/Trigger"
            call("/rosapi/action_servers").texts("action_servers") shouldContainAll listOf("/uno/stop", "/uno/move")
            call("/rosapi/nodes").texts("nodes") shouldBe listOf("/uno")
            val types = call("/rosapi/message_details", """{"type":"std_msgs/Float64"}""").part("values")?.get("typedefs") as JsonArray
            "${types.single()}" shouldContain """"fieldnames":["data"],"fieldtypes":["float64"]"""
            call("/rosapi/get_time").part("values")?.part("time")?.keys shouldBe setOf("secs", "nsecs")
        }
    }

    context("a client that means harm hurts nobody:") {
        test("garbage is reported") {
            with {
                val garbage = listOf("", "{", "null", "[1]", "\"op\"", "{}", """{"op":7}""", """{"op":"fly"}""", """{"op":"publish"}""") +
                    """{"op":"subscribe"}""" + "[".repeat(100_000) + """{"op":"call_service","service":{},"args":7}""" +
                    """{"op":"send_action_goal","action":"/uno/stop"}""" + """{"op":"publish","topic":"/uno/move/goal","msg":3}""" +
                    """{"op":"subscribe","topic":"/uno/hit","throttle_rate":"soon","queue_length":-1e300}"""
                garbage.forEach(::send)
                isServed()
                server.robot.done.toList() shouldBe listOf("stop")
            }
        }
        test("bytes that are no WebSocket end their connection alone") {
            with {
                val random = Random(17)
                repeat(20) {
                    Socket("127.0.0.1", server.server.port).use { socket ->
                        socket.getOutputStream().write(random.nextBytes(2_000))
                    }
                }
                isServed()
                eventually(LIMIT) { server.server.connections shouldBe 1 }
            }
        }
        test("a handshake without an end is not read for long") {
            Socket("127.0.0.1", server.server.port).use { socket ->
                val line = ("X-A: ${"a".repeat(1_000)}\r\n").toByteArray()
                shouldThrow<java.io.IOException> {
                    socket.getOutputStream().write("GET / HTTP/1.1\r\n".toByteArray())
                    repeat(100_000) { socket.getOutputStream().write(line) }
                }
            }
            with { isServed() }
        }
        test("a huge message ends its connection") {
            with {
                RawClient(server.server.port).use { bad ->
                    try {
                        bad.send("""{"op":"publish","topic":"${"x".repeat(RosServer.MAX_MESSAGE)}"}""")
                    } catch (_: ExecutionException) {
                        // it was left meanwhile
                    }
                    eventually(LIMIT) { bad.isClosed shouldBe true }
                }
                isServed()
            }
        }
        test("a flood ends its connection") {
            with {
                RawClient(server.server.port).use { bad ->
                    try {
                        repeat(100_000) { bad.send("""{"op":"call_service","id":"1","service":"/rosapi/topics"}""") }
                    } catch (_: ExecutionException) {
                        // it was left meanwhile
                    }
                    eventually(LIMIT) { bad.isClosed shouldBe true }
                }
                server.log.toList().forAll { it shouldContain "is left: more than" }
                isServed()
            }
        }
        test("thousands of subscriptions are refused") {
            with {
                RawClient(server.server.port).use { bad ->
                    repeat(Subscriber.MAX_SUBSCRIPTIONS + 10) { bad.send("""{"op":"subscribe","topic":"/uno/t$it"}""") }
                    bad.await("status").text("msg").orEmpty() shouldContain "is one too many: a client has 1000 subscriptions at most"
                }
                isServed()
            }
        }
        test("connections beyond the limit are closed, and those of clients that drop out are given back") {
            val clients = List(RosServer.MAX_CONNECTIONS + 10) { runCatching { RawClient(server.server.port) }.getOrNull() }
            clients.count { it != null } shouldBeLessThanOrEqual RosServer.MAX_CONNECTIONS
            server.log.first() shouldContain "is refused: there are ${RosServer.MAX_CONNECTIONS} connections already"
            val answer = Socket("127.0.0.1", server.server.port).use { it.getInputStream().bufferedReader().readLine() }
            answer shouldBe "HTTP/1.1 503 Service Unavailable"
            clients.forEach { it?.close() } // in the middle of it
            eventually(LIMIT) { server.server.connections shouldBe 0 }
            with { isServed() }
        }
        test("commands without an end wait up to a hundred") {
            server.close()
            server = TestServer(TestRobot(actions = null))
            with {
                repeat(105) { send("""{"op":"call_service","id":"$it","service":"/uno/hang"}""") }
                await("service_response").text("values").orEmpty() shouldContain "100 commands of this client are under way"
                server.robot.done.size shouldBe 100
            }
        }
    }

    test("a page of another site and a client without the token are refused") {
        val address = URI("ws://127.0.0.1:${server.server.port}/")
        fun statusOf(refused: ExecutionException) = (refused.cause as WebSocketHandshakeException).response.statusCode()
        statusOf(shouldThrow<ExecutionException> { RawClient(address, mapOf("Origin" to "https://evil.example")) }) shouldBe 404
        server.log.single() shouldContain "is refused: the page https://evil.example is not of this computer"
        RawClient(address, mapOf("Origin" to "http://localhost:8000")).close()
        TestServer(address = "127.0.0.1:0?token=0123456789abcdef").use { guarded ->
            val port = guarded.server.port
            statusOf(shouldThrow<ExecutionException> { RawClient(port) }) shouldBe 404
            guarded.log.single() shouldContain "is refused: the token is wrong, or there is none"
            RawClient(URI("ws://127.0.0.1:$port/?token=0123456789abcdef"), mapOf("Origin" to "https://studio.example")).close()
        }
    }
    test("pages that are refused thousands of times, with long origins, fill no log") {
        val origin = "https://evil.example/" + "x".repeat(2_000)
        repeat(200) {
            shouldThrow<ExecutionException> { RawClient(URI("ws://127.0.0.1:${server.server.port}/"), mapOf("Origin" to origin)) }
        }
        val lines = server.log.filter { "is refused" in it }
        lines.size shouldBeLessThan 20
        lines.forEach { it.length shouldBeLessThan 300 }
        lines.first() shouldContain "https://evil.example"
        with { isServed() }
    }

    test("a port that is in use is refused, and given back by a server that has ended") {
        val port = server.server.port
        shouldThrow<RefusedServer> { TestServer(address = "$port") }.message.orEmpty() shouldContain "127.0.0.1:$port cannot be had"
        server.close()
        server = TestServer(address = "$port")
        with { isServed() }
    }
})
