package argo.behaviour

import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.comparables.shouldBeLessThanOrEqualTo
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class ActingOptionsSpec : FunSpec({
    test("urgent commands go before those that wait, in their own order") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0); for (.range(I,1,5)) { !!do(walk(I),[]) }; .wait(20);
                       for (.range(I,1,3)) { !!do(stop(I),[urgent]) }.
            +!do(W,Options) <- argo.act(W,Options).
        """) { board.boots(1.5.seconds) }.use { bob -> // nothing goes out before it has booted, so all of them wait
            bob.shouldSend("walk(5)", within = 10.seconds)
            bob.sent shouldBe listOf("stop(1)", "stop(2)", "stop(3)", "walk(1)", "walk(2)", "walk(3)", "walk(4)", "walk(5)")
        }
    }

    test("a command whose time is over before it begins to go out is never sent, and those behind it are") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0); !!plain; !late.
            +!plain <- argo.act(first).
            +!late <- argo.act(walk, [timeout(50)]).
            -!late[error(E),error_msg(M)] <- .print(E, " ", M); argo.act(after(E)).
        """) { board.boots(2.seconds) }.use { bob ->
            val message = "act_timeout argo.act(walk,[timeout(50)]): \"walk\" had not begun to go out through port ttyACM0"
            bob.shouldPrint(message, within = 60.milliseconds)
            bob.shouldSend("after(act_timeout)", within = 10.seconds).after(1.seconds).sent shouldBe listOf("first", "after(act_timeout)")
        }
    }

    test("the command that is next on the line is withdrawn too, and an urgent one may be") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0); !late; argo.act(after).
            +!late <- argo.act(walk, [timeout(30), urgent]).
            -!late[error(act_timeout)] <- +withdrawn.
        """) { board.boots(2.seconds) }.use { bob ->
            bob.shouldBelieve("withdrawn", within = 40.milliseconds).shouldSend("after", within = 10.seconds).shouldSendNothingElse()
        }
    }

    for (version in 1..2) {
        test("in version $version a latest command takes the place of waiting ones of its functor, whose plans fail") {
            agentOf("""
                !start.
                +!start <- argo.port(ttyACM0, [protocol($version)]); !!do(walk(0),[]);
                           for (.range(I,1,3)) { !!do(speed(I),[latest]) }; !!do(walk(1),[latest]); !!do(say(1),[]); !!do(say(2),[]).
                +!do(W,Options) <- argo.act(W,Options); +done(W).
                -!do(W,_)[error(E),error_msg(M)] <- +failed(W,E); .print(M).
            """) {
                if (version == 2) board.version2()
                board.boots(1.seconds) // all commands wait until then
            }.use { bob ->
                bob.shouldBelieve("done(say(2))", within = 10.seconds).sent shouldBe listOf("walk(1)", "speed(3)", "say(1)", "say(2)")
                bob.shouldBelieve("failed(walk(0),act_replaced) & failed(speed(1),act_replaced) & failed(speed(2),act_replaced)")
                bob.shouldBelieve("done(walk(1)) & done(speed(3)) & not failed(speed(3),_)")
                bob.shouldPrint(
                    "\"speed(1)\" had not begun to go out through port ttyACM0 when \"speed(2)\" took its place, so it was not sent",
                )
            }
        }
    }

    test("an urgent latest command goes first, and replaces those that are not urgent") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0); !!do(walk,[]); !!do(speed(1),[]); !!do(speed(0),[latest,urgent]).
            +!do(W,Options) <- argo.act(W,Options).
            -!do(W,_)[error(E)] <- +failed(W,E).
        """) { board.boots(1.seconds) }.use { bob ->
            bob.shouldSend("walk", within = 10.seconds).shouldBelieve("failed(speed(1),act_replaced)")
            bob.sent shouldBe listOf("speed(0)", "walk")
        }
    }

    test("a board of version 2 that does not confirm in time leaves the command unconfirmed, and the next one goes out") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [protocol(auto)]); argo.act(ledOn); +connected.
            +!walk <- argo.act(walk, [timeout(200)]).
            -!walk[error(E),error_msg(M)] <- .print(M); +said(E); argo.act(next).
        """) { board.version2() }.use { bob ->
            bob.shouldBelieve("connected", within = 5.seconds).board.hangs()
            bob.hears("user", "achieve", "walk").shouldBelieve("said(act_unconfirmed)", within = 210.milliseconds)
            bob.shouldPrint("when its time was over")
            bob.board.recovers()
            bob.shouldSend("next", within = 5.seconds)
        }
    }

    test("a command that is still on a line of version 1 when its time is over is unconfirmed") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [baud(300), protocol(1), boot(0)]); !long.
            +!long <- argo.act(${"x".repeat(120)}, [timeout(300)]).
            -!long[error(E)] <- +said(E).
        """).use { bob ->
            bob.shouldNotBelieve("said(_)", during = 290.milliseconds).shouldBelieve("said(act_unconfirmed)", within = 20.milliseconds)
        }
    }

    test("a command that is carried out in time is not disturbed, however many have a limit") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [boot(0), spacing(0), baud(2000000)]);
                       for (.range(I,1,500)) { argo.act(n(I), [timeout(20000)]) }; argo.act(done).
        """).use { bob -> bob.shouldSend("done", within = 20.seconds).sent shouldBe List(500) { "n(${it + 1})" } + "done" }
    }

    test("under in_cycle a command is not sent once its time is over, and the other options change nothing") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0); !late; argo.act(after, [urgent, timeout(10000)]).
            +!late <- argo.act(walk, [timeout(50)]).
            -!late[error(act_timeout)] <- +withdrawn.
        """) {
            options("argo_sensing" to "in_cycle")
            board.boots(1.seconds)
        }.use { bob -> bob.shouldSend("after", within = 10.seconds).shouldBelieve("withdrawn").shouldSendNothingElse() }
    }

    test("options that cannot be used fail the plan and nothing is sent") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [boot(0)]);
                       for (.member(O,[urgent,[timeout],[timeout(0)],[urgently],[timeout(5),fast]])) { !try(O) }; argo.act(ok, []).
            +!try(O) <- argo.act(bad, O).
            -!try(O)[error(E),error_msg(M)] <- .print(E, " ", M).
        """).use { bob ->
            bob.shouldSend("ok").shouldSendNothingElse().printed.size shouldBe 5
            bob.printed.forEach { it shouldContain "wrong_arguments argo.act" }
        }
    }

    for (options in listOf("[]", "[urgent]")) test("loops of argo.act with $options leave the line to a request every second interval") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [baud(9600), spacing(0), queue(4)]); argo.limit(100); argo.percepts(open);
                       for (.range(I,1,8)) { !!drive }.
            +!drive <- argo.act(front,$options); !drive.
        """).use { bob ->
            bob.board.shows("dist(f,1)")
            val received = bob.after(5.seconds).board.received.dropWhile { it != "front" }
            received.count { it == "front" } shouldBeGreaterThan 200
            // a command of 11 bytes takes 11.5 ms of the line, so two intervals have room for at most 18
            val runs = received.joinToString(" ").split("getPercepts").map { run -> run.split(" ").count { it == "front" } }
            runs.max() shouldBeLessThanOrEqualTo 18
            runs.size shouldBeGreaterThan 20
        }
    }
})
