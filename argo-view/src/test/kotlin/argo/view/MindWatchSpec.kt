package argo.view

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import jason.asSemantics.Circumstance
import jason.asSemantics.IntendedMeans
import jason.asSemantics.Intention
import jason.asSemantics.Option
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax.parseLiteral
import jason.asSyntax.ASSyntax.parsePlan
import jason.asSyntax.ASSyntax.parseRule
import jason.bb.BeliefBase
import jason.bb.DefaultBeliefBase
import java.util.logging.Logger

private const val MS = 1_000_000L

class MindWatchSpec : FunSpec({
    var now = 0L
    val log = Logger.getLogger("argo.view.test").apply { useParentHandlers = false }
    fun watch(base: BeliefBase) = MindWatch({ MindState.of(base, Circumstance()) }, log) { now }.also { now = 0 }
    fun base(vararg beliefs: String) = DefaultBeliefBase().apply { beliefs.forEach { add(parseLiteral(it)) } }

    test("nobody looks: nothing is read") {
        var reads = 0
        val watch = MindWatch({ reads++; MindState.of(base(), Circumstance()) }, log) { now }
        repeat(100) { watch.look() }
        reads shouldBe 0
    }

    test("beliefs are told with where they come from") {
        val base = base("dist(f,38)[source(percept)]", "status(front)[source(self)]", "go[source(bob),source(self)]")
        base.add(parseLiteral("kqml(1)[hide_in_mind_inspector]"))
        base.add(parseRule("near(X) :- dist(f,X) & X < 40."))
        val watch = watch(base)
        watch.isWatched = true
        watch.look()
        val mind = watch.newest.shouldNotBeNull().mind
        mind.believed shouldBe 4
        mind.beliefs.map { it.text to it.sources.toSet() }.shouldContainExactlyInAnyOrder(
            "dist(f,38)" to setOf("percept"), "status(front)" to setOf("self"), "go" to setOf("bob", "self"),
            "near(X) :- (dist(f,X) & (X < 40))" to emptySet(),
        )
    }

    test("the watch looks ten times in a second, however many cycles there are") {
        var reads = 0
        val watch = MindWatch({ reads++; MindState.of(base(), Circumstance()) }, log) { now }.apply { isWatched = true }
        now = 0
        repeat(1000) { watch.look(); now += MS }
        reads shouldBe 10
    }

    test("the last cycle before a sleep is not missed") {
        val watch = watch(base()).apply { isWatched = true }
        watch.isBehind() shouldBe true
        watch.look()
        watch.isBehind() shouldBe false
        now += MS
        watch.look()
        watch.isBehind() shouldBe false
        now += 100 * MS
        watch.isBehind() shouldBe true
        watch.look()
        watch.isBehind() shouldBe false
    }

    test("of a large belief base a part is told, of percepts and of the others, and how much there is") {
        val watch = watch(DefaultBeliefBase().apply {
            repeat(10_000) { add(parseLiteral("p($it)[source(percept)]")) }
            repeat(10_000) { add(parseLiteral("q($it)[source(self)]")) }
        })
        watch.isWatched = true
        watch.look()
        val mind = watch.newest.shouldNotBeNull().mind
        mind.believed shouldBe 20_000
        mind.beliefs.size shouldBeLessThan 400
    }

    test("all intentions are counted, also of an agent that has very many, and the first of them are told") {
        val circumstance = Circumstance()
        val plan = parsePlan("+!go <- .wait(1).")
        repeat(6_000) {
            val intention = Intention().apply { push(IntendedMeans(Option(plan, Unifier()), plan.trigger)) }
            circumstance.addRunningIntention(intention)
        }
        val mind = MindState.of(base(), circumstance)
        mind.intended shouldBe 6_000
        mind.intentions.size shouldBe 30
    }

    test("a belief base that cannot be read costs the agent nothing") {
        val watch = MindWatch({ throw ConcurrentModificationException() }, log) { now }.apply { isWatched = true }
        watch.look()
        watch.newest shouldBe null
    }
})
