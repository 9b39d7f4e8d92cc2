package argo.behaviour

import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class CanSpec : FunSpec({
    fun asks(version: Int) = """
        !start.
        +!start <- argo.port(ttyACM0, [protocol($version), boot(1000)]); argo.act(ready).
        +!context(A) : argo.can(A) <- .print("can ", A).
        +!context(A) <- .print("cannot ", A).
        +!step(A) <- argo.can(A); .print("has ", A).
        -!step(A)[error(E),error_msg(M)] <- .print("<", E, " ", M, ">").
    """

    test("of a board of version 1 nothing is known: false in a context, and a step fails its plan") {
        agentOf(asks(1)).use { bob ->
            bob.hears("user", "achieve", "context(speed(1))").shouldPrint("cannot speed(1)")
            bob.shouldSend("ready", within = 5.seconds).hears("user", "achieve", "step(speed(1))")
                .shouldPrint("<no_vocabulary argo.can(speed(1)): ")
            bob.printed.last() shouldContain "the board on port ttyACM0 has not described its actions"
        }
    }

    test("without a port nothing is known, and what is no literal is refused") {
        agentOf(asks(1).lines().filterNot { "!start" in it }.joinToString("\n")).use { bob ->
            bob.hears("user", "achieve", "context(speed(1))").shouldPrint("cannot speed(1)")
            bob.hears("user", "achieve", "step(speed(1))")
                .shouldPrint("<no_vocabulary argo.can(speed(1)): no port is in use")
            bob.hears("user", "achieve", "step(3)").shouldPrint("<wrong_arguments argo.can(3): an action is a literal")
        }
    }

    test("of a board that describes itself it is known, by name and number of arguments") {
        agentOf("""
            ${asks(2)}
            +!all <- .findall(A, argo.can(A), As); .print(As).
            +!fly <- argo.act(fly(1)).
            -!fly[error(E),error_msg(M)] <- .print(E, " ", M).
        """) { board.version2().knows("ready", "speed/1", "turn/2", "say/*", "Led On") }.use { bob ->
            bob.shouldSend("ready", within = 5.seconds).after(1.seconds)
            for (known in listOf("speed(120)", "speed(x)", "turn(1,2)", "say", "say(1,2,3)", "ready"))
                bob.hears("user", "achieve", "context($known)").shouldPrint("can $known")
            for (unknown in listOf("speed", "speed(1,2)", "turn(1)", "fly"))
                bob.hears("user", "achieve", "context($unknown)").shouldPrint("cannot $unknown")
            bob.hears("user", "achieve", "step(turn(1,2))").shouldPrint("has turn(1,2)")
            bob.hears("user", "achieve", "step(fly)").shouldPrint("<ia_failed")
            bob.hears("user", "achieve", "all").after(100.milliseconds).printed.last().replace(Regex("_[0-9]*"), "_") shouldBe
                "[ready,speed(_),turn(_,_),say]"
            bob.hears("user", "achieve", "fly").shouldPrint("act_refused argo.act(fly(1)): the board at port ttyACM0 refuses \"fly(1)\"")
            bob.printed.last() shouldContain
                "it has no action fly; it has ready, speed with 1 argument, turn with 2 arguments, say with any"
            bob.sent shouldNotContain "fly(1)"
        }
    }

    test("of a board of version 2 without a table nothing is known, and every command is sent") {
        agentOf(asks(2)) { board.version2() }.use { bob ->
            bob.shouldSend("ready", within = 5.seconds).after(1.seconds)
            bob.hears("user", "achieve", "context(ready)").shouldPrint("cannot ready")
            bob.hears("user", "achieve", "step(ready)").shouldPrint("<no_vocabulary")
        }
    }
})
