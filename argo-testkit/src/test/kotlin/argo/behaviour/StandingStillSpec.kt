package argo.behaviour

import argo.observing.PausePhase
import argo.observing.PauseState
import argo.observing.StopAt
import argo.testkit.Arrival
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class StandingStillSpec : FunSpec({
    val project = Project(tempdir().toPath())

    /** Runs Bob's drive. [debugger] acts at each pause. Returns the commands with their times, and the times of the pauses. */
    fun drive(lines: List<Int>, debugger: (PauseState, StopAt?) -> StopAt?): Pair<List<Arrival>, List<Duration>> {
        val stood = ArrayList<Duration>()
        val bob = project.agent(DRIVING) { options("argo_diary" to "pauses") }
        val arrivals = bob.use {
            val pausing = DiaryProvider.opened.getValue("pauses").agent.pausing
            var last: StopAt? = null
            pausing.follow {
                if (it.phase == PausePhase.PAUSED) {
                    stood += bob.now
                    last = debugger(it, last)
                    last?.let(pausing::goOnUntil) ?: pausing.goOn()
                }
            }
            pausing.breakAt(this, "bob.asl", lines)
            repeat(20) { cm -> bob.board.shows("dist(f,${60 - 2 * cm})"); bob.after(50.milliseconds) }
            bob.after(1.seconds).arrivals
        }
        return arrivals to stood
    }

    test("in virtual time a breakpoint stops the world, so that it changes nothing of a drive") {
        val (expected, never) = drive(emptyList()) { _, _ -> null }
        never shouldBe emptyList()
        expected.size shouldBeGreaterThan 10
        val ways = Arb.list(Arb.element(null, StopAt.NextCycle, StopAt.ChosenPlan(null), StopAt.Belief("dist(_,_)")), 1..5)
        checkAll(10, Arb.list(Arb.element(3, 4, 5, 6), 1..3), ways) { lines, order ->
            var n = 0
            val (arrivals, stood) = drive(lines) { _, _ -> order[n++ % order.size] }
            arrivals shouldBe expected
            stood.size shouldBeGreaterThan 0
        }
    }
})

private const val DRIVING = """!start.
+!start <- argo.port(ttyACM0); argo.limit(20); argo.percepts(open).
+dist(f,X) : X < 40
   <- argo.act(slow(X)); .wait(10); !turn(X).
+dist(f,X) <- argo.act(go(X)).
+!turn(X) <- argo.act(turn(X)).
"""
