package argo.behaviour

import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class PerceivingSpec : FunSpec({
    val follower = "!start.\n+!start <- argo.port(ttyACM0); argo.limit(10); argo.percepts(open)."

    test("what a board says becomes beliefs and events") {
        agentOf("$follower\n+dist(f,X) <- argo.act(seen(X)).").use { bob ->
            bob.perceives("dist(f,38)", "light(b,140)", "~open(door)").shouldSend("seen(38)").shouldSendNothingElse()
            bob.beliefs shouldBe listOf("dist(f,38)", "light(b,140)", "port(ttyACM0,on)", "~open(door)")
        }
    }

    test("beliefs follow the board and go when it does not say them any more") {
        agentOf("$follower\n-door <- argo.act(gone).").use { bob ->
            bob.perceives("dist(f,3)", "door").shouldBelieve("dist(f,3) & door")
            bob.perceives("dist(f,2)").shouldSend("gone").beliefs shouldBe listOf("dist(f,2)", "port(ttyACM0,on)")
        }
    }

    test("a percept that goes has its own event, also with a negation or a namespace in the board's text") {
        agentOf("""
            $follower
            -open(D) <- argo.act(shut(D)).
            -~open(D) <- argo.act(not_shut(D)).
            -arm::open(D) <- argo.act(arm_shut(D)).
        """).use { bob ->
            bob.perceives("~open(door)", "open(gate)", "arm::open(hand)").shouldBelieve("~open(door) & open(gate) & arm::open(hand)")
            bob.perceives("open(gate)", "arm::open(hand)").shouldSend("not_shut(door)").shouldSendNothingElse()
            bob.perceives("~open(gate)", "arm::open(hand)").shouldSend("shut(gate)").shouldSendNothingElse()
            bob.perceives("open(gate)").shouldSend("not_shut(gate)").shouldSend("arm_shut(hand)").shouldSendNothingElse()
        }
    }

    test("perception is blocked until it is opened, and blocked again it leaves beliefs as they are") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0); argo.limit(5); argo.act(blocked).
            +!see(How) <- argo.percepts(How).
        """).use { bob ->
            val before = bob.shouldSend("blocked").board.requests
            bob.board.shows("count(1)")
            bob.shouldNotBelieve("count(_)").board.requests shouldBe before
            bob.hears("user", "achieve", "see(open)").shouldBelieve("count(1)")
            bob.hears("user", "achieve", "see(block)").board.shows("count(2)")
            bob.shouldNotBelieve("count(2)").shouldBelieve("count(1)")
        }
    }

    test("commands that wait for a slow board do not hold back what another board says") {
        agentOf("""
            !start.
            +!start <- argo.port(slow, [baud(300), boot(0)]); for (.range(I,1,200)) { !!send(I) }; .wait(100);
                       argo.port(robot, [baud(115200)]); argo.limit(5); argo.percepts(open).
            +!send(I) <- argo.act(takes_a_second_and_a_half_or_so(I)).
            +count(N) : N > 20 <- argo.act(counted).
        """) {
            var n = 0
            board("slow")
            board("robot").shows { listOf("count(${++n})") }
        }.use { bob ->
            bob.shouldSend("counted", within = 3.seconds)
            bob.board("slow").commands.size shouldBeLessThan 4
        }
    }

    context("the world does not stand still for") {
        val drives = mapOf(
            "an atomic plan that calls itself" to """
                @drive[atomic] +!drive : dist(f,X) & X > 40 <- argo.act(front); !drive.
                +!drive <- argo.act(stop).
            """,
            "an atomic plan that waits for a percept" to
                "@drive[atomic] +!drive <- argo.act(front); .wait(dist(f,X) & X <= 40); argo.act(stop).",
        )
        for ((who, drive) in drives) test(who) {
            agentOf("""
                !start.
                +!start <- argo.port(ttyACM0, [baud(115200)]); argo.limit(5); argo.percepts(open); .wait(dist(f,_)); !drive.
                $drive
                +light(f,X) : X > 1000 <- argo.act(bright).
            """) {
                var n = 80
                board.shows { listOf("dist(f,${n--})", "light(f,$n)") }
            }.use { bob -> bob.shouldSend("stop", within = 5.seconds).shouldBelieve("dist(f,X) & X <= 40") }
        }
    }

    test("a percept that Jason cannot read, or that no board may claim, costs itself alone") {
        agentOf("""
            $follower
            +last : say("a;b") & shutdown[source(percept)] & not shutdown[source(self)] & port(ttyACM0,on) <- argo.act(ok).
        """).use { bob ->
            bob.perceivesRaw("dist(f,;shutdown[source(self)];port(ttyACM0,off);a((;.stopMAS;X;say(\"a;b\");last;")
            bob.shouldSend("ok")
            bob.after(1.seconds).log.count { "percept dist(f, is left out" in it } shouldBe 1
        }
    }

    test("a silent board is believed to be in timeout, its last percepts stay, and it comes back by itself") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [timeout(50), boot(0)]); argo.limit(5); argo.percepts(open).
            +port(P,timeout) : dist(f,3) <- +quiet; .print("no answer from ", P).
            +port(P,on) : quiet & dist(f,3) <- argo.act(back).
        """).use { bob ->
            bob.perceives("dist(f,3)").shouldSendNothingElse().board.hangs()
            bob.shouldPrint("no answer from ttyACM0").shouldBelieve("port(ttyACM0,timeout) & dist(f,3)").shouldNotBelieve("port(_,on)")
            bob.board.recovers()
            bob.shouldSend("back").shouldBelieve("port(ttyACM0,on) & dist(f,3)")
        }
    }

    test("a pulled cable is believed at once, keeps the sensor beliefs, and the port can be opened again") {
        agentOf("""
            !connect.
            +!connect <- argo.port(ttyACM0); argo.limit(5); argo.percepts(open).
            -!connect[error(no_such_port)] <- +tried; .wait(20); !connect.
            +port(P,off) : dist(f,3) <- +lost; !connect.
            +port(P,on) : lost <- argo.act(back).
        """).use { bob ->
            bob.perceives("dist(f,3)").board.disconnects()
            bob.shouldBelieve("lost & port(ttyACM0,off) & dist(f,3)", within = 100.milliseconds)
            bob.shouldBelieve("tried").shouldNotSend("back")
            bob.board.reconnects()
            bob.shouldSend("back")
        }
    }

    test("a pulled cable is noticed by an agent that neither perceives nor acts, on each of its ports") {
        agentOf("!start.\n+!start <- argo.port(left); argo.port(right); +ready.").use { bob ->
            bob.shouldBelieve("ready").board("left").disconnects()
            bob.shouldBelieve("port(left,off) & port(right,on)").board("right").disconnects()
            bob.shouldBelieve("port(left,off) & port(right,off)")
        }
    }

    test("a board that speaks unasked is listened to and never asked") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [mode(listen), boot(0)]); argo.limit(60000); argo.percepts(open); argo.act(listening).
            +button(N) <- argo.act(pressed(N)).
        """).use { bob ->
            bob.shouldSend("listening").board.says("button(7)")
            bob.shouldSend("pressed(7)").board.says("button(8)")
            bob.shouldSend("pressed(8)").board.requests.shouldBeEmpty()
        }
    }

    test("an agent uses one port at a time and goes back to one that is still open") {
        agentOf("""
            !start.
            +!start <- argo.limit(5); argo.percepts(open); argo.port(left).
            +side(left)  : not turned <- +turned; argo.act(hello); argo.port(right).
            +side(right) <- argo.act(hello); argo.port(left); argo.act(again).
        """) {
            board("left").shows("side(left)")
            board("right").shows("side(right)")
        }.use { bob ->
            bob.shouldSend("again", within = 5.seconds).shouldBelieve("port(left,on) & port(right,on)")
            bob.board("left").commands.shouldContainExactly("hello", "again")
            bob.board("right").commands.shouldContainExactly("hello")
        }
    }
})
