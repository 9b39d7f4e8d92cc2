package argo.testkit

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.util.logging.ConsoleHandler
import java.util.logging.Level
import java.util.logging.LogRecord
import java.util.logging.Logger
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class PerceptsSpec : FunSpec({
    fun watcher(start: String, vararg plans: String, setUp: AgentSetUp.() -> Unit = {}) =
        agentOf("!start.\n+!start <- argo.port(ttyACM0, [baud(115200)]); $start; argo.percepts(open).\n${plans.joinToString("\n")}", setUp)

    test("a percept that is shown all the time stays young, and one of a board that hangs grows old to the millisecond") {
        watcher("argo.limit(100)", "+!ask : argo.age(dist(f,X),A) & A < 400 <- .print(young(X)).", "+!ask <- .print(old).").use { agent ->
            agent.hears("user", "achieve", "ask").shouldPrint("old").perceives("dist(f,3)")
            agent.after(5.seconds).shouldBelieve("argo.age(dist(f,_),A) & A < 120").hears("user", "achieve", "ask").shouldPrint("young(3)")
            agent.board.hangs()
            agent.shouldNotBelieve("argo.age(dist(f,_),A) & A > 400", during = 250.milliseconds)
            agent.shouldBelieve("argo.age(dist(f,_),A) & A > 400").hears("user", "achieve", "ask").printed shouldBe
                listOf("old", "young(3)", "old")
        }
    }

    test("a port is stale when its board has been silent for two time limits and an interval, and no longer when it speaks") {
        watcher("argo.limit(200)", "+stale(P) <- .print(blind(P)).").use { agent ->
            agent.perceives("dist(f,3)").board.hangs()
            agent.shouldNotBelieve("stale(ttyACM0)", during = 900.milliseconds)
            agent.shouldBelieve("stale(ttyACM0)", within = 400.milliseconds).shouldPrint("blind(ttyACM0)")
            agent.board.recovers()
            agent.after(600.milliseconds).shouldNotBelieve("stale(_)").shouldBelieve("dist(f,3)")
        }
    }

    test("a critical percept's reflex goes out once, before commands that wait, and before the plan that it causes") {
        watcher(
            "argo.limit(20); argo.change_filter(careful)",
            "+dist(front,X) : X < 15 <- argo.act(saw(X)).",
            "+!walk(N) <- argo.act(walk(N)); !walk(N+1).",
        ).use { agent ->
            agent.perceives("dist(front,90)")
            repeat(8) { agent.hears("user", "achieve", "walk(${it}00)") }
            agent.perceives("dist(front,9)").shouldSend("stop").shouldSend("saw(9)")
            check(agent.sent.indexOf("stop") < agent.sent.indexOf("saw(9)")) { "${agent.sent}" }
            agent.shouldNotSend("stop").perceives("dist(front,90)").perceives("dist(front,7)").shouldSend("stop").shouldNotSend("stop")
        }
    }

    test("a reflex comes while the agent is in the middle of something") {
        watcher("argo.limit(20); argo.change_filter(careful)", "@a[atomic] +!work <- .wait(2000); argo.act(worked).").use { agent ->
            agent.perceives("dist(front,90)").hears("user", "achieve", "work").after(1.seconds)
            agent.board.shows("dist(front,9)")
            agent.shouldSend("stop", within = 100.milliseconds).shouldSend("worked")
        }
    }

    test("a board that says nonsense costs what cannot be read, and nothing else") {
        watcher("argo.limit(50)").use { agent ->
            agent.perceivesRaw("dist(front;light(3);)(;X;3;").shouldBelieve("light(3)").beliefs shouldBe
                listOf("light(3)", "port(ttyACM0,on)")
            agent.log.count { "is left out" in it } shouldBe 4
            repeat(20) {
                agent.board.disturbs("\u0000\u00fffffe".repeat(it))
                agent.after(130.milliseconds)
            }
            agent.perceives("light(4)").shouldBelieve("light(4)").beliefs shouldContain "port(ttyACM0,on)"
            shouldThrow<IllegalArgumentException> { agent.board.disturbs("\u2603") }.message shouldContain "one byte"
        }
    }

    test("an expectation that fails says what the board shows, and which rule of the filter dropped it") {
        watcher("argo.change_filter(front)").use { agent ->
            agent.perceives("dist(front,30)", "temp(21)")
            val message = shouldThrow<AssertionError> { agent.shouldBelieve("temp(_)") }.message.orEmpty()
            message shouldContain "boards: \n    ttyACM0 (on) shows dist(front,30), temp(21)"
            message shouldContain "temp(21) is dropped by filter front: it matches rule 1"
            message shouldContain "dist(front,30) is kept by filter front"
        }
    }

    test("it finds the state and the filter of a port whose name is a string") {
        val program = "!start.\n+!start <- argo.port(\"/dev/ttyUNO\"); argo.change_filter(front); argo.percepts(open)."
        agentOf(program).use { agent ->
            agent.perceives("temp(21)")
            val message = shouldThrow<AssertionError> { agent.shouldBelieve("temp(_)") }.message.orEmpty()
            message shouldContain "/dev/ttyUNO (on) shows temp(21)"
            message shouldContain "temp(21) is dropped by filter front: it matches rule 1"
        }
    }

    test("it says that perceiving is blocked, that a board is not in use, and that percepts cannot be read") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0).").use { agent ->
            agent.board.showsRaw("dist(front;light(3);")
            agent.board("ttyACM1").shows("dist(front,30)")
            val message = shouldThrow<AssertionError> { agent.shouldBelieve("dist(_,_)") }.message.orEmpty()
            message shouldContain "perceiving is blocked: the agent starts it with argo.percepts(open)"
            message shouldContain "ttyACM0 (on) shows dist(front, light(3)"
            message shouldContain "dist(front is left out: "
            message shouldContain "ttyACM1 (never opened) shows dist(front,30)"
        }
    }

    test("what agents log is in their log, and not on the console unless that is asked for") {
        val console = Logger.getLogger("").handlers.filterIsInstance<ConsoleHandler>().single()
        fun isShown() = console.isLoggable(LogRecord(Level.INFO, "a line"))
        watcher("argo.limit(100)").use { agent ->
            agent.mas.time.driving { isShown() } shouldBe false
            System.setProperty("argo.testkit.log", "console")
            agent.mas.time.driving { isShown() } shouldBe true
            System.clearProperty("argo.testkit.log")
            isShown() shouldBe true
        }
    }

    test("a board that hung starts anew when it is plugged in again") {
        watcher("argo.limit(50)").use { agent ->
            agent.perceives("light(3)").board.hangs()
            agent.shouldBelieve("port(ttyACM0,timeout)", within = 2.seconds).board.disconnects()
            agent.shouldBelieve("port(ttyACM0,off)", within = 2.seconds).board.reconnects()
            agent.shouldBelieve("port(ttyACM0,on)", within = 5.seconds)
            agent.perceives("light(4)").shouldBelieve("light(4)").shouldNotBelieve("stale(_)")
        }
    }
})
