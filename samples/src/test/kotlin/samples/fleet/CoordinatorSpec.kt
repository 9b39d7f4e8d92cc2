package samples.fleet

import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import kotlin.io.path.Path
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

private val PLACES = listOf("north", "east", "south", "west")

class CoordinatorSpec : FunSpec({
    /** Lets [scouts] report for three seconds, as often as real ones do. */
    fun TestAgent.with(vararg scouts: String) = apply {
        repeat(10) {
            scouts.forEach { hears(it, "achieve", "hear") }
            after(300.milliseconds)
        }
    }

    fun TestAgent.watchedBy(scout: String) = PLACES.filter { "watches($scout,$it)" in beliefs }

    test("the only scout watches all, two share, and when one falls silent the other one gets its places") {
        agent(Path("fleet/coordinator.asl")).use { coordinator ->
            coordinator.with("scout1").watchedBy("scout1") shouldContainExactlyInAnyOrder PLACES
            PLACES.forEach { coordinator.shouldSay("achieve(scout1,watch($it))") }

            coordinator.with("scout1", "scout2")
            check(coordinator.watchedBy("scout1").size == 2 && coordinator.watchedBy("scout2").size == 2) { "${coordinator.beliefs}" }

            coordinator.with("scout2").shouldPrint("scout1 is lost")
            coordinator.watchedBy("scout2") shouldContainExactlyInAnyOrder PLACES
        }
    }

    test("a scout that comes back after it was taken for lost is told to start from nothing") {
        agent(Path("fleet/coordinator.asl")).use { coordinator ->
            coordinator.with("scout1").after(3.seconds).shouldPrint("scout1 is lost")
            val before = coordinator.said.count { it == "achieve(scout1,stand_by)" }
            coordinator.with("scout1")
            check(coordinator.said.count { it == "achieve(scout1,stand_by)" } == before + 1)
        }
    }
})
