package argo.perception

import argo.acting.CommandLedger
import argo.acting.Reflexes
import argo.connecting.OpenPort
import argo.connecting.PortOptions
import argo.filters.dropFilter
import argo.links.JavinoLink
import argo.platform.RateLimitedWarning
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import jason.asSyntax.ASSyntax
import javino.interleavings.concurrently
import javino.interleavings.inEachInterleaving
import javino.link.Link
import javino.link.LinkSettings
import javino.sim.FakeBoard
import javino.wire.ReflexOutcome
import java.util.logging.Logger

/** An agent that perceives the board on [port]. The test sets the time. */
private class Perceiving(private val port: OpenPort, log: Logger) {
    @Volatile
    var nowMs = 0L

    @Volatile
    var wants = true

    @Volatile
    var reflexes = 0
    private val warning = RateLimitedWarning({ 0 }) { error(it) }
    private val handOver = FreshHandOver(UnfinishedWork(CommandLedger { null }, nowMs = { 0 }))
    val board = BoardPercepts(
        WantedBoard { wants }, BeliefReader { error(it) }, PerceptLimit(1000, warning), handOver,
        Reflexes({ _, _, _ -> reflexes++ }, { _, _ -> false }, { _, _, _ -> }, warning), log,
    ) { nowMs * 1_000_000 }
    private var perceived = ""

    /** Hands over [message], as the sensing thread does. */
    fun hears(message: String) = board.received(port, message, nowMs, nowMs)

    /** Begins a reasoning cycle, as the agent's thread does. Returns the beliefs about the board in it. */
    fun perceive(): String {
        board.putDue()
        handOver.take()?.let { perceived = it.percepts.toString() }
        return perceived
    }
}

@Tags("Thorough")
class BoardPerceptsInterleavingsSpec : FunSpec({
    val calm = dropFilter("calm") { drop("temp") { everyMs(500) } }
    val careful = dropFilter("careful") { critical("near") { reflex("stop") } }
    val log = Logger.getLogger("test")
    val board = FakeBoard.plugIn("interleaved")
    val link = JavinoLink(Link.open(board.port(), LinkSettings.defaults(), "test"))
    val port = OpenPort(mapOf(ASSyntax.createAtom("p") to board.port()), link, PortOptions(), 0, 0) { AutoCloseable { } }
    afterSpec {
        link.close()
        board.close()
    }

    test("an old value is not perceived after the new one that a filter held back until it was due") {
        inEachInterleaving {
            val agent = Perceiving(port, log)
            agent.board.switchTo(calm)
            agent.hears("temp(1);")
            agent.perceive()
            agent.nowMs = 499
            concurrently(
                { agent.hears("temp(2);") },
                {
                    agent.nowMs = 500
                    agent.perceive()
                },
            )
            val perceived = agent.perceive()
            check(perceived == "[temp(2)]") { "perceived last: $perceived" }
        }
    }

    test("once the agent has stopped perceiving no reflex is sent and nothing is left to perceive") {
        inEachInterleaving {
            val agent = Perceiving(port, log)
            agent.board.switchTo(careful)
            var sent = 0
            concurrently(
                { agent.hears("near(1);") },
                {
                    agent.wants = false
                    agent.board.forget()
                    sent = agent.reflexes
                },
            )
            check(agent.reflexes == sent) { "a reflex is sent" }
            val perceived = agent.perceive()
            check(perceived == "") { "perceived: $perceived" }
        }
    }

    test("a report of the board's is not lost in an answer that was asked for before it") {
        val rule = careful.critical.single()
        inEachInterleaving {
            val agent = Perceiving(port, log)
            agent.board.switchTo(careful)
            concurrently(
                { agent.board.received(port, "near(1);light(3);", 1, 3) },
                { agent.board.reported(port, rule, ReflexOutcome.CARRIED_OUT, "near(2);", 2) },
            )
            val perceived = generateSequence { agent.perceive().takeIf { it != "" } }.take(3).last()
            check("near(2)" in perceived) { "perceived: $perceived" }
        }
    }
})
