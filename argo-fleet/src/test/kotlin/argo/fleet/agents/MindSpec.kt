package argo.fleet.agents

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import jason.architecture.AgArch
import jason.asSemantics.Agent
import jason.asSemantics.TransitionSystem
import jason.runtime.Settings
import jason.util.Config

/** What other computers get to know of an agent that outlives its own. */
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
        val mind = Mind.of(agent) { throw AssertionError("left out: $it") }
        mind.beliefs shouldContainAll
            listOf("place(north)[source(self)]", "~open[source(self)]", "n::x(\"a\\nb\",1.5)[source(bob)]")
        mind.goals shouldContainExactlyInAnyOrder listOf("oversee(3)[source(self)]", "later[source(self)]")
        mind.beliefs.filter { ":-" in it || "#rule" in it } shouldBe emptyList()
    }

    test("a goal that waits for its first plan is kept, too") {
        Mind.of(agent("!oversee. +!oversee.")) {}.goals shouldBe listOf("oversee[source(self)]")
    }

    test("a belief that no text can hold is left out, which is told") {
        val agent = agent("!go. +!go <- .queue.create(Q); +q(Q).").reason(10)
        val told = ArrayList<String>()
        Mind.of(agent, told::add).beliefs shouldBe emptyList()
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

    test("a mind is what it was when it is written and read") {
        val mind = Mind.of(agent("a(1). b(\"!x.\")[source(c),d]. n::e. !g([1,2|[3]]).")) {}
        val other = agent("")
        restore(other, mind.program(), other.logger)
        Mind.of(other) {} shouldBe mind
    }
})

private fun agent(program: String): TransitionSystem {
    Config.get()[Config.START_WEB_MI] = "false" // Jason would start a server
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
