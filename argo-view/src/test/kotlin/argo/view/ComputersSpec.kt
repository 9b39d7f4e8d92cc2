package argo.view

import argo.observing.AgentThere
import argo.observing.ObservedAgent
import argo.observing.ObservedComputer
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.util.logging.Logger

class ComputersSpec : FunSpec({
    test("a change of the computers is news, and of agents that are too many to be shown the number is told") {
        val sixty = List(60) { AgentThere("a$it", 8080) }
        var now = listOf(ObservedComputer("base", "10.8.0.1", isHere = true, isNear = true, isOn = true, sixty))
        val log = Logger.getLogger("argo.view.test.computers")
        val agent = object : ObservedAgent by Nobody {
            override val computers get() = now
        }
        val composer = StateComposer(agent, AgentRecord(agent, log), PageBreakpoints(agent), { emptyList<AgentTab>() to 0 }, log)
        composer.state(isLast = false).computers.single().run { listOf(name, here, on, agents.size, more) } shouldBe
            listOf("base", true, true, 50, 10)
        composer.hasNews() shouldBe false
        now = now + ObservedComputer("scout1", "10.8.0.2", isHere = false, isNear = false, isOn = false, emptyList())
        composer.hasNews() shouldBe true
        composer.state(isLast = false).computers.map { it.name } shouldBe listOf("base", "scout1")
    }
})
