package samples.fleet

import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.io.path.Path
import kotlin.time.Duration.Companion.seconds

class ScoutSpec : FunSpec({
    test("a scout reports, drives to the place that it is given, and says when it is there") {
        agent(Path("fleet/scout.asl")) { options("beliefs" to "board(rover)") }.use { scout ->
            scout.shouldSay("achieve(coordinator,hear)")
            scout.hears("coordinator", "achieve", "watch(north)").shouldSend("goto(north)")
            scout.perceives("driving(north)").perceives("at(north)").shouldSay("achieve(coordinator,visited(north))")
        }
    }

    test("it takes no orders from others") {
        agent(Path("fleet/scout.asl")) { options("beliefs" to "board(rover)") }.use { scout ->
            scout.hears("stranger", "achieve", "watch(north)").shouldNotSend("goto(north)")
        }
    }

    test("each trip has its own time, whatever is left of that of an earlier one") {
        agent(Path("fleet/scout.asl")) { options("beliefs" to "board(rover)") }.use { scout ->
            scout.hears("coordinator", "achieve", "watch(north)").shouldSend("goto(north)").perceives("driving(north)").after(3.seconds)
            scout.perceives("at(north)").shouldSay("achieve(coordinator,visited(north))").perceives("driving(north)").after(3.seconds)
            scout.printed shouldBe emptyList()
        }
    }

    test("it goes on when it does not arrive, or its robot is gone for a while") {
        agent(Path("fleet/scout.asl")) { options("beliefs" to "board(rover)") }.use { scout ->
            scout.hears("coordinator", "achieve", "watch(north)").shouldSend("goto(north)").shouldSend("goto(north)", within = 10.seconds)
            scout.shouldPrint("did not reach north")
        }
    }
})
