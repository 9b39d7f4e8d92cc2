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
import kotlin.time.Duration.Companion.seconds

class PerceptsSpec : FunSpec({
    fun watcher(start: String) = agentOf("!start.\n+!start <- argo.port(ttyACM0, [baud(115200)]); $start; argo.percepts(open).")

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
