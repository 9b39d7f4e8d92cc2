import argo.filters.matching.matcher
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class RobotFiltersSpec : FunSpec({
    test("the robot sees what is in front of it") {
        frontOnly.matcher().drops("dist(front,30)") shouldBe false
    }

    test("nothing else reaches its beliefs") {
        listOf("dist(left,30)", "light(front,200)").filterNot(frontOnly.matcher()::drops) shouldBe emptyList()
    }
})
