package argo.perception

import argo.filters.perceptionFilter
import argo.platform.RateLimitedWarning
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import java.util.logging.Logger

class BoardPerceptsSpec : FunSpec({
    var nowMs = 0L
    fun percepts() = BoardPercepts(BeliefReader { error(it) }, Logger.getLogger("test"), PerceptLimit(1000, RateLimitedWarning({ nowMs }) { error(it) }), LastSeen { emptyList() }, { nowMs })
    fun BoardPercepts.sees(message: String) = snapshot(null, message, nowMs).percepts.map { "$it" }
    val calm = perceptionFilter("calm") { drop("temp") { everyMs(300) } }

    beforeTest { nowMs = 0 }

    test("what a rate holds back comes due when its time is over") {
        val board = percepts().apply { switchTo(calm) }
        board.sees("temp(1);") shouldBe listOf("temp(1)")
        board.dueInMs() shouldBe null
        board.sees("temp(2);") shouldBe listOf("temp(1)")
        board.dueInMs() shouldBe 300
        nowMs = 300
        board.due().shouldNotBeNull().percepts.map { "$it" } shouldBe listOf("temp(2)")
        board.dueInMs() shouldBe null
    }

    test("what was held back when the agent turned away from its sensors never comes due") {
        val board = percepts().apply { switchTo(calm) }
        board.sees("temp(1);")
        board.sees("temp(2);")
        board.forgetHeldBack()
        nowMs = 60_000
        board.dueInMs() shouldBe null
        board.due() shouldBe null
        board.sees("temp(3);") shouldBe listOf("temp(3)")
    }

    test("a snapshot that was made before the filter changed is made anew") {
        val board = percepts()
        val before = board.snapshot(null, "temp(1);dist(f,2);", 0)
        board.switchTo(perceptionFilter("noTemp") { drop("temp") })
        board.current(before).percepts.map { "$it" } shouldBe listOf("dist(f,2)")
    }
})
