package experiment

import argo.filters.PerceptionFilter.Mode
import argo.filters.format.FilterFinder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import io.kotest.matchers.string.shouldContain
import javino.LineSettings

class PlanSpec : FunSpec({
    val trials = Plan.FULL.trials(Condition.PUBLISHED)

    test("the published design has 27 combinations of three replications") {
        trials shouldHaveSize 81
        trials.groupBy { Triple(it.view, it.limit, it.interval) }.values.map { it.size }.toSet() shouldBe setOf(3)
        trials.map { it.limit }.toSet() shouldBe setOf(40, 80, 120)
        trials.map { it.interval }.toSet() shouldBe setOf(20, 35, 50)
        trials.any { it.isScaled } shouldBe false
    }

    test("no two runs share a name") {
        val all = Condition.entries.flatMap { Plan.FULL.trials(it) + Plan.FULL.scaling(it) }
        all.map { it.id }.toSet() shouldHaveSize all.size
        all.map { noiseSeed(it, 1) }.toSet().size shouldBeGreaterThan all.size - 3
    }

    test("the order is random, and the same for the same seed") {
        randomised(trials, 5) shouldBe randomised(trials, 5)
        randomised(trials, 5) shouldNotBe randomised(trials, 6)
        randomised(trials, 5) shouldNotBe trials
        randomised(trials, 5) shouldContainExactlyInAnyOrder trials
    }

    test("beyond the paper are all sizes on all lines but the published one") {
        val scaled = Plan.FULL.scaling(Condition.DEFAULTS)
        scaled.map { it.sensors }.toSet() shouldBe setOf(12, 48, 192, 768)
        scaled.maxOf { it.baud } shouldBe 1_000_000
        scaled.all { it.isScaled } shouldBe true
    }

    test("with version 2 filters say what they keep") {
        View.FRONT_DISTANCE.filter(Condition.VERSION_2, 80) shouldBe "keepFrontDistance"
        View.FRONT_DISTANCE.filter(Condition.DEFAULTS, 80) shouldBe "frontDistance"
        View.NONE.filter(Condition.VERSION_2, 80) shouldBe "none"
    }

    test("with a reflex on the board each filter has the critical rule at the limit, and agents find it") {
        val finder = FilterFinder(emptyList(), PlanSpec::class.java.classLoader)
        ReflexFilters.offer()
        for (view in View.entries) for (limit in Plan.entries.flatMap { it.limits }) {
            val filter = finder.find(view.filter(Condition.REFLEX, limit))
            filter.name shouldContain "$limit"
            filter.critical.single().toString() shouldBe "dist where argument 0 is f and argument 1 is at most $limit, with the reflex stop"
            filter.mode shouldBe if (view == View.NONE) Mode.DROP else Mode.KEEP
            filter.rules.map { "${it.predicate}" } shouldBe view.functors.orEmpty()
        }
    }

    test("a request and twelve percepts take 168 ms at 9600 baud, and an answer may take a second") {
        (exchangeNanos(trials.first()) / 1_000_000).toInt() shouldBe 168
        answerLimitMs(trials.first()) shouldBe 1000
        answerLimitMs(trials.first().copy(sensors = 768)) shouldBeGreaterThan 20_000
    }

    test("a board of version 2 that is asked for distances alone takes a part of the line's time") {
        val all = Trial(Condition.VERSION_2, View.NONE, 80, 20, 1)
        val part = all.copy(view = View.FRONT_DISTANCE)
        // a request with (dist), and an item with the digits of dist(f,200), dist(b,200), dist(r,80) and dist(l,80)
        exchangeNanos(part) shouldBe (7 + 6 + 7 + 2 + 7) * LineSettings(9_600).byteNanos()
        // the agent requests all percepts until the filter is known
        answerLimitMs(part.copy(sensors = 768)) shouldBe answerLimitMs(all.copy(sensors = 768))
    }

    test("the physical time to stop is two exchanges, the sensor's noise and the command") {
        val trial = trials.first() // 12 sensors at 9600 baud
        leastStopNanos(trial) shouldBe 100_000_000 + 2 * exchangeNanos(trial) + 10 * LineSettings(9_600).byteNanos()
        Condition.entries.flatMap { Plan.FULL.trials(it) }.all(::leavesTime) shouldBe true
    }

    test("a board that stops the robot needs another look at its sensors, after a part of an answer at most") {
        val trial = Trial(Condition.REFLEX, View.NONE, 80, 20, 1)
        leastStopNanos(trial) shouldBe 100_000_000 + 20 * LineSettings(9_600).byteNanos()
        leastStopNanos(trial.copy(baud = 1_000_000)) shouldBe 105_000_000
    }

    test("on a fast line it is the interval that bounds it, and with many sensors the line leaves none") {
        val fast = trials.first().copy(interval = 50, baud = 1_000_000)
        leastStopNanos(fast) shouldBe 100_000_000 + 50_000_000 + exchangeNanos(fast) + 10 * LineSettings(1_000_000).byteNanos()
        leavesTime(trials.first().copy(sensors = 768)) shouldBe false
        leavesTime(trials.first().copy(sensors = 768, baud = 115_200)) shouldBe true
    }
})
