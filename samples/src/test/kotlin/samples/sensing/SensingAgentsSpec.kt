package samples.sensing

import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import samples.collision.HandClock
import samples.collision.Robot
import kotlin.io.path.Path
import kotlin.random.Random
import kotlin.time.Duration.Companion.seconds

/** The agents of the sample on simulated boards, and the boards of the sample. */
class SensingAgentsSpec : FunSpec({
    fun sees(agent: String, vararg percepts: String) = agent(Path("sensing-agents/$agent.asl")) {
        options("beliefs" to "board(ttyACM0), limit(${if (agent == "engineer") 40 else 80})")
        board("ttyACM0").version2().shows(*percepts)
    }

    fun TestAgent.hearsTheOthers() = listOf("lamplighter", "engineer").forEach { hears(it, "tell", "sees($it)") }

    test("the pilot drives when the others see, and stops at its limit") {
        sees("pilot", "dist(f,150)").use { pilot ->
            pilot.shouldNotSend("front", during = 1.seconds)
            pilot.hearsTheOthers()
            pilot.shouldSend("front")
            pilot.perceives("dist(f,81)").shouldNotSend("stop", during = 1.seconds)
            pilot.perceives("dist(f,80)").shouldSend("stop")
        }
    }

    test("the pilot stops when the engineer says that it is too hot, and for nobody else") {
        sees("pilot", "dist(f,150)").use { pilot ->
            pilot.hearsTheOthers()
            pilot.shouldSend("front")
            pilot.hears("stranger", "tell", "too_hot(50)").shouldNotSend("stop", during = 1.seconds)
            pilot.hears("engineer", "tell", "too_hot(50)").shouldSend("stop")
        }
    }

    test("the lamplighter has its lamp burn while it is bright, and tells the pilot once that it sees") {
        sees("lamplighter", "light(f,90)").use { lamplighter ->
            lamplighter.after(1.seconds).perceives("light(f,110)").shouldSend("ledLightOn")
            lamplighter.perceives("light(f,95)").shouldSend("ledLightOff")
            lamplighter.said shouldBe listOf("tell(pilot,sees(lamplighter))")
        }
    }

    test("the engineer tells the pilot the temperature above its limit, once") {
        sees("engineer", "temp(f,25)", "temp(b,40)").use { engineer ->
            engineer.after(1.seconds).perceives("temp(f,41)").after(1.seconds).perceives("temp(f,42)").after(1.seconds)
            engineer.said shouldBe listOf("tell(pilot,sees(engineer))", "tell(pilot,too_hot(41))")
        }
    }

    test("a board shows the sensors of its kind, and has their commands only") {
        val robot = Robot(HandClock(), Random(1))
        val lights = KindBoard("lights", robot, "light", "ledLightOn", "ledLightOff")
        lights.percepts() shouldHaveSize 4
        lights.percepts().forAll { it.substringBefore('(') shouldBe "light" }
        lights.act("front") shouldBe false
        lights.act("ledLightOn") shouldBe true
        robot.lamps shouldBe setOf("light")
    }
})
