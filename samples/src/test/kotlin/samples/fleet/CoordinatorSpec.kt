package samples.fleet

import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import kotlin.io.path.Path
import kotlin.time.Duration.Companion.seconds

private val PLACES = listOf("north", "east", "south", "west")

class CoordinatorSpec : FunSpec({
    /** Makes [scout] appear: the fleet announces it, and the scout reports. */
    fun TestAgent.comes(scout: String) =
        hears("fleet", "tell", "agent($scout,$scout)").hears(scout, "achieve", "hear").after(2.seconds)

    fun TestAgent.goes(scout: String) = hears("fleet", "untell", "agent($scout,$scout)").after(2.seconds)

    fun TestAgent.watchedBy(scout: String) = PLACES.filter { "watches($scout,$it)" in beliefs }

    test("the only scout watches all, two share, and when one goes the other one gets its places") {
        agent(Path("fleet/coordinator.asl")).use { coordinator ->
            coordinator.comes("scout1").watchedBy("scout1") shouldContainExactlyInAnyOrder PLACES
            PLACES.forEach { coordinator.shouldSay("achieve(scout1,watch($it))") }

            coordinator.comes("scout2")
            listOf("scout1", "scout2").map { coordinator.watchedBy(it).size } shouldBe listOf(2, 2)

            coordinator.goes("scout1").shouldPrint("scout1 is lost")
            coordinator.watchedBy("scout2") shouldContainExactlyInAnyOrder PLACES
        }
    }

    test("a scout that comes back is told to start from nothing, and one that reports again is not") {
        agent(Path("fleet/coordinator.asl")).use { coordinator ->
            fun standBys() = coordinator.said.count { it == "achieve(scout1,stand_by)" }
            coordinator.comes("scout1").hears("scout1", "achieve", "hear").after(1.seconds)
            standBys() shouldBe 1
            coordinator.goes("scout1").comes("scout1")
            standBys() shouldBe 2
        }
    }

    test("when it goes on on another computer, the scouts do what it believes, whatever they were told meanwhile") {
        agent(Path("fleet/coordinator.asl")).use { coordinator ->
            coordinator.comes("scout1")
            val before = coordinator.said.size
            coordinator.hears("fleet", "tell", "agent(coordinator,scout1)").after(1.seconds)
            val said = coordinator.said.drop(before)
            said.first() shouldBe "achieve(scout1,stand_by)"
            said.drop(1) shouldContainExactlyInAnyOrder PLACES.map { "achieve(scout1,watch($it))" }
        }
    }
})
