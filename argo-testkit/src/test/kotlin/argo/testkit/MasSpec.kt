package argo.testkit

import argo.Arch
import argo.platform.Platform
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.ASSyntax
import jason.asSyntax.Structure
import jason.environment.Environment
import jason.runtime.RuntimeServicesFactory
import kotlin.time.Duration.Companion.hours
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class ProjectsArch(platform: Platform) : Arch(platform)

/** An environment with a path of two steps. */
private class Path : Environment() {
    var stopped = 0

    override fun executeAction(agent: String, action: Structure): Boolean {
        if (action.functor != "step" || containsPercept(agent, at(2))) return false
        val place = if (containsPercept(agent, at(1))) 2 else 1
        clearPercepts(agent)
        addPercept(agent, at(place))
        return true
    }

    private fun at(place: Int) = ASSyntax.parseLiteral("at($place)")

    override fun stop() {
        stopped++
        super.stop()
    }
}

class MasSpec : FunSpec({
    test("agents speak with each other, ask and answer, and are spoken to all at once, whichever is made first") {
        mas {
            agentOf(
                "asker",
                "!start.\n+!start <- .broadcast(tell, here); .send(knower, askOne, speed(X), A); .print(A); .send(nobody, tell, lost).",
            )
            agentOf("knower", "speed(3).\n+here[source(S)] <- .send(S, tell, seen).")
            agentOf("other", "+here[source(S)] <- .send(S, tell, seen).")
        }.use { agents ->
            agents["asker"].shouldPrint("speed(3)").shouldBelieve("seen[source(knower)] & seen[source(other)]")
            agents["asker"].said shouldBe listOf("tell(everybody,here)", "askOne(knower,speed(X))", "tell(nobody,lost)")
            agents["other"].said shouldBe listOf("tell(asker,seen)")
            agents["other"].printed.shouldBeEmpty()
            agents.names shouldBe listOf("asker", "knower", "other")
        }
    }

    test("each has its own ports, and all have one time") {
        mas {
            for (n in 1..3) agentOf("scout$n", "!go.\n+!go <- argo.port(ttyACM0); .wait(${n}000); argo.act(go($n)).")
        }.use { scouts ->
            scouts.after(1500.milliseconds)["scout1"].shouldSend("go(1)").shouldSendNothingElse(100.milliseconds)
            scouts["scout2"].shouldSend("go(2)")
            scouts["scout3"].shouldSend("go(3)", within = 2.seconds).sent shouldBe listOf("go(3)")
            scouts["scout1"].now shouldBe scouts["scout3"].now
        }
    }

    test("an agent that is stopped does nothing any more, and the others go on") {
        mas {
            agentOf("boss", "!check.\n+!check <- .send(scout, askOne, alive, A, 500); .print(A); .wait(1000); !check.")
            agentOf("scout", "alive.\n!blink.\n+!blink <- argo.port(ttyACM0); argo.act(blink); .wait(100); !blink.")
        }.use { agents ->
            agents["boss"].shouldPrint("alive")
            agents["scout"].shouldSend("blink").stops().shouldStop()
            agents["boss"].shouldPrint("timeout", within = 2.seconds)
            agents["scout"].apply { val before = sent; after(3.seconds).sent shouldBe before }
            agents.names shouldBe listOf("boss")
        }
    }

    test(".create_agent makes an agent of the test, .kill_agent and .stopMAS stop what they should, in the test's time") {
        agentOf("""
            !start.
            +!start <- .create_agent(bob, "robot.asl"); .create_agent(Bob, "robot.asl"); .print(Bob); .wait(2000);
                       .kill_agent(bob); .wait(1000); .all_names(L); .print(L); .stopMAS(2000).
            +jag_shutting_down(Ms) <- .print(ends_in(Ms)).
            -!start[error_msg(M)] <- .print(M).
        """).use { boss ->
            val bob = boss.shouldPrint("bob_1").mas["bob"].perceives("dist(front,30)").shouldSend("stop")
            boss.mas["bob_1"].perceives("dist(front,90)").shouldSend("front")
            bob.shouldStop(within = 3.seconds)
            boss.shouldPrint("[agent,bob_1]", within = 2.seconds).shouldPrint("ends_in(2000)").shouldStop(within = 3.seconds)
            boss.mas.names.shouldBeEmpty()
        }
    }

    test("an agent can be made anew under the name of one that was stopped") {
        agentOf("""
            !start.
            +!start <- .create_agent(bob, "robot.asl"); .wait(1500); .kill_agent(bob); .wait(100);
                       .create_agent(bob, "robot.asl"); .print(again).
        """).use { boss ->
            val first = boss.mas["bob"].perceives("dist(front,30)").shouldSend("stop").shouldStop(within = 2.seconds)
            val second = boss.shouldPrint("again").mas["bob"]
            second.perceives("dist(front,90)").shouldSend("front").shouldSendNothingElse()
            first.sent shouldBe listOf("stop")
        }
    }

    test("an agent that is created has the architecture that was asked for, or that of its creator") {
        agentOf("""
            !start.
            +!start <- .create_agent(a); .create_agent(b, "robot.asl", [agentArchClass("argo.Arch")]);
                       .create_agent(c, "robot.asl", [agentArchClass("argo.testkit.ProjectsArch"), agentClass("jason.asSemantics.Agent")]);
                       .print(all).
        """) { arch = ::ProjectsArch }.use { agent ->
            agent.shouldPrint("all")
            agent.mas.names.associateWith { name ->
                generateSequence(agent.mas[name].ts.agArch) { it.nextAgArch }.filterIsInstance<Arch>().single().javaClass.simpleName
            } shouldBe
                mapOf("agent" to "ProjectsArch", "a" to "ProjectsArch", "b" to "Arch", "c" to "ProjectsArch")
        }
    }

    test("what cannot be created fails the plan with the reason") {
        val reasons = mapOf(
            """bob, "nobody.asl"""" to "there is no agent nobody.asl",
            """bob, "robot.asl", [agentArchClass("jason.architecture.AgArch")]""" to "passes it on",
            """bob, "robot.asl", [agentClass("no.Such")]""" to "no class no.Such",
            """self, "robot.asl"""" to "cannot be called self",
        )
        for ((arguments, reason) in reasons) {
            agentOf("!start.\n+!start <- .create_agent($arguments).\n-!start[error_msg(M)] <- .print(M).").use { it.shouldPrint(reason) }
        }
    }

    test("a service that only a real run has is said to be missing") {
        agentOf("!start.\n+!start <- .df_register(x).\n-!start <- .print(failed).").use { agent ->
            agent.shouldPrint("failed")
            agent.log.single { "SEVERE" in it } shouldContain "agents under test have no dfRegister"
        }
    }

    test("agents act in a Jason environment and perceive it, each on its own") {
        val path = Path()
        mas {
            agentOf("ann", "!start.\n+!start <- step; .wait(at(1)); step; step.\n-!start <- .print(end).") { environment = path }
            agentOf("bob", "+at(N) <- .print(at(N)).") { environment = path }
            agentOf("cat", "!start.\n+!start <- step.\n-!start[error_msg(M)] <- .print(M).")
        }.use { agents ->
            agents["ann"].shouldPrint("end").shouldBelieve("at(2)")
            path.addPercept("bob", ASSyntax.parseLiteral("at(7)"))
            path.informAgsEnvironmentChanged("bob")
            agents["bob"].shouldPrint("at(7)", within = 1.milliseconds).shouldNotBelieve("at(2)")
            agents["cat"].shouldPrint("this agent under test has no environment")
            agents["ann"].stops()
            path.stopped shouldBe 0
            agents["bob"].stops().stops()
            path.stopped shouldBe 1
        }
        path.stopped shouldBe 1
    }

    test(".wait and .at go by the test's time, also for hours, and so does the limit of a question") {
        agentOf("""
            !start.
            +!start <- .at("now +3 hours", {+!ring}); .wait({+never}, 60000, _); .print(waited);
                       .send(nobody, askOne, x, A, 1000); .print(A).
            +!ring <- .print(ring).
        """).use { agent ->
            agent.after(59.seconds).printed.shouldBeEmpty()
            agent.after(1.seconds).printed shouldBe listOf("waited")
            agent.after(1.seconds).printed shouldBe listOf("waited", "timeout")
            agent.after(3.hours - 62.seconds).printed.size shouldBe 2
            agent.shouldPrint("ring", within = 1.seconds)
        }
    }

    test("no real multi-agent system runs because agents are under test, so that one may begin") {
        agentOf("!start.\n+!start <- .print(here).").use { it.shouldPrint("here") }
        RuntimeServicesFactory.get().isRunning shouldBe false
    }

    test("two agents of one name are refused, and so is one that nobody made") {
        shouldThrow<IllegalArgumentException> { mas { agent("robot.asl"); agent("robot.asl") } }.message shouldContain "name = "
        mas { agent("robot.asl"); agent("robot.asl") { name = "other" } }.use { agents ->
            shouldThrow<IllegalArgumentException> { agents["third"] }.message shouldContain "there are robot, other"
        }
    }
})
