package argo.ros

import argo.ros.bridge.part
import argo.ros.bridge.text
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotContainDuplicates
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import java.util.concurrent.atomic.AtomicInteger

class RosAgentSpec : FunSpec({
    fun TestBridge.sent(topic: String) = heard("publish").filter { it.text("topic") == topic }.map { checkNotNull(it.part("msg")) }

    test("an agent perceives topics, acts on them, and waits for the result of an action") {
        TestBridge().use { bridge ->
            val program = """
                !start.
                +!start <- argo.port("${bridge.port}"); argo.limit(20); argo.percepts(open); argo.act(move(0.3, 0)).
                +dist(f, D) : D < 40 <- argo.act(stop); !dock.
                +!dock <- argo.act(dock); +docked.
                -!dock[error(E)] <- +why(E).
            """
            Mas(program).use { mas ->
                eventually(LIMIT) { bridge.sent("/cmd_vel").map { "$it" } shouldBe listOf("""{"linear":{"x":0.3},"angular":{"z":0}}""") }
                eventually(LIMIT) {
                    bridge.publish("/sonar/front", """{"range": 0.38}""")
                    mas.awaitBelief("dist(f,38)")
                    bridge.sent("/cmd_vel").size shouldBe 2
                }
                eventually(LIMIT) { bridge.sent("/dock/goal").size shouldBe 1 }
                val id = bridge.sent("/dock/goal").single().part("goal_id")?.text("id")
                bridge.publish("/sonar/front", """{"range": 0.5}""") // percepts arrive while the action is still running
                mas.awaitBelief("dist(f,50)")
                ("docked" in mas.beliefs()) shouldBe false
                bridge.publish("/dock/result", """{"status": {"goal_id": {"id": "$id"}, "status": 3, "text": ""}}""")
                mas.awaitBelief("docked")
                bridge.publish("/sonar/front", """{"range": 0.2}""")
                eventually(LIMIT) { bridge.sent("/dock/goal").size shouldBe 2 }
                val second = bridge.sent("/dock/goal").last().part("goal_id")?.text("id")
                bridge.publish("/dock/result", """{"status": {"goal_id": {"id": "$second"}, "status": 4, "text": "no way"}}""")
                mas.awaitBelief("why(act_failed)")
            }
        }
    }

    test("a filter unsubscribes, and a bridge that is silent makes its port stale") {
        TestBridge().use { bridge ->
            val program = """
                !start.
                +!start <- argo.port("${bridge.port}", [timeout(50)]); argo.limit(20); argo.percepts(open).
                +dist(f, D) : D < 40 <- argo.change_filter(noDist).
            """
            Mas(program).use { mas ->
                mas.awaitBelief("stale(\"${bridge.port}\")")
                bridge.publish("/sonar/front", """{"range": 0.38}""")
                eventually(LIMIT) { bridge.subscribed().keys shouldBe setOf("/count", "/dock/result") }
                mas.awaitNoBelief("dist(f,38)")
            }
        }
    }

    test("a bridge that is killed and restarted ten times is back each time, with no command twice and nothing left behind") {
        var bridge = TestBridge()
        val number = bridge.number
        val done = ArrayList<Int>()
        val program = """
            !start.
            +!start <- argo.port("${bridge.port}"); argo.limit(10); argo.percepts(open).
            +count(N) <- argo.act(did(N)).
        """
        val count = AtomicInteger()

        suspend fun exchange() = eventually(LIMIT) {
            val next = count.incrementAndGet()
            bridge.publish("/count", """{"data": $next}""")
            eventually(kotlin.time.Duration.parse("1s")) { bridge.sent("/done").any { it.text("data") == "$next" } shouldBe true }
        }
        Mas(program).use { mas ->
            exchange()
            val threads = threads()
            repeat(10) {
                bridge.close()
                mas.awaitBelief("port(\"${bridge.port}\",off)")
                done += bridge.sent("/done").map { it.text("data")!!.toInt() }
                bridge = TestBridge(number)
                mas.awaitBelief("port(\"${bridge.port}\",on)")
                exchange()
                bridge.clients shouldBe 1
            }
            eventually(LIMIT) { threads() shouldBeLessThan threads + 1 }
        }
        done += bridge.sent("/done").map { it.text("data")!!.toInt() }
        done.shouldNotContainDuplicates()
        eventually(LIMIT) { bridge.clients shouldBe 0 }
        bridge.close()
    }
})

private fun threads() = Thread.getAllStackTraces().keys.count { it.name.startsWith("argo-bob") }
