package argo.behaviour

import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class StaleSpec : FunSpec({
    val project = Project(tempdir().toPath())

    test("silence is believed of the port in use after its time, ends with the next message, and no filter hides it") {
        project.file("filters/nothing.json", """{"keep": true, "rules": []}""")
        project.agent("""
            !start.
            +!start <- argo.port(ttyACM0, [timeout(50), boot(0), stale(250)]); argo.limit(5); argo.percepts(open).
            +dist(f,3) <- argo.change_filter(nothing); argo.act(see).
            +stale(P) : port(P,_) <- +was_stale.
            -stale(P) : was_stale <- argo.act(back).
        """).use { bob ->
            bob.perceives("dist(f,3)").shouldSend("see").board.hangs()
            bob.shouldNotBelieve("stale(_)", during = 130.milliseconds)
            bob.shouldBelieve("stale(ttyACM0) & was_stale", within = 130.milliseconds)
            bob.board.recovers()
            bob.shouldSend("back").shouldBelieve("not stale(_)")
        }
    }

    test("it wakes an agent that sleeps while its board speaks unasked") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [mode(listen), boot(0), stale(300)]); argo.percepts(open); argo.act(listening).
            +stale(ttyACM0) <- argo.act(silence).
        """).use { bob ->
            bob.shouldSend("listening").board.says("button(7)")
            bob.shouldBelieve("button(7)").shouldNotBelieve("stale(_)", during = 280.milliseconds)
            bob.shouldBelieve("stale(ttyACM0)", within = 30.milliseconds).shouldSend("silence")
        }
    }

    test("while perceiving is blocked nothing is stale, and what was is no more") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [timeout(50), boot(0), stale(100)]); argo.limit(5).
            +!look <- argo.percepts(open).
            +stale(_) <- argo.percepts(block); +turned_away.
        """) { board.ignoresRequests() }.use { bob ->
            bob.shouldNotBelieve("stale(_)").hears("user", "achieve", "look").shouldBelieve("turned_away", within = 110.milliseconds)
            bob.after(10.milliseconds).shouldNotBelieve("stale(_)")
        }
    }

    test("a pulled cable is stale in its time") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0, [boot(0), stale(200)]); argo.limit(5); argo.percepts(open).").use { bob ->
            bob.perceives("dist(f,3)").board.disconnects()
            bob.shouldNotBelieve("stale(_)", during = 180.milliseconds)
            bob.shouldBelieve("stale(ttyACM0) & dist(f,3)", within = 30.milliseconds)
        }
    }

    test("what was stale when the cable was out stays so until the board has said something") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [protocol(1), timeout(50), boot(0), stale(200)]); argo.limit(5); argo.percepts(open).
            -stale(_) : was_off <- +fresh_again.
            +port(_,off) <- +was_off.
            +port(_,timeout) : was_off <- +silent_since_it_is_back.
        """).use { bob ->
            bob.perceives("dist(f,3)").shouldBelieve("dist(f,3)").board.disconnects()
            bob.shouldBelieve("stale(ttyACM0)").board.ignoresRequests().reconnects()
            bob.shouldBelieve("silent_since_it_is_back", within = 3.seconds).shouldNotBelieve("fresh_again").shouldBelieve("stale(ttyACM0)")
            bob.board.shows("dist(f,4)")
            bob.shouldBelieve("fresh_again & dist(f,4)")
        }
    }

    test("asking for the port again does not put it off") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [protocol(1), timeout(50), boot(0), stale(500)]); argo.limit(5); argo.percepts(open).
            +dist(f,3) <- !!insist.
            +!insist : not stale(_) <- argo.port(ttyACM0); .wait(20); !!insist.
            +!insist.
        """).use { bob ->
            bob.perceives("dist(f,3)").after(100.milliseconds).board.hangs()
            bob.shouldNotBelieve("stale(_)", during = 480.milliseconds).shouldBelieve("stale(ttyACM0)", within = 50.milliseconds)
        }
    }
})
