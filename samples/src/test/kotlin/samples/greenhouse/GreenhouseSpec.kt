package samples.greenhouse

import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.comparables.shouldBeGreaterThanOrEqualTo
import io.kotest.matchers.doubles.shouldBeLessThan
import kotlin.io.path.Path
import kotlin.random.Random
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

class GreenhouseSpec : FunSpec({
    fun gardener() = agent(Path("greenhouse/gardener.asl")) {
        options("beliefs" to "board(ttyACM0), minute(${MINUTE.inWholeMilliseconds})")
        board("ttyACM0").version2().knows("set/2").shows("temp(20)", "soil(40)", "light(500)", "state(pump,off)", "state(vent,closed)")
    }

    fun TestAgent.senses(vararg percepts: String) = perceives(*percepts, within = MINUTE * 3)

    test("it waters while the soil is dry, and neither more nor less between the two edges") {
        gardener().use { gardener ->
            gardener.senses("soil(29)", "light(500)", "state(pump,off)").shouldSend("set(pump,on)", within = MINUTE * 3)
            gardener.senses("soil(44)", "light(500)", "state(pump,on)").shouldNotSend("set(pump,off)", during = MINUTE * 20)
            gardener.senses("soil(46)", "light(500)", "state(pump,on)").shouldSend("set(pump,off)", within = MINUTE * 3)
            gardener.senses("soil(31)", "light(500)", "state(pump,off)").shouldNotSend("set(pump,on)", during = MINUTE * 20)
        }
    }

    test("a device that was switched rests, and is looked at again when the rest is over") {
        gardener().use { gardener ->
            gardener.senses("soil(29)", "light(500)", "state(pump,off)").shouldSend("set(pump,on)", within = MINUTE * 3)
            gardener.senses("soil(60)", "light(500)", "state(pump,on)").shouldNotSend("set(pump,off)", during = MINUTE * 2)
            gardener.shouldSend("set(pump,off)", within = MINUTE * 3)
        }
    }

    test("it does not water at night") {
        gardener().use { gardener ->
            gardener.senses("soil(10)", "light(5)", "state(pump,off)").shouldNotSend("set(pump,on)", during = MINUTE * 60)
            gardener.senses("soil(10)", "light(500)", "state(pump,off)").shouldSend("set(pump,on)", within = MINUTE * 3)
        }
    }

    test("the operator's order counts until it is taken back, and nobody else's does") {
        gardener().use { gardener ->
            gardener.hears("stranger", "achieve", "order(vent,open)").shouldPrint("stranger may not order vent open")
            gardener.hears("operator", "achieve", "order(vent,open)").shouldSend("set(vent,open)", within = MINUTE * 3)
            gardener.senses("temp(10)", "state(vent,open)").shouldNotSend("set(vent,closed)", during = MINUTE * 60)
            gardener.hears("operator", "achieve", "order(vent,automatic)").shouldSend("set(vent,closed)", within = MINUTE * 3)
        }
    }

    test("when it sees nothing any more it switches the pump off") {
        gardener().use { gardener ->
            gardener.senses("soil(29)", "light(500)", "state(pump,on)")
            gardener.board.ignoresRequests()
            gardener.shouldSend("set(pump,off)", within = MINUTE * 4)
        }
    }

    test("a day: no device is switched before it has rested, none at night, and it never gets hot or dry").config(tags = thorough) {
        gardener().use { gardener ->
            val day = Day(gardener)
            day.passes()
            day.switches("pump").shouldNotBeEmpty()
            day.switches("vent").shouldNotBeEmpty()
            day.rests("pump").min() shouldBeGreaterThanOrEqualTo MINUTE * 5
            day.rests("vent").min() shouldBeGreaterThanOrEqualTo MINUTE * 15
            day.switches("pump").filter { it.command == "set(pump,on)" && it.at > MINUTE * 60 * 14 }.shouldBeEmpty()
            day.hottest shouldBeLessThan 31.0
            day.driest shouldBeGreaterThanOrEqualTo 27.0
        }
    }
})

/** The length of a minute for the gardener. A longer minute would give more work to lines and timers. */
private val MINUTE = 6.seconds

private val thorough = setOf(NamedTag("Thorough"))

private class Day(private val gardener: TestAgent) {
    private var now = Duration.ZERO
    private var heard = 0
    private val house = Greenhouse(Random(1)) { now / MINUTE }

    var hottest = 0.0
        private set
    var driest = 100.0
        private set

    fun passes() {
        gardener.board.shows { at ->
            gardener.board.arrivals.drop(heard).forEach { house.act(it.command) }
            heard = gardener.board.arrivals.size
            now = at
            house.percepts().also {
                hottest = maxOf(hottest, house.celsius)
                driest = minOf(driest, house.soil)
            }
        }
        gardener.after(MINUTE * 60 * 24)
    }

    fun switches(device: String) = gardener.arrivals.filter { it.command.startsWith("set($device,") }

    fun rests(device: String) = switches(device).zipWithNext { one, next -> next.at - one.at }
}
