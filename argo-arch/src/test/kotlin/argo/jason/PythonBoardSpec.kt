package argo.jason

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe

class PythonBoardSpec : FunSpec({
    val link by lazy { tempdir().toPath().resolve("board") }

    fun onPython(name: String, body: suspend LocalMas.() -> Unit) =
        test(name).config(enabledOrReasonIf = { withPython }, blockingTest = true) { LocalMas().use { it.body() } }

    onPython("it is perceived, acts, refuses, reports an outcome later, and describes itself") {
        PythonBoard(link).use { board ->
            agent("bob", """
                !start.
                +!start <- argo.port("$link", [protocol(2)]); argo.percepts(open); argo.act(led); argo.act(speed(120));
                           argo.act(grip(true)); +gripped; !described.
                +!described : argo.can(say(_)) <- !refused(speed(0)); !refused(grip(false)); !refused(fly).
                +!described <- .wait(10); !described.
                +text(S,1.5,true,[1,x]) : .length(S,8) <- +read.
                +!refused(W) <- argo.act(W); +carried_out(W).
                -!refused(W)[error(E)] <- +failed(W,E).
            """)
            for (failed in listOf("speed(0)", "grip(false)", "fly")) awaitBelief("bob", "failed($failed,act_refused)")
            board.carriedOut.filter { it != "lost" } shouldBe listOf("led", "speed(120)", "grip(true)", "grip(false)")
            for (belief in listOf("gripped", "dist(f,100)", "read")) awaitBelief("bob", belief)
        }
    }

    onPython("with one byte in 200 damaged in both directions each command is carried out once, in order, and no other one is") {
        PythonBoard(link, seed = 8).use { board ->
            agent("bob", """
                !start.
                +!start <- argo.port("$link", [protocol(2)]); argo.limit(20); argo.percepts(open); !go(1).
                +!go(301) <- +finished.
                +!go(N) <- argo.act(speed(N)); !go(N+1).
            """)
            awaitBelief("bob", "finished")
            board.carriedOut.filter { it != "lost" } shouldBe (1..300).map { "speed($it)" }
            awaitBelief("bob", "count(300)")
        }
    }

    onPython("when its program is started anew the agent goes on") {
        val program = """
            !start.
            +!start <- argo.port("$link", [protocol(2)]); argo.percepts(open).
            +dist(f,_) <- argo.act(led).
            -port("$link",off) <- argo.act(stop).
        """
        PythonBoard(link).use { board ->
            agent("bob", program)
            eventually(LIMIT) { board.carriedOut shouldContain "led" }
        }
        awaitBelief("bob", "port(\"$link\",off)")
        PythonBoard(link).use { board ->
            awaitBelief("bob", "port(\"$link\",on)")
            eventually(LIMIT) { board.carriedOut shouldContain "stop" }
        }
    }
})
