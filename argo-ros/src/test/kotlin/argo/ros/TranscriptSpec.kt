package argo.ros

import argo.links.Wish
import argo.ros.bridge.SilentTopics
import argo.ros.mapping.findMapping
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.booleans.shouldBeTrue
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import javino.LineClock
import java.net.URI
import java.util.concurrent.atomic.AtomicLong

private val SESSION_OUTCOMES = setOf(
    "outcome(move(0.5,0.25),done)", "outcome(horn,done)", "outcome(lamp(true),done)", "outcome(lamp(false),act_failed)",
    "outcome(none,act_failed)", "outcome(drive(2),done)", "outcome(drive(-2),act_failed)", "outcome(drive(0),act_refused)",
    "outcome(drive(100),act_unconfirmed)",
)

/** Tests ARGO's client against recorded messages of rosbridge 0.11.17, with the robot of `src/test/ros/robot.py`. */
class TranscriptSpec : FunSpec({
    test("an agent perceives and commands a robot behind rosbridge") {
        TranscriptBridge("session").use { bridge ->
            val program = """
                !start.
                +!start <-
                    argo.port("ros://127.0.0.1:${bridge.number}#transcripts/session"); argo.limit(200); argo.percepts(open);
                    !try(move(0.5, 0.25)); !try(horn); !try(lamp(true)); !try(lamp(false)); !try(none);
                    !try(drive(2)); !try(drive(-2)); !try(drive(0)); !try(drive(100)); +tried.
                +!try(C) <- argo.act(C); +outcome(C, done).
                -!try(C)[error(E)] <- +outcome(C, E).
                +dist(f, D) : argo.age(dist(f, D), Ms) & Ms < 10000 <- +measured.
            """
            Mas(program).use { mas ->
                mas.awaitBelief("tried")
                mas.beliefs().filter { it.startsWith("outcome(") }.toSet() shouldBe SESSION_OUTCOMES
                mas.awaitBelief("scan(0.75)") // rosbridge writes an infinite range and a NaN as null: [null, null, 1.5, 0.75]
                mas.awaitBelief("measured")
                withClue(mas.beliefs()) { mas.beliefs().any { it.startsWith("count(") }.shouldBeTrue() }
            }
        }
    }

    test("what rosbridge keeps to itself is in the log: other types, types that it does not know, topics that nobody publishes") {
        val ahead = AtomicLong()
        val clock = LineClock { System.nanoTime() + ahead.get() }
        val log = LoggedWarnings()
        val bridge = TranscriptBridge("conflict")
        log.use {
            bridge.use {
                val mapping = findMapping("transcripts/conflict")
                RosLink.open("robot", URI("ws://127.0.0.1:${bridge.number}/"), mapping, true, clock).use { link ->
                    link.wants(Wish(true, 50, null))
                    ahead.set(2 * SilentTopics.LIMIT_NANOS)
                    eventually(LIMIT) {
                        link.listen(10)
                        val all = log.messages.map { it.removePrefix("port robot: ").removeSuffix(" Caused by: gripper_msgs") }
                        all shouldContainAll listOf(
                            "/count is of type std_msgs/Int32 on the robot, and the mapping says std_msgs/String: " +
                                "its messages do not pass the bridge",
                            "/cmd_vel is of type geometry_msgs/Twist on the robot, and the mapping says std_msgs/Int32: " +
                                "its messages do not pass the bridge",
                            "the bridge does not know the type gripper_msgs/State, so the agent gets no percepts from its messages: " +
                                "service [/rosapi/message_details] responded with an error: b'error processing request: " +
                                "Unable to load the manifest for package gripper_msgs.",
                            "no node publishes /nobody",
                            "no node publishes /gripper",
                        )
                    }
                }
            }
        }
    }
})
