package argo.behaviour

import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.string.shouldContain

class CanSpec : FunSpec({
    val asks = """
        !start.
        +!start <- argo.port(ttyACM0, [boot(0)]); argo.act(ready).
        +!context(A) : argo.can(A) <- .print("can ", A).
        +!context(A) <- .print("cannot ", A).
        +!step(A) <- argo.can(A); .print("has ", A).
        -!step(A)[error(E),error_msg(M)] <- .print("<", E, " ", M, ">").
    """

    test("of a board of version 1 nothing is known: false in a context, and a step fails its plan") {
        agentOf(asks).use { bob ->
            bob.hears("user", "achieve", "context(speed(1))").shouldPrint("cannot speed(1)")
            bob.shouldSend("ready").hears("user", "achieve", "step(speed(1))").shouldPrint("<no_vocabulary argo.can(speed(1)): ")
            bob.printed.last() shouldContain "the board on port ttyACM0 has not described its actions"
        }
    }

    test("without a port nothing is known, and what is no literal is refused") {
        agentOf(asks.lines().filterNot { "!start" in it }.joinToString("\n")).use { bob ->
            bob.hears("user", "achieve", "context(speed(1))").shouldPrint("cannot speed(1)")
            bob.hears("user", "achieve", "step(speed(1))").shouldPrint("<no_vocabulary argo.can(speed(1)): no port is in use")
            bob.hears("user", "achieve", "step(3)").shouldPrint("<wrong_arguments argo.can(3): an action is a literal")
        }
    }
})
