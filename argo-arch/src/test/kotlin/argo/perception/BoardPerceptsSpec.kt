package argo.perception

import argo.acting.CommandLedger
import argo.acting.Reflexes
import argo.connecting.OpenPort
import argo.connecting.PortOptions
import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.TermTest
import argo.filters.dropFilter
import argo.links.JavinoLink
import argo.platform.RateLimitedWarning
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import javino.link.Link
import javino.link.LinkSettings
import javino.sim.FakeBoard
import javino.wire.ReflexOutcome
import java.util.logging.Logger

internal class WantedBoard(private val wants: () -> Boolean) : PerceivedBoard {
    override val sensed = emptyList<Literal>()
    override fun isOn(port: OpenPort) = wants()
    override fun filtered(snapshot: Snapshot) = Unit
}

private class PerceptsBench(port: OpenPort) {
    var nowMs = 0L
    var wants = true
    private val warning = RateLimitedWarning({ nowMs }) { error(it) }
    private val sent = ArrayList<String>()
    private val handOver = FreshHandOver(UnfinishedWork(CommandLedger { null }))
    private val port = port
    var isBoards = false
    private val unreadable = ArrayList<String>()
    val beliefs: List<String> get() = reflexBeliefs.beliefs().map { "$it" }
    private val reflexBeliefs = Reflexes({ _, command, _ -> sent += command }, { _, _ -> isBoards }, { _, _, _ -> }, warning)
    val board = BoardPercepts(
        WantedBoard { wants }, BeliefReader { unreadable += it }, PerceptLimit(1000, warning), handOver, reflexBeliefs,
        Logger.getLogger("test"),
    ) { nowMs * 1_000_000 }

    fun hears(message: String, askedMs: Long = nowMs, olderMs: Map<String, Long> = emptyMap()) =
        board.received(port, message, askedMs, nowMs, olderMs)

    /** Hands over the board's report of a percept that meets [rule]. */
    fun isTold(percept: String, rule: CriticalRule, outcome: ReflexOutcome = ReflexOutcome.CARRIED_OUT) =
        board.reported(port, rule, outcome, percept, nowMs)

    fun seenMs(percept: String) = board.lastSeen.lastSeenNanos(ASSyntax.parseLiteral(percept))

    fun refused(): List<String> = unreadable.toList().also { unreadable.clear() }

    fun perceived() = handOver.take()?.percepts?.map { "$it" }

    fun reflexes(): List<String> = sent.toList()
}

class BoardPerceptsSpec : FunSpec({
    val calm = dropFilter("calm") { drop("temp") { everyMs(300) } }
    val careful = dropFilter("careful") { critical("near") { reflex("stop") } }

    fun perceiving(work: PerceptsBench.() -> Unit) = FakeBoard.plugIn("percepts").use { board ->
        JavinoLink(Link.open(board.port(), LinkSettings.defaults(), "test")).use { link ->
            PerceptsBench(OpenPort(mapOf(ASSyntax.createAtom("p") to board.port()), link, PortOptions(), 0, 0) { AutoCloseable { } }).work()
        }
    }

    test("a percept that is older than its message keeps its own time, also when the message is perceived through another filter") {
        perceiving {
            nowMs = 100
            hears("dist(f,2);light(3);", olderMs = mapOf("dist(f,2)" to 40))
            listOf("dist(f,2)", "light(3)").map(::seenMs) shouldBe listOf(40, 100)
            board.switchTo(dropFilter("noTemp") { drop("temp") })
            listOf("dist(f,2)", "light(3)").map(::seenMs) shouldBe listOf(40, 100)
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

    test("a smoothing rule counts each reading once, also one that a board reports or that is older than its message") {
        perceiving {
            board.switchTo(dropFilter("smooth") { smooth("dist") { argument(1) median 3 }; critical("near") })
            hears("dist(f,40);dist(b,40);")
            nowMs = 20
            hears("dist(f,300);dist(b,41);")
            repeat(5) { isTold("near", board.critical.first()) }
            perceived() shouldBe listOf("dist(f,300)", "dist(b,41)", "near")
            nowMs = 40
            hears("dist(f,41);dist(b,300);", askedMs = 30, olderMs = mapOf("dist(b,300)" to 25))
            perceived() shouldBe listOf("dist(f,41)", "dist(b,41)")
            nowMs = 60
            hears("dist(f,42);dist(b,300);", askedMs = 50, olderMs = mapOf("dist(b,300)" to 25))
            perceived() shouldBe listOf("dist(f,42)", "dist(b,41)")
        }
    }

    test("the beginning of smoothing is anew after the agent turned away from its sensors") {
        perceiving {
            board.switchTo(dropFilter("smooth") { smooth("dist") { argument(1) median 3 } })
            repeat(3) { hears("dist(f,40);") }
            board.forget()
            hears("dist(f,9);")
            perceived() shouldBe listOf("dist(f,9)")
        }
    }

    test("a critical rule that is smoothed has its reflex when the percept that stands meets it") {
        perceiving {
            board.switchTo(
                dropFilter("smooth") {
                    smooth("dist") { argument(1) median 3 }
                    critical("dist") { argument(1) lt 15; smoothed(); reflex("stop") }
                },
            )
            listOf(40, 41, 5, 42).forEach { hears("dist(f,$it);") }
            reflexes().shouldBeEmpty()
            listOf(6, 7).forEach { hears("dist(f,$it);") }
            reflexes() shouldBe listOf("stop")
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

    context("a percept that the board reports by itself") {
        val rule = CriticalRule(Rule("dist", Condition.Argument(1, TermTest.Compare(Operator.LT, GroundTerm.of("15")))), "stop")
        val near = PerceptionFilter("near", emptyList(), critical = listOf(rule))

        fun reporting(work: PerceptsBench.() -> Unit) = perceiving {
            isBoards = true
            board.switchTo(near)
            hears("dist(f,90);dist(b,80);light(4);")
            perceived()
            nowMs = 10
            work()
        }

        test("takes the place of its sensor's in the newest message, and its age alone is new") {
            reporting {
                isTold("dist(b,9);", rule) shouldBe true
                perceived() shouldBe listOf("dist(f,90)", "dist(b,9)", "light(4)")
                seenMs("dist(b,9)") shouldBe 10
                seenMs("dist(f,90)") shouldBe 0
                beliefs shouldBe listOf("reflex(stop,done)")
                reflexes().shouldBeEmpty()
            }
        }

        test("stands behind the others if no sensor had it, and alone before the first message") {
            reporting {
                isTold("dist(left,9);", rule)
                perceived() shouldBe listOf("dist(f,90)", "dist(b,80)", "light(4)", "dist(left,9)")
                board.forget()
                isTold("dist(left,9);", rule)
                perceived() shouldBe listOf("dist(left,9)")
            }
        }

        test("among sensors with numbers for names it is the one that it shares most with") {
            reporting {
                hears("dist(1,90);dist(2,80);dist(3,70);")
                perceived()
                nowMs = 20
                isTold("dist(2,9);", rule)
                perceived() shouldBe listOf("dist(1,90)", "dist(2,9)", "dist(3,70)")
            }
        }

        test("stays in an answer that was asked for before it, and is gone with the next one") {
            reporting {
                isTold("dist(b,9);", rule)
                perceived()
                nowMs = 30
                hears("dist(f,89);dist(b,79);light(5);", askedMs = 5)
                perceived() shouldBe listOf("dist(f,89)", "dist(b,9)", "light(5)")
                beliefs shouldBe listOf("reflex(stop,done)")
                seenMs("dist(b,9)") shouldBe 10
                seenMs("light(5)") shouldBe 30
                nowMs = 50
                hears("dist(f,88);dist(b,78);light(6);", askedMs = 35)
                perceived() shouldBe listOf("dist(f,88)", "dist(b,78)", "light(6)")
                beliefs.shouldBeEmpty()
                reflexes().shouldBeEmpty()
            }
        }

        test("is nothing to an agent that does not perceive any more") {
            reporting {
                wants = false
                board.forget()
                isTold("dist(b,9);", rule) shouldBe false
                perceived() shouldBe null
                beliefs.shouldBeEmpty()
            }
        }

        test("goes through the filter as any other") {
            perceiving {
                isBoards = true
                board.switchTo(PerceptionFilter("noDist", listOf(Rule("dist")), critical = listOf(rule)))
                hears("dist(f,90);light(4);")
                perceived() shouldBe listOf("light(4)")
                isTold("dist(f,9);", rule)
                perceived() shouldBe listOf("dist(f,9)", "light(4)")
                isTold("dist(f,20);", rule) // it does not meet the rule
                perceived() shouldBe listOf("light(4)")
                beliefs.shouldBeEmpty()
            }
        }

        test("may hold anything: it costs itself alone") {
            val claims = listOf("X;", "port(ttyACM0,off);", "reflex(stop,done);", "stale(p);")
            for (text in claims + listOf("", ";", ";;;", "dist(;", "dist(b,9", "\u0000\u0001;", "A".repeat(250))) {
                reporting {
                    isTold(text, rule) shouldBe true
                    nowMs = 20
                    hears("dist(f,90);light(4);")
                    perceived() shouldBe listOf("dist(f,90)", "light(4)")
                }
            }
        }

        test("stays once for each rule, whatever the board reports") {
            reporting {
                repeat(1_000) { isTold("p${"x".repeat(it % 97)}y${"z".repeat(it % 89)};", rule) }
                perceived()!!.size shouldBe 4
                isTold("q;", CriticalRule(Rule("q")))
                perceived()!!.size shouldBe 5
                nowMs = 20
                hears("light(4);")
                perceived() shouldBe listOf("light(4)")
            }
        }

        test("of several in one report the first counts") {
            reporting {
                isTold("dist(f,9);dist(b,8);", rule)
                perceived() shouldBe listOf("dist(f,9)", "dist(b,80)", "light(4)")
            }
        }
    }

    test("a board claims no outcome of a reflex") {
        perceiving {
            hears("reflex(stop,done);reflex(stop,failed);reflex(stop,soon);reflex(stop);")
            perceived() shouldBe listOf("reflex(stop,soon)", "reflex(stop)")
            refused().first() shouldContain "reflex/2 with done or failed is a belief of ARGO's own, which no board can claim"
        }
    }
})
