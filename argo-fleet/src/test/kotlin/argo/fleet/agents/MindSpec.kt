package argo.fleet.agents

import argo.mind.Mind
import argo.recording.agent.MessageContent
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import jason.architecture.AgArch
import jason.asSemantics.Agent
import jason.asSemantics.TransitionSystem
import jason.asSyntax.ASSyntax
import jason.runtime.Settings
import jason.util.Config

/** Checks the mind that other computers receive from an agent that outlives its computer. */
class MindSpec : FunSpec({
    test("beliefs with namespaces, annotations, strings and numbers, and the goals that intentions began with") {
        val agent = agent(
            """
            place(north). n::x("a\nb",1.5)[source(bob)]. ~open. near(X) :- place(X).
            !oversee(3). !later.
            +!oversee(N) <- !step(N).
            +!step(N) <- .wait(100000).
            +!later <- .wait({+go}).
            +place(south) <- .wait(100000).
            """,
        ).reason(20)
        val mind = mindOf(agent) { throw AssertionError("left out: $it") }
        mind.beliefs shouldContainAll
            listOf("place(north)[source(self)]", "~open[source(self)]", "n::x(\"a\\nb\",1.5)[source(bob)]")
        mind.events shouldContainExactlyInAnyOrder listOf("!oversee(3)[source(self)]", "!later[source(self)]")
        mind.beliefs.filter { ":-" in it || "#rule" in it } shouldBe emptyList()
    }

    test("a goal that waits for its first plan is kept, too") {
        mindOf(agent("!oversee. +!oversee.")).events shouldBe listOf("!oversee[source(self)]")
    }

    test("an intention begins anew with the belief that began it, but not with a percept, which comes anew itself") {
        val program = """
            order(tea). +order(X) <- .wait(100000); !fetch(X). +dist(X) <- !avoid. +!avoid <- .wait(100000).
            +told(X) <- +done(X).
        """
        val agent = agent(program).apply { ag.addBel(ASSyntax.parseLiteral("dist(3)[source(percept)]")) }.reason(20)
        val mind = mindOf(agent)
        mind.events shouldBe listOf("+order(tea)[source(self)]")
        val other = agent(program)
        restore(other, Mind(mind.beliefs, mind.events + "+told(x)[source(bob)]").program(), other.logger)
        other.reason(20).ag.bb.map { "$it" } shouldContainAll listOf("order(tea)[source(self)]", "done(x)[source(self)]")
        mindOf(other).events shouldBe mind.events
    }

    test("a belief that no text can hold is left out, which is told") {
        val agent = agent("!go. +!go <- .queue.create(Q); +q(Q).").reason(10)
        val told = ArrayList<String>()
        mindOf(agent) { told += it }.beliefs shouldBe emptyList()
        told.size shouldBe 1
    }

    test("an agent goes on with another's mind, and with nothing that its program begins with") {
        val agent = agent("first. last(1). near(X) :- kept(X). !begin. +!begin <- +begun. +!go(X) : near(Y) <- +went(X,Y).")
        restore(agent, "kept(\"x. y\")[source(bob)].\n!go(7).", agent.logger)
        agent.reason(20)
        val believed = agent.ag.bb.map { "$it" }
        believed shouldContainAll listOf("kept(\"x. y\")[source(bob)]", "went(7,\"x. y\")[source(self)]")
        believed.filter { it.startsWith("first") || it.startsWith("last") || it.startsWith("begun") } shouldBe emptyList()
    }

    test("a percept that another agent tells, too, is a belief without that source; beliefs of a functor keep their order") {
        val agent = agent("on(1)[source(percept)]. on(2)[source(percept),source(bob)]. a(1). a(2). a(3).")
        val mind = mindOf(agent)
        mind.beliefs shouldContainAll listOf("on(2)[source(bob)]")
        mind.beliefs.filter { it.startsWith("on(1") } shouldBe emptyList()
        val other = agent("")
        restore(other, mind.program(), other.logger)
        fun order(ts: TransitionSystem) = ts.ag.bb.filter { it.functor == "a" }.map { "${it.getTerm(0)}" }
        order(other) shouldBe order(agent)
    }

    test("an agent whose mind cannot be read is unchanged") {
        val agent = agent("first. !begin. +!begin <- +begun.")
        shouldThrow<IllegalArgumentException> { restore(agent, "kept(1).\nnot a belief.", agent.logger) }
        agent.reason(20).ag.bb.map { "$it" } shouldContainAll listOf("first[source(self)]", "begun[source(self)]")
    }

    test("a mind is what it was when it is written and read") {
        val mind = mindOf(agent("a(1). b(\"!x.\")[source(c),d]. n::e. !g([1,2|[3]])."))
        val other = agent("")
        restore(other, mind.program(), other.logger)
        mindOf(other) shouldBe mind
    }
})

private fun mindOf(ts: TransitionSystem, leftOut: (String) -> Unit = {}) = Mind.of(ts, MessageContent::write, leftOut)

private fun agent(program: String): TransitionSystem {
    Config.get()[Config.START_WEB_MI] = "false" // starts no web server
    val arch = object : AgArch() {
        override fun getAgName() = "a"
    }
    return Agent.create(arch, Agent::class.java.name, null, null, Settings()).run {
        parseAS(program.reader(), "a.asl")
        addInitialBelsInBB()
        addInitialGoalsInTS()
        ts
    }
}

private fun TransitionSystem.reason(cycles: Int): TransitionSystem = apply { repeat(cycles) { reasoningCycle() } }
