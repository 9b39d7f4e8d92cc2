package argo.behaviour

import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class ActingSpec : FunSpec({
    test("commands go out in the agent's order, as the agent wrote them") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [boot(0), spacing(0)]); argo.act(ledOn); argo.act(speed(120)); argo.act(say("hi; you"));
                       X = 3; argo.act(turn(left,X*2)); argo.act("raw text"); argo.act(~open(door)); argo.act(done).
        """).use { bob ->
            bob.shouldSend("done").sent shouldBe
                listOf("ledOn", "speed(120)", "say(\"hi; you\")", "turn(left,6)", "raw text", "~open(door)", "done")
        }
    }

    for (form in listOf("argo.", ".", ".argo.")) test("the form $form of each action works") {
        val filter = if (form == "argo.") "" else "${form}filter(none);"
        agentOf("""
            !start.
            +!start <- ${form}port(ttyACM0); ${form}limit(5); ${form}change_filter(none); $filter ${form}percepts(open).
            +p <- ${form}act(ok).
        """).use { bob -> bob.perceives("p").shouldSend("ok").log.filter { "WARNING" in it }.shouldBeEmpty() }
    }

    test("a loop of argo.act neither starves sensing nor runs ahead of it: the stop is sent right after it is decided") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [baud(57600)]); argo.limit(0); argo.percepts(open); !moving.
            +!moving : dist(f,X) & X > 40 <- argo.act(front); !moving.
            +!moving : dist(f,X) <- argo.act(stop); argo.act(at(X)).
            -!moving <- .wait(5); !moving.
        """) {
            var n = 100
            board.shows { listOf("dist(f,${n--})") }
        }.use { bob ->
            val received = bob.shouldSend("stop", within = 5.seconds).shouldSend("at(40)").board.received.takeWhile { it != "stop" }
            // the answer to request 61 is 40 cm; one request under way and one held back may follow
            received.count { it == "getPercepts" } shouldBeInRange 61..63
            received.count { it == "front" } shouldBeInRange 61..183 // one to three commands for each request
        }
    }

    test("commands to a board that has fallen silent fail together after five seconds, urgent ones go out, and the log has it once") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0); argo.limit(50); argo.percepts(open).
            +p <- argo.act(first); .wait(2000);
                  for (.range(I,1,5)) { !!do(walk(I),[]) }; .wait(1000); !!do(walk(6),[]); !!do(run,[timeout(20000)]); !!do(speed(1),[latest]);
                  .wait(1500); !!do(stop,[urgent]); !!do(speed(2),[latest]).
            +!do(W,Options) <- argo.act(W,Options).
            -!do(W,_)[error(E),error_msg(M)] <- +failed(W,E); .print(M).
        """) { board.shows("p") }.use { bob ->
            bob.shouldSend("first").board.ignoresRequests()
            bob.shouldSend("stop", within = 5.seconds)
            bob.shouldBelieve("failed(walk(1),port_timeout)", within = 3.seconds).after(1.milliseconds)
            bob.shouldBelieve("failed(walk(5),port_timeout) & not failed(walk(6),_)", within = 1.milliseconds)
            bob.shouldPrint("the board does not answer", within = 1.milliseconds)
            bob.shouldBelieve("failed(walk(6),port_timeout) & failed(speed(1),act_replaced)", within = 1100.milliseconds)
            bob.sent shouldBe listOf("first", "stop")
            bob.log.count { "have waited for 5000 ms" in it } shouldBe 1
            bob.board.shows("p", "q")
            bob.shouldSend("speed(2)").sent shouldBe listOf("first", "stop", "run", "speed(2)")
        }
    }

    test("an intention that waits for its command does not stop the agent") {
        agentOf("""
            !start. !think(0).
            +!start <- argo.port(ttyACM0); argo.act(front); ?thoughts(N); .print(thought(N)).
            +!think(N) <- -+thoughts(N); .wait(1); !think(N+1).
        """) { board.boots(1.seconds) }.use { bob ->
            bob.shouldSend("front", within = 5.seconds).shouldPrint("thought(")
            Regex("\\d+").find(bob.printed.single())!!.value.toInt() shouldBeGreaterThan 900
        }
    }

    test("an action that cannot be done fails its plan with a message that names it, its argument and the cause") {
        val attempts = mapOf(
            "argo.act(ledOn)" to "no_port",
            "argo.act" to "wrong_arguments",
            "argo.act(5)" to "wrong_arguments",
            "argo.act([a])" to "wrong_arguments",
            "argo.act(a & b)" to "wrong_arguments",
            "argo.act(\"\")" to "wrong_arguments",
            "argo.act(X)" to "wrong_arguments",
            "argo.act(speed(X))" to "wrong_arguments",
            "argo.act(\"say(fffe05front)\")" to "no_port",
            "argo.act(\"\u0001\")" to "no_port",
            "argo.act(\"say(1\\n)\")" to "no_port",
            "argo.act(getPercepts)" to "no_port",
            "argo.act(\"getPercepts(dist,light)\")" to "no_port",
            "argo.port(\"sim:nobody\")" to "no_such_port",
            "argo.port(COM77)" to "no_such_port",
            "argo.port(f(x))" to "wrong_arguments",
            "argo.port(\"\")" to "wrong_arguments",
            "argo.port(_)" to "wrong_arguments",
            "argo.port(ttyACM0,baud(1))" to "wrong_arguments",
            "argo.port(ttyACM0,[bauds(1)])" to "wrong_arguments",
            "argo.port(ttyACM0,[baud(9600),baud(1200)])" to "wrong_arguments",
            "argo.ports([ttyACM0,port(ttyACM0,[as(left)])])" to "wrong_arguments",
            "argo.limit(10,[port(ttyACM0),port(ttyACM1)])" to "wrong_arguments",
            "argo.limit(-1)" to "wrong_arguments",
            "argo.limit(1.5)" to "wrong_arguments",
            "argo.limit(fast)" to "wrong_arguments",
            "argo.limit(1,2)" to "wrong_arguments",
            "argo.percepts(maybe)" to "wrong_arguments",
            "argo.change_filter(nowhere)" to "no_such_filter",
            "argo.change_filter(\"../secret\")" to "no_such_filter",
            "argo.change_filter(7)" to "wrong_arguments",
        )
        val plans = attempts.keys.withIndex().joinToString("\n") { (i, call) ->
            "+!try($i) <- $call; .print(\"$i worked\").\n-!try($i)[error(E),error_msg(M)] <- .print(\"<\",$i,\" \",E,\" \",M,\">\")."
        }
        agentOf("!start.\n+!start <- for (.range(I,0,${attempts.size - 1})) { !try(I) }; .print(finished).\n$plans") {
            board("sim:nobody").disconnects()
            board("COM77").disconnects()
        }.use { bob ->
            bob.shouldPrint("finished")
            attempts.entries.forEachIndexed { i, (call, error) ->
                val line = bob.printed.singleOrNull { it.startsWith("<$i ") } ?: error("$call: ${bob.printed}")
                line shouldContain "$error "
                line shouldContain call.substringBefore('(')
            }
            bob.printed.joinToString("\n") shouldContain "argo.act(ledOn): no port is in use; choose one with argo.port first"
            bob.board("ttyACM0").received.shouldBeEmpty()
        }
    }

    test("a command too long for a message is refused and nothing is sent") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [boot(0)]); argo.act("${"x".repeat(256)}").
            -!start[error(E),error_msg(M)] <- .print(E, " ", M); argo.act(ok).
        """).use { bob -> bob.shouldSend("ok").shouldPrint("255").shouldPrint("wrong_arguments").shouldSendNothingElse() }
    }

    test("a command with a control character, or with the header of a frame, is refused and nothing is sent") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [boot(0)]); !try("${'\u0001'}"); !try("say(fffe05front)"); !try("say(1\n)"); argo.act(ok).
            +!try(Text) <- argo.act(Text).
            -!try(_)[error(E)] <- .print(E).
        """).use { bob ->
            bob.shouldSend("ok").shouldSendNothingElse()
            bob.printed.filter { it == "wrong_arguments" }.size shouldBe 3
        }
    }

    test("an agent without argo.Arch is told how to get a board") {
        val program = "!start.\n+!start <- argo.port(ttyACM0).\n-!start[error(E),error_msg(M)] <- .print(E, \" \", M)."
        agentOf(program) { arch = null }.use { bob ->
            bob.shouldPrint("not_argo").shouldPrint("agentArchClass argo.Arch")
        }
    }

    test("a command that the board's vocabulary does not hold fails its plan and does not go out") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0).
            +!do(W) <- argo.act(W); .print(done(W)).
            -!do(W)[error(E)] <- .print(failed(W,E)).
        """) { board.version2().knows("ledOn", "speed/1") }.use { bob ->
            bob.hears("user", "achieve", "do(ledOn)").shouldPrint("done(ledOn)").after(1.seconds) // the board has described itself by then
            for (command in listOf("fly", "speed")) {
                bob.hears("user", "achieve", "do($command)").shouldPrint("failed($command,act_refused)")
            }
            bob.hears("user", "achieve", "do(speed(3))").shouldPrint("done(speed(3))").board.commands shouldBe listOf("ledOn", "speed(3)")
        }
    }

    test("an atomic plan acts too") {
        agentOf("!start.\n@a[atomic] +!start <- argo.port(ttyACM0, [boot(0)]); argo.act(one); argo.act(two).").use { bob ->
            bob.shouldSend("one").shouldSend("two").shouldSendNothingElse()
        }
    }
})
