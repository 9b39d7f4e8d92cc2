package argo.behaviour

import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class Version2Spec : FunSpec({
    val project = Project(tempdir().toPath())

    test("a command that the board refuses fails its plan, one that it carries out does not") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0); argo.act(ledOn); argo.act(fly).
            -!start[error(E)] <- argo.act(said(E)).
        """) { board.version2().refuses("fly") }.use { bob ->
            bob.shouldSend("said(act_refused)", within = 5.seconds).sent shouldBe listOf("ledOn", "fly", "said(act_refused)")
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

    test("a command that the board says nothing of fails its plan") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0); argo.act(ledOn); +connected.
            +!walk <- argo.act(walk).
            -!walk[error(E)] <- +said(E).
        """) { board.version2() }.use { bob ->
            bob.shouldBelieve("connected", within = 5.seconds).board.hangs()
            bob.hears("user", "achieve", "walk").shouldBelieve("said(act_unconfirmed)", within = 20.seconds)
        }
    }

    test("a filter that keeps percepts by their functor has these alone asked for") {
        project.filter("near", "<filter><predicate>dist</predicate></filter>", "keep=\"true\"")
        project.agent("""
            !start.
            +!start <- argo.port(ttyACM0, [protocol(2)]); argo.limit(5); argo.percepts(open).
            +light(f,_) <- argo.change_filter(near).
            -light(f,_) : dist(f,1) <- argo.act(ok).
        """) { board.version2() }.use { bob ->
            bob.perceives("dist(f,1)", "light(f,2)").shouldSend("ok").after(500.milliseconds)
            bob.board.requests shouldContain "getPercepts"
            bob.board.requests.takeLast(3) shouldBe List(3) { "getPercepts(dist)" }
        }
    }
})
