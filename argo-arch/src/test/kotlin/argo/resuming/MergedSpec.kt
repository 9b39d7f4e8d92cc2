package argo.resuming

import argo.mind.Mind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

/** An agent whose program has changed since its state was kept goes on from what still fits. */
class MergedSpec : FunSpec({
    fun merged(kept: Mind, then: Mind, now: Mind) = Merged(State("robot", 0, emptyList(), then, kept), now)

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
