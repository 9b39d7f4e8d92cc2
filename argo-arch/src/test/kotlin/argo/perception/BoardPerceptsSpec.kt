package argo.perception

import argo.acting.CommandLedger
import argo.acting.Reflexes
import argo.filters.dropFilter
import argo.platform.RateLimitedWarning
import argo.ports.OpenPort
import argo.ports.PortOptions
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import jason.asSyntax.ASSyntax
import javino.Link
import javino.LinkSettings
import javino.sim.FakeBoard
import java.util.concurrent.locks.ReentrantLock
import java.util.logging.Logger

/** The percepts of a board that an agent perceives, as long as it [wants] to. */
private class PerceptsBench(port: OpenPort) {
    var nowMs = 0L
    var wants = true
    private val warning = RateLimitedWarning({ nowMs }) { error(it) }
    private val sent = ArrayList<String>()
    private val handOver = FreshHandOver(CommandLedger { null }, PerceptEvents { emptyList() })
    private val port = port
    val board = BoardPercepts(
        ReentrantLock(), { wants }, handOver, Reflexes({ _, command, _ -> sent += command }, warning), { },
        BeliefReader { error(it) }, Logger.getLogger("test"), PerceptLimit(1000, warning), LastSeen { emptyList() }, { nowMs },
    )

    fun hears(message: String) = board.received(port, message, nowMs)

    /** What the agent perceives now. */
    fun perceived() = handOver.take()?.percepts?.map { "$it" }

    /** The reflexes that were sent. */
    fun reflexes(): List<String> = sent.toList()
}

class BoardPerceptsSpec : FunSpec({
    val calm = dropFilter("calm") { drop("temp") { everyMs(300) } }
    val careful = dropFilter("careful") { critical("near") { reflex("stop") } }

    fun perceiving(work: PerceptsBench.() -> Unit) = FakeBoard.plugIn("percepts").use { board ->
        Link.open(board.port(), LinkSettings.defaults(), "test").use { link ->
            PerceptsBench(OpenPort(mapOf(ASSyntax.createAtom("p") to board.port()), link, PortOptions(), 0, 0) { AutoCloseable { } }).work()
        }
    }

    test("what a rate holds back is left for the agent when its time is over") {
        perceiving {
            board.switchTo(calm)
            hears("temp(1);")
            perceived() shouldBe listOf("temp(1)")
            board.dueInMs() shouldBe null
            hears("temp(2);")
            perceived() shouldBe listOf("temp(1)")
            board.dueInMs() shouldBe 300
            nowMs = 300
            board.putDue()
            perceived() shouldBe listOf("temp(2)")
            board.dueInMs() shouldBe null
        }
    }

    test("what was held back when the agent turned away from its sensors never comes due") {
        perceiving {
            board.switchTo(calm)
            hears("temp(1);")
            hears("temp(2);")
            board.forget()
            nowMs = 60_000
            board.dueInMs() shouldBe null
            board.putDue()
            perceived() shouldBe null
            hears("temp(3);")
            perceived() shouldBe listOf("temp(3)")
        }
    }

    test("a snapshot that was made before the filter changed is made anew") {
        perceiving {
            hears("temp(1);dist(f,2);")
            board.switchTo(dropFilter("noTemp") { drop("temp") })
            perceived() shouldBe listOf("dist(f,2)")
            perceived() shouldBe null
        }
    }

    test("a message that comes when the agent does not perceive any more leaves nothing and causes no reflex") {
        perceiving {
            board.switchTo(careful)
            hears("near;") shouldBe true
            reflexes() shouldBe listOf("stop")
            wants = false
            board.forget()
            hears("near;") shouldBe false
            perceived() shouldBe null
            reflexes() shouldBe listOf("stop")
        }
    }

    test("a filter with critical rules applies to the message that waits for the agent, reflexes included") {
        perceiving {
            hears("near;")
            reflexes() shouldBe emptyList()
            board.switchTo(careful)
            reflexes() shouldBe listOf("stop")
            perceived() shouldBe listOf("near")
        }
    }
})
