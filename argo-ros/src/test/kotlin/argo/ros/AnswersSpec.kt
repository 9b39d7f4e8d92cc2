package argo.ros

import argo.recording.replay.Recording
import argo.recording.replay.Replay
import argo.ros.bridge.part
import argo.ros.bridge.text
import argo.ros.mapping.mappingOf
import argo.testkit.agentOf
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.LineClock
import javino.PortFaultException
import javino.link.SendOptions
import kotlinx.serialization.json.Json
import java.net.URI

private const val PORT = "ros://robot:9090#answers"

class AnswersSpec : FunSpec({
    fun agent(plan: String) = agentOf(
        """
        !start.
        +!start <- argo.port("$PORT"); argo.percepts(open); $plan.
        -!start[error(E),error_msg(M)] <- +why(E); .print(M).
        """,
    ) { board(PORT).playsItsMapping() }

    test("an answer is what the mapping says, or the list of all fields, and unifies with a term") {
        val asking = "argo.act(add(1,2), [answer(S)]); +sum(S); argo.act(where, [answer(at(X,_))]); +x(X); " +
            "argo.act(all, [answer(L)]); +all(L)"
        agent(".wait(100); $asking").use {
            it.shouldBelieve("port(\"$PORT\",on)")
            it.board.publishes("/add", """{"sum": 3}""").publishes("/where", """{"pose": {"x": 1.5, "frame": "map"}, "ok": true}""")
            it.shouldBelieve("sum(3)").shouldBelieve("x(1.5)").shouldBelieve("all([pose([x(1.5),frame(\"map\")]),ok(true)])")
        }
    }

    test("an answer is had with argo_sensing=in_cycle too") {
        val program = """!start. +!start <- argo.port("$PORT"); .wait(100); argo.act(add(1,2), [answer(S)]); +sum(S)."""
        agentOf(program) {
            board(PORT).playsItsMapping()
            options("argo_sensing" to "in_cycle")
        }.use {
            it.shouldBelieve("port(\"$PORT\",on)")
            it.board.publishes("/add", """{"sum": 3}""")
            it.shouldBelieve("sum(3)")
        }
    }

    context("an answer that cannot be had fails the plan with the reason:") {
        listOf(
            Triple("argo.act(go, [answer(R)])", "no_answer", "has no answer to \"go\", which was not sent"),
            Triple("argo.act(add(1,2), [answer(R)])", "no_answer", "the message has no field sum; it has "),
            Triple("argo.act(odd, [answer(R)])", "no_answer", "it has a field whose name no agent can read"),
            Triple("argo.act(where, [answer(at(2,_))])", "other_answer", "the answer at(1,\"map\") does not unify with at(2,_"),
        ).forEach { (plan, error, reason) ->
            test(plan) {
                agent(".wait(100); $plan; +done").use {
                    it.shouldBelieve("port(\"$PORT\",on)")
                    it.board.publishes("/where", """{"pose": {"x": 1, "frame": "map"}}""").publishes("/odd", """{"it's": 1}""")
                    it.shouldBelieve("why($error)").shouldNotBelieve("done")
                    it.printed.joinToString() shouldContain reason
                    it.board.published.none { sent -> "/go" in sent } shouldBe true
                }
            }
        }
    }

    test("a recording has answers, and a replay gives them again") {
        val file = tempdir().toPath().resolve("drive.mcap")
        val program = """!start. +!start <- argo.port("$PORT"); .wait(100); argo.act(add(1,2), [answer(S)]); +sum(S); .print(S)."""
        agentOf(program) {
            board(PORT).playsItsMapping()
            options("argo_record" to "$file")
        }.use {
            it.shouldBelieve("port(\"$PORT\",on)")
            it.board.publishes("/add", """{"sum": 3}""")
            it.shouldBelieve("sum(3)")
        }
        Recording(file).use { recording ->
            Replay(recording, false).use { replay ->
                replay.run()
                replay.differences.shouldBeEmpty()
                replay.cyclesRun shouldBeGreaterThan 0L
            }
        }
    }

    test("what a service that is not asked for its answer returns fails no plan") {
        agent("argo.act(add(1,2)); +done").use { it.shouldBelieve("done") }
    }

    context("the feedback of a goal is perceived while it is under way, its result is the answer, and a dropped intention cancels it:") {
        fun plan(bridge: TestBridge, command: String) = """
            !start.
            +!start <- argo.port("${bridge.port}#answers"); argo.percepts(open); argo.limit(20); !go; !again.
            +!go <- argo.act($command, [answer(A)]); +answered(A).
            +!again <- argo.act($command, [answer(A)]); +answered(again).
            +count(1) <- .drop_intention(again); +dropped.
        """

        test("ROS 1") {
            TestBridge().use { bridge ->
                fun goals(part: String) = bridge.heard("publish").filter { it.text("topic") == "/dock/$part" }.mapNotNull { it.part("msg") }
                Mas(plan(bridge, "dock(home)")).use { mas ->
                    eventually(LIMIT) { goals("goal").size shouldBe 1 }
                    val status = """"status": {"goal_id": ${goals("goal")[0]["goal_id"]}, "status": 3, "text": ""}"""
                    bridge.publish("/dock/feedback", """{$status, "feedback": {"percent": 40}}""")
                    mas.awaitBelief("docking(40)")
                    bridge.publish("/dock/result", """{$status, "result": {"station": "home"}}""")
                    mas.awaitBelief("answered(at(\"home\"))")
                    mas.awaitNoBelief("docking(40)")
                    eventually(LIMIT) { goals("goal").size shouldBe 2 }
                    goals("cancel").shouldBeEmpty()
                    eventually(LIMIT) {
                        bridge.publish("/count", """{"data": 1}""")
                        goals("cancel").map { it["id"] } shouldBe listOf(goals("goal")[1].part("goal_id")?.get("id"))
                    }
                }
            }
        }
        test("ROS 2") {
            TestBridge().use { bridge ->
                Mas(plan(bridge, "turn(1)")).use { mas ->
                    eventually(LIMIT) { bridge.heard("send_action_goal").size shouldBe 1 }
                    val goal = bridge.heard("send_action_goal").single()
                    goal.text("feedback") shouldBe "true"
                    val about = """"id": "${goal.text("id")}", "action": "/turn""""
                    bridge.say("""{"op": "action_feedback", $about, "values": {"remaining": 0.5}}""")
                    mas.awaitBelief("turning(0.5)")
                    bridge.say("""{"op": "action_result", $about, "values": {"delta": 1.5}, "status": 4, "result": true}""")
                    mas.awaitBelief("answered(1.5)")
                    mas.awaitNoBelief("turning(0.5)")
                    eventually(LIMIT) { bridge.heard("send_action_goal").size shouldBe 2 }
                    eventually(LIMIT) {
                        bridge.publish("/count", """{"data": 1}""")
                        bridge.heard("cancel_action_goal").map { it.text("id") } shouldBe
                            listOf(bridge.heard("send_action_goal")[1].text("id"))
                    }
                }
            }
        }
    }

    context("the goal of an intention goes on or is cancelled:") {
        listOf("drop_desire(go)" to 1, "fail_goal(go)" to 1, "suspend(go)" to 0).forEach { (action, cancelled) ->
            test(action) {
                val program = """
                    !start.
                    +!start <- argo.port("BRIDGE#answers"); argo.percepts(open); argo.limit(20); !go.
                    +!go <- argo.act(turn(1)).
                    +count(1) <- .$action; +done.
                """
                TestBridge().use { bridge ->
                    Mas(program.replace("BRIDGE", bridge.port)).use { mas ->
                        eventually(LIMIT) { bridge.heard("send_action_goal").size shouldBe 1 }
                        eventually(LIMIT) {
                            bridge.publish("/count", """{"data": 1}""")
                            ("done" in mas.beliefs()) shouldBe true
                        }
                        bridge.publish("/count", """{"data": 2}""") // by the time of this percept, a cancellation would have arrived
                        mas.awaitBelief("count(2)")
                        bridge.heard("cancel_action_goal").size shouldBe cancelled
                    }
                }
            }
        }
    }

    test("a port that is closed cancels the goals that are under way") {
        TestBridge().use { bridge ->
            val mapping = mappingOf("commands:\n  - dock -> action /dock my_msgs/DockAction\n  - turn -> action /turn a/action/Turn", "t")
            fun heard(op: String, name: String) = bridge.heard(op).count { it.text("topic") == name || it.text("action") == name }
            RosLink.open("robot", URI("ws://127.0.0.1:${bridge.number}/"), mapping, true, LineClock.system()).use { link ->
                for (command in listOf("dock", "turn")) link.send(command, SendOptions.defaults())
                eventually(LIMIT) { heard("publish", "/dock/goal") + heard("send_action_goal", "/turn") shouldBe 2 }
            }
            eventually(LIMIT) { heard("publish", "/dock/cancel") + heard("cancel_action_goal", "/turn") shouldBe 2 }
        }
    }

    test("a field of an answer or of feedback that the robot's type lacks is refused when the port is opened") {
        TestBridge().use { bridge ->
            fun type(name: String, field: String) =
                """{"typedefs": [{"type": "$name", "fieldnames": ["$field"], "fieldtypes": ["int64"], "fieldarraylen": [-1]}]}"""
            bridge.serve("/rosapi/service_request_details") { true to Json.parseToJsonElement("""{"typedefs": [{"type": "a/A"}]}""") }
            bridge.serve("/rosapi/service_response_details") { true to Json.parseToJsonElement(type("a/AResponse", "sum")) }
            bridge.serve("/rosapi/message_details") { true to Json.parseToJsonElement(type(it.text("type").orEmpty(), "done")) }
            val mapping = """
                commands:
                  - add -> service /add a/A answer summ
                  - go -> action /go a/GoAction feedback at(dne) answer done
            """.trimIndent()
            val refusal = shouldThrow<PortFaultException> {
                val address = URI("ws://127.0.0.1:${bridge.number}/")
                RosLink.open("robot", address, mappingOf(mapping, "robot.ros.yaml"), true, LineClock.system())
            }.message.orEmpty()
            refusal shouldContain "2:36: a/A has no field summ; it has sum"
            refusal shouldContain "3:45: a/GoFeedback has no field dne; it has done"
        }
    }
})
