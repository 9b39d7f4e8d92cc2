package argo.resuming

import argo.mind.Mind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class MergedStateSpec : FunSpec({
    fun merged(kept: Mind, then: Mind, now: Mind) = MergedState(State("robot", 0, emptyList(), then, kept), now)

    test("the same program has the agent believe and want what it did, and nothing else") {
        val program = Mind(listOf("limit(40)", "count(0)"), listOf("!start"))
        merged(Mind(listOf("count(7)", "limit(40)"), listOf("!patrol")), program, program).run {
            beliefs shouldBe listOf("count(7)", "limit(40)")
            newBeliefs shouldBe emptyList()
            events shouldBe listOf("!patrol")
            told shouldBe ""
        }
    }

    test("a belief that the program states otherwise now is believed so; a goal that it begins with only now is begun") {
        merged(
            kept = Mind(listOf("count(7)", "limit(40)"), listOf("!patrol")),
            then = Mind(listOf("limit(40)", "count(0)"), listOf("!start")),
            now = Mind(listOf("limit(30)", "count(0)"), listOf("!start", "!watch")),
        ).run {
            beliefs shouldBe listOf("count(7)")
            newBeliefs shouldBe listOf("limit(30)")
            events shouldBe listOf("!patrol", "!watch")
            told shouldBe "; by the changed program not believed any more: limit(40); by the changed program believed in addition: " +
                "limit(30); by the changed program begun in addition: !watch"
        }
    }

    test("a belief that the agent has changed, and the program states otherwise now, is as the program states it, which is told") {
        merged(
            kept = Mind(listOf("value(60)[source(self)]"), emptyList()),
            then = Mind(listOf("value(40)[source(self)]"), emptyList()),
            now = Mind(listOf("value(55)[source(self)]"), emptyList()),
        ).run {
            beliefs shouldBe emptyList()
            newBeliefs shouldBe listOf("value(55)[source(self)]")
            told shouldBe "; by the changed program not believed any more: value(60)[source(self)]; by the changed program believed in " +
                "addition: value(55)[source(self)]"
        }
    }

    test("a belief of another source, and several beliefs of a predicate, stay beside what the program states now") {
        fun stays(kept: List<String>) =
            merged(Mind(kept, emptyList()), Mind(listOf("v(1)"), emptyList()), Mind(listOf("v(2)"), emptyList()))
                .run { beliefs + newBeliefs } shouldBe kept + "v(2)"
        stays(listOf("v(3)[source(boss)]"))
        stays(listOf("v(3)", "v(4)"))
        stays(listOf("~v(3)"))
    }

    test("what the agent has come to itself is not doubled") {
        merged(
            kept = Mind(listOf("limit(30)"), listOf("!watch")),
            then = Mind(emptyList(), emptyList()),
            now = Mind(listOf("limit(30)"), listOf("!watch")),
        ).run {
            beliefs shouldBe listOf("limit(30)")
            newBeliefs shouldBe emptyList()
            events shouldBe listOf("!watch")
        }
    }
})
