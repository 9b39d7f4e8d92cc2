package argo.ros

import argo.ros.bridge.text
import argo.ros.checking.RosCheckCommand
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldBeEmpty
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import picocli.CommandLine
import java.io.PrintWriter
import java.io.StringWriter
import java.net.Socket
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import kotlin.io.path.writeText

private const val MAPPING = """
percepts:
  - /range sensor_msgs/Range -> dist(f, range*100)
  - /other std_msgs/String
commands:
  - horn -> service /horn std_srvs/Trigger
"""

class RosCheckSpec : FunSpec({
    val directory = tempdir().toPath()

    fun check(mapping: String, vararg more: String): Triple<Int, String, String> {
        val file = directory.resolve("robot.ros.yaml").apply { writeText(mapping) }
        val (out, err) = StringWriter() to StringWriter()
        val command = CommandLine(RosCheckCommand()).setOut(PrintWriter(out, true)).setErr(PrintWriter(err, true))
        return Triple(command.execute("$file", *more), "$out", "$err")
    }

    test("a mapping is checked by itself, without a robot") {
        val (status, out, err) = check(MAPPING)
        status shouldBe 0
        out shouldContain "robot.ros.yaml: 2 percepts, 1 command"
        err.shouldBeEmpty()
        check("percepts:\n  - /a sensor_msgs/Range -> d(range)\n  - /b sensor_msgs/Range -> d(range)").let { (failed, _, problems) ->
            failed shouldBe 1
            problems shouldContain "lines 2 and 3 give percepts d/1 that an agent cannot tell apart"
        }
        val missing = StringWriter()
        CommandLine(RosCheckCommand()).setErr(PrintWriter(missing, true)).execute("nothing.ros.yaml") shouldBe 1
        "$missing" shouldBe "nothing.ros.yaml:1:1: there is no such file\n"
        check("percepts:\n  - /a std_msgs/Bool -> A\n  - b").let { (failed, _, problems) ->
            failed shouldBe 1
            problems.trim().lines().size shouldBe 2
        }
    }
    test("against a robot it tells percepts, and everything that has no effect there") {
        TestBridge().use { bridge ->
            bridge.serve("/rosapi/topic_type") { true to JsonObject(mapOf("type" to JsonPrimitive(""))) }
            bridge.serve("/rosapi/publishers") { true to JsonObject(mapOf("publishers" to JsonArray(emptyList()))) }
            bridge.serve("/rosapi/service_type") { true to JsonObject(mapOf("type" to JsonPrimitive("std_srvs/SetBool"))) }
            val checking = CompletableFuture.supplyAsync { check(MAPPING, bridge.port, "--seconds", "1") }
            eventually(LIMIT) {
                bridge.publish("/range", """{"range": 0.5}""")
                checking.isDone shouldBe true
            }
            val (status, out, err) = checking.get(LIMIT.inWholeSeconds, TimeUnit.SECONDS)
            status shouldBe 1
            out shouldContain "  dist(f,50)"
            err shouldContain "no node publishes /other"
            err shouldContain "/horn is of type std_srvs/SetBool on the robot, and the mapping says std_srvs/Trigger"
        }
    }
    test("a field that the robot's type lacks, and a bridge that is not there, are told") {
        TestBridge().use { bridge ->
            val type = """{"typedefs": [{"type": "a/A", "fieldnames": ["x"], "fieldtypes": ["int8"], "fieldarraylen": [-1]}]}"""
            bridge.serve("/rosapi/message_details") { if (it.text("type") == "a/A") true to Json.parseToJsonElement(type) else error("") }
            check("percepts:\n  - /a a/A -> a(y)", bridge.port).let { (status, _, err) ->
                status shouldBe 1
                err shouldContain "2:17: a/A has no field y; it has x"
            }
        }
        Socket().use { silent -> // occupies the port
            silent.bind(null)
            check(MAPPING, "127.0.0.1:${silent.localPort}").let { (status, _, err) ->
                status shouldBe 1
                err shouldContain "nothing listens at 127.0.0.1:${silent.localPort}"
            }
        }
    }
})
