package argo.behaviour

import argo.testkit.TestAgent
import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/** Checks when a change of the wish to sense takes effect. */
class SensingPaceSpec : FunSpec({
    val program = """
        !start.
        +!start <- argo.port(p, [baud(1000000), protocol(1), boot(0)]); argo.limit(60000); argo.percepts(open).
        +!hurry <- argo.limit(100).
        +!pause <- argo.percepts(block).
        +!goOn <- argo.percepts(open).
    """

    fun TestAgent.requestsWithin20msOf(goal: String): Int {
        val before = board.requests.size
        hears("boss", "achieve", goal)
        after(20.milliseconds)
        return board.requests.size - before
    }

    // the change comes at different times between two checks of the line
    listOf(0, 13, 37, 61, 89).forEach { offset ->
        test("a shorter interval takes effect at once, $offset ms into the watch") {
            agentOf(program).use { robot ->
                robot.after(5.seconds + offset.milliseconds)
                robot.requestsWithin20msOf("hurry") shouldBe 1
            }
        }

        test("sensing begins at once when perceiving is opened, $offset ms into the watch") {
            agentOf(program).use { robot ->
                robot.after(61.seconds).requestsWithin20msOf("pause") shouldBe 0
                robot.after(60.seconds + offset.milliseconds).requestsWithin20msOf("goOn") shouldBe 1
            }
        }
    }
})
