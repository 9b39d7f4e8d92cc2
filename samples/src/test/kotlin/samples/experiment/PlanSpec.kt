package samples.experiment

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe

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
        View.FRONT_DISTANCE.filter(Condition.VERSION_2) shouldBe "keepFrontDistance"
        View.FRONT_DISTANCE.filter(Condition.DEFAULTS) shouldBe "frontDistance"
        View.NONE.filter(Condition.VERSION_2) shouldBe "none"
    }

    test("a request and twelve percepts take 168 ms at 9600 baud, and an answer may take a second") {
        (frameNanos(trials.first()) / 1_000_000).toInt() shouldBe 168
        answerLimitMs(trials.first()) shouldBe 1000
        answerLimitMs(trials.first().copy(sensors = 768)) shouldBeGreaterThan 20_000
    }
})
