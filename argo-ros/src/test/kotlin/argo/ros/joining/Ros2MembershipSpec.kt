package argo.ros.joining

import argo.ros.LIMIT
import argo.ros.TestBridge
import argo.ros.bridge.operationIn
import argo.ros.bridge.text
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import javino.wire.BoardAction

class Ros2MembershipSpec : FunSpec({
    test("in ROS 2 the action act is advertised as such, and results have their values and status") {
        val bridge = TestBridge().apply { serve("/rosapi/get_ros_version") { true to operationIn("""{"version":2,"distro":"jazzy"}""")!! } }
        JoinedRobot(bridge).use { joined ->
            joined.heard("advertise_action", "action", "/uno/act").text("type") shouldBe "argo_msgs/action/Act"
            fun goal(id: String, command: String) =
                bridge.say("""{"op":"send_action_goal","id":"$id","action":"/uno/act","args":{"command":"$command"},"feedback":true}""")
            goal("g1", "move(1,2)")
            goal("g2", "fail")
            joined.heard("action_result", "id", "g1").toString() shouldBe
                """{"op":"action_result","id":"g1","action":"/uno/act","values":{"success":true,"message":""},"status":4,"result":true}"""
            joined.heard("action_result", "id", "g2").run { text("status") to text("result") } shouldBe ("6" to "true")
            bridge.say("""{"op":"cancel_action_goal","id":"g2","action":"/uno/act"}""")
            eventually(LIMIT) { joined.told.find { "not cancelled" in it }.shouldNotBeNull() }
            joined.bridge.heard("advertise").mapNotNull { it.text("topic") }.filter { "/uno/act" in it }.shouldBeEmpty()
        }
    }

    test("what the graph does not show is told with its types, three seconds later") {
        fun answer(text: String) = true to operationIn(text)!!
        val bridge = TestBridge().apply {
            serve("/rosapi/topics") {
                val types = """["std_msgs/msg/String","std_msgs/msg/String",""]"""
                answer("""{"topics":["/uno/hit","/uno/percepts","/uno/stop/command"],"types":$types}""")
            }
            serve("/rosapi/services") { answer("""{"services":["/uno/stop"]}""") }
        }
        JoinedRobot(bridge).use { joined ->
            joined.robot.actions = listOf(BoardAction("stop", 0))
            joined.says("hit;")
            eventually(LIMIT) {
                joined.told shouldContainAll listOf(
                    "/uno/hit is of type std_msgs/msg/String in the graph, so messages of type std_msgs/Bool do not get there",
                    "the graph does not show what was advertised: /uno/command (std_msgs/String), /uno/act (argo_msgs/Act); " +
                        "is the package argo_msgs in the workspace of the bridge?",
                )
            }
        }
    }
})
