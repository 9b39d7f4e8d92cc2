package argo.ros.joining

import argo.ros.LIMIT
import argo.ros.TestBridge
import argo.ros.bridge.part
import argo.ros.bridge.text
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.wire.BoardAction

class MembershipSpec : FunSpec({
    lateinit var joined: JoinedRobot
    beforeEach { joined = JoinedRobot(TestBridge()) }
    afterEach { joined.close() }

    context("topics") {
        test("are advertised with their types, latched, when the board speaks of them") {
            joined.says("dist(front,38);hit;")
            val dist = joined.heard("advertise", "topic", "/uno/dist/front")
            dist.text("type") to dist.text("latch") shouldBe ("std_msgs/Float64" to "true")
            joined.heard("advertise", "topic", "/uno/hit").text("type") shouldBe "std_msgs/Bool"
            joined.heard("publish", "topic", "/uno/percepts").part("msg")?.text("data") shouldBe "dist(front,38);hit;"
            joined.published("/uno/dist/front") shouldBe listOf("38.0")
            joined.says("dist(front,37);")
            eventually(LIMIT) { joined.published("/uno/hit") shouldBe listOf("true", "false") }
            joined.bridge.heard("advertise").count { it.text("topic") == "/uno/dist/front" } shouldBe 1
        }
        test("get the newest messages only where the bridge is slow, and nobody waits for it") {
            joined.bridge.answersPings = false
            joined.says("count(1);")
            eventually(LIMIT) { joined.published("/uno/count") shouldBe listOf("1.0") }
            repeat(20_000) { joined.says("count(${it + 2});") }
            joined.bridge.answersPings = true
            eventually(LIMIT) { joined.published("/uno/count") shouldBe listOf("1.0", "20001.0") }
        }
        test("get all percepts of one message that have the same name") {
            joined.says("wall(1,30);wall(2,40);")
            eventually(LIMIT) { joined.published("/uno/wall") shouldBe listOf("[1.0,30.0]", "[2.0,40.0]") }
        }
        test("lack what has no message, which is told once") {
            repeat(3) { joined.says("dist(X);") }
            joined.heard("publish", "topic", "/uno/percepts")
            joined.told.filter { "dist(X)" in it } shouldBe
                listOf("dist(X) is no literal without variables, and is published on /uno/percepts only")
        }
    }

    context("services") {
        test("are of types that there are, or of argo_msgs, and respond with the outcome") {
            joined.heard("advertise_service", "service", "/uno/stop").text("type") shouldBe "std_srvs/Trigger"
            joined.heard("advertise_service", "service", "/uno/move").text("type") shouldBe "argo_msgs/Command"
            joined.heard("advertise_service", "service", "/uno/act").text("type") shouldBe "argo_msgs/Act"
            joined.call("/uno/stop").toString() shouldBe """{"success":true,"message":""}"""
            joined.call("/uno/move", """{"arguments":["0.3","-1"]}""").text("success") shouldBe "true"
            joined.call("/uno/act", """{"command":"move(1,2)"}""").text("success") shouldBe "true"
            joined.call("/uno/fail").toString() shouldBe """{"success":false,"message":"act_failed: the wheel is stuck"}"""
            joined.robot.done.toList() shouldBe listOf("stop", "move(0.3,-1)", "move(1,2)", "fail")
        }
        test("refuse what is no command of the board") {
            joined.call("/uno/move", """{"arguments":["1"]}""").text("message") shouldBe "act_refused: move has 2 arguments, not 1"
            joined.call("/uno/act", """{"command":"X"}""").text("message").orEmpty() shouldContain "'X' is no command"
            joined.robot.done.shouldBeEmpty()
        }
        test("follow the actions that the board has") {
            joined.heard("advertise_service", "service", "/uno/stop")
            joined.robot.actions = listOf(BoardAction("move", 1), BoardAction("horn", 0))
            joined.heard("advertise_service", "service", "/uno/horn")
            joined.heard("unadvertise_service", "service", "/uno/stop")
            joined.heard("unsubscribe", "topic", "/uno/stop/command")
            eventually(LIMIT) {
                joined.bridge.heard("subscribe").last { it.text("topic") == "/uno/move/command" }.text("type") shouldBe NUMBER
            }
        }
        test("leave out an action called act, and one of two with the same name for ROS, which is told") {
            joined.robot.actions = listOf(BoardAction("act", 0), BoardAction("'a-b'", 0), BoardAction("'a+b'", 0))
            joined.heard("advertise_service", "service", "/uno/a_b")
            joined.told.joinToString("\n").let {
                it shouldContain "the action act has no service of its own, since /uno/act takes any command as text"
                it shouldContain "'a-b', 'a+b' are one name to ROS, and only 'a-b' has a service"
            }
        }
        test("are taken back when the robot leaves, since a bridge would keep them") {
            joined.heard("advertise_service", "service", "/uno/act")
            joined.membership.close()
            listOf("stop", "move", "fail", "act").forEach { joined.heard("unadvertise_service", "service", "/uno/$it") }
            eventually(LIMIT) { joined.bridge.clients shouldBe 0 }
        }
        test("are bounded: of more commands than may be under way the others are refused") {
            joined.heard("advertise_service", "service", "/uno/act")
            repeat(100) { joined.bridge.say("""{"op":"call_service","id":"$it","service":"/uno/act","args":{"command":"hang"}}""") }
            eventually(LIMIT) { joined.robot.done.size shouldBe 100 }
            joined.call("/uno/act", """{"command":"stop"}""").text("message") shouldBe
                "act_refused: 100 commands are under way; /uno/act is not begun"
        }
    }

    context("topics for commands") {
        test("have a type for the number of arguments, and a command replaces those that wait") {
            mapOf("stop" to "std_msgs/Empty", "move" to "geometry_msgs/Twist").forEach { (action, type) ->
                joined.heard("subscribe", "topic", "/uno/$action/command").text("type") shouldBe type
            }
            joined.heard("subscribe", "topic", "/uno/command").text("type") shouldBe STRING
            val twist = """{"linear":{"x":0.5,"y":0,"z":0},"angular":{"x":0,"y":0,"z":-1}}"""
            joined.bridge.say("""{"op":"publish","topic":"/uno/move/command","msg":$twist}""")
            joined.bridge.say("""{"op":"publish","topic":"/uno/stop/command","msg":{}}""")
            joined.bridge.say("""{"op":"publish","topic":"/uno/command","msg":{"data":"move(1,2)"}}""")
            eventually(LIMIT) {
                joined.robot.done.toList() shouldBe listOf("move(0.5,-1), the latest", "stop, the latest", "move(1,2), the latest")
            }
        }
        test("have nobody to answer, so that failures are told once") {
            joined.heard("subscribe", "topic", "/uno/fail/command")
            repeat(2) { joined.bridge.say("""{"op":"publish","topic":"/uno/fail/command","msg":{}}""") }
            joined.bridge.say("""{"op":"publish","topic":"/uno/command","msg":{"data":"7"}}""")
            eventually(LIMIT) {
                joined.told.filter { "/command" in it } shouldBe listOf(
                    "/uno/fail/command: act_failed: the wheel is stuck",
                    "/uno/command: act_refused: '7' is no command; one is a literal, as \"speed(120)\"",
                )
            }
        }
    }

    context("the action act") {
        test("is one of ROS 1 by its topics, and a goal that comes twice is carried out once") {
            joined.heard("subscribe", "topic", "/uno/act/goal").text("type") shouldBe "argo_msgs/ActActionGoal"
            joined.heard("subscribe", "topic", "/uno/act/cancel")
            joined.heard("advertise", "topic", "/uno/act/feedback")
            joined.heard("advertise", "topic", "/uno/act/status").text("latch") shouldBe "true"
            joined.messages("/uno/act/status").shouldNotBeEmpty()
            val goal = """{"goal_id":{"id":"g"},"goal":{"command":"move(1,2)"}}"""
            repeat(2) { joined.bridge.say("""{"op":"publish","topic":"/uno/act/goal","msg":$goal}""") }
            joined.bridge.say("""{"op":"publish","topic":"/uno/act/goal","msg":{"goal_id":{"id":""},"goal":{"command":"fail"}}}""")
            eventually(LIMIT) {
                joined.messages("/uno/act/result").map { it.part("status")?.text("status") to it.part("result")?.text("message") } shouldBe
                    listOf("3" to "", "4" to "act_failed: the wheel is stuck")
            }
            joined.bridge.say("""{"op":"publish","topic":"/uno/act/cancel","msg":{"id":"g"}}""")
            eventually(LIMIT) { joined.told.filter { "not cancelled" in it }.shouldNotBeEmpty() }
            joined.told shouldContain "the goal g of /uno/act has come before, and is not begun again"
            joined.robot.done.toList() shouldBe listOf("move(1,2)", "fail")
        }
    }

    test("the bridge and the graph are left to others: what they send by mistake is told, and hurts nobody") {
        joined.heard("advertise_service", "service", "/uno/act")
        val garbage = listOf("", "{", "null", "[1]", "{}", """{"op":"fly"}""", """{"op":"publish"}""", """{"op":"call_service"}""") +
            "[".repeat(100_000) + """{"op":"publish","topic":"/uno/act/goal","msg":3}""" + """{"op":"send_action_goal"}"""
        garbage.forEach(joined.bridge::say)
        joined.bridge.sayBytes(byteArrayOf(1, 2))
        joined.call("/uno/stop").text("success") shouldBe "true"
        joined.told.joinToString("\n").let {
            it shouldContain "the bridge sends the operation fly, which is not read"
            it shouldContain "no operation of the rosbridge protocol: \"{\""
            it shouldContain "a binary message"
        }
    }

    test("a bridge that goes is joined again when it is back, with all that there is") {
        joined.says("dist(front,38);hit;")
        joined.heard("publish", "topic", "/uno/percepts")
        repeat(2) {
            val number = joined.bridge.number
            joined.bridge.close()
            eventually(LIMIT) { joined.told.count { "closed the connection" in it || "broken" in it } shouldBe it + 1 }
            joined.bridge = TestBridge(number)
            joined.heard("publish", "topic", "/uno/percepts")
            joined.published("/uno/dist/front") shouldBe listOf("38.0")
            joined.call("/uno/stop").text("success") shouldBe "true"
            withClue(joined.told) { joined.told.count { "ROS sees uno as /uno" in it } shouldBe it + 2 }
        }
    }
})
