package argo.behaviour

import argo.Arch
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.ASSyntax
import jason.environment.Environment
import java.util.logging.Level
import java.util.logging.Logger
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class FilteringSpec : FunSpec({
    val project = Project(tempdir().toPath())
    val onlyFront = "<filter><predicate>light</predicate></filter>" +
        "<filter><predicate>dist</predicate><parameter operator=\"NE\" id=\"0\">f</parameter></filter>"
    val start = "!start.\n+!start <- argo.port(ttyACM0); argo.limit(5); argo.percepts(open).\n+!look(F) <- argo.change_filter(F)."

    fun Environment.shows(vararg percepts: String) {
        clearPercepts()
        addPercept(*percepts.map(ASSyntax::parseLiteral).toTypedArray())
        informAgsEnvironmentChanged()
    }

    test("a filter keeps percepts from the agent from the next perception on, and never the state of the port") {
        project.filter("onlyFront", onlyFront + "<filter><predicate>port</predicate></filter>")
        project.agent(start).use { bob ->
            bob.perceives("dist(f,1)", "dist(b,1)", "light(f,1)").beliefs shouldBe
                listOf("dist(b,1)", "dist(f,1)", "light(f,1)", "port(ttyACM0,on)")
            bob.hears("user", "achieve", "look(onlyFront)").perceives("dist(f,2)", "dist(b,2)", "light(f,2)")
            bob.beliefs shouldBe listOf("dist(f,2)", "port(ttyACM0,on)")
        }
    }

    test("a file that is refused leaves the active filter as it was, and the message has every problem") {
        project.filter("onlyFront", onlyFront)
        project.filter("broken", "\n${onlyFront.replace("NE", "NEQ")}\n<filter/>")
        project.agent("""
            !start.
            +!start <- argo.port(ttyACM0); argo.limit(5); argo.change_filter("onlyFront.xml"); argo.change_filter(broken).
            -!start[error(E),error_msg(M)] <- .print(E, " ", M); argo.percepts(open).
        """).use { bob ->
            bob.perceives("dist(f,4)", "light(f,4)").beliefs shouldBe listOf("dist(f,4)", "port(ttyACM0,on)")
            val message = bob.printed.single()
            listOf("bad_filter argo.change_filter(broken): ", "NEQ", "broken.xml:3:", "broken.xml:4:").forEach { message shouldContain it }
        }
    }

    test("the log says once what of a filter has no effect, and the filter is active") {
        project.filter("doubled", onlyFront + "<filter><predicate>light</predicate><parameter id=\"0\">f</parameter></filter>")
        project.agent(start).use { bob ->
            repeat(2) { bob.hears("user", "achieve", "look(doubled)").hears("user", "achieve", "look(none)") }
            bob.hears("user", "achieve", "look(doubled)").perceives("dist(f,1)", "light(f,1)")
            bob.beliefs shouldBe listOf("dist(f,1)", "port(ttyACM0,on)")
            bob.log.filter { "filter doubled" in it } shouldBe listOf(
                "WARNING filter doubled: rule 3 (light where argument 0 is f) has no effect: rule 1 (light) matches the same percepts",
            )
        }
    }

    val kinds = mapOf("with argo.Arch" to true, "of plain Jason" to false)
    for ((kind, withArch) in kinds) test("an agent $kind perceives a Jason environment through its filter") {
        project.filter("onlyFront", onlyFront)
        val hall = Environment()
        project.agent("+!look(F) <- argo.change_filter(F).") {
            environment = hall
            if (!withArch) arch = null
        }.use { bob ->
            hall.shows("dist(f,1)", "dist(b,2)", "light(f,3)")
            bob.after(10.milliseconds).beliefs shouldBe listOf("dist(b,2)", "dist(f,1)", "light(f,3)")
            bob.hears("user", "achieve", "look(onlyFront)").shouldBelieve("not light(_,_)").beliefs shouldBe listOf("dist(f,1)")
            bob.hears("user", "achieve", "look(none)") // the environment is unchanged and reports nothing new
            bob.shouldBelieve("light(f,3)").beliefs shouldBe listOf("dist(b,2)", "dist(f,1)", "light(f,3)")
            hall.shows("dist(f,9)")
            bob.after(10.milliseconds).beliefs shouldBe listOf("dist(f,9)")
        }
    }

    test("a value that a rate holds back reaches the agent in the end, though the board says nothing new") {
        project.filter("calm", "<filter everyMs=\"2000\"><predicate>temp</predicate></filter>")
        project.agent("""
            !start.
            +!start <- argo.port(ttyACM0); argo.limit(5); argo.change_filter(calm); argo.percepts(open).
            +temp(X) <- argo.act(seen(X)).
        """).use { bob ->
            bob.perceives("temp(1)").shouldSend("seen(1)").board.shows("temp(2)")
            bob.after(100.milliseconds).board.shows("temp(3)")
            bob.shouldSendNothingElse(during = 1.5.seconds).shouldSend("seen(3)").sent shouldBe listOf("seen(1)", "seen(3)")
        }
    }

    test("an agent can ask why a percept is dropped, and a log level tells it too") {
        project.filter("onlyFront", onlyFront)
        val logger = Logger.getLogger("${Arch::class.java.name}.bob").apply { level = Level.FINE }
        project.agent("""
            !start.
            +!start <- argo.explain(light(f,2),A); .print("first ", A); argo.change_filter(onlyFront);
                       argo.explain(dist(b,3),B); .print("then ", B);
                       argo.port(ttyACM0); argo.limit(5); argo.percepts(open).
        """).use { bob ->
            bob.perceives("dist(f,1)", "light(f,2)").shouldBelieve("dist(f,1)")
            bob.shouldPrint("first light(f,2) is kept: there is no filter")
            bob.shouldPrint("then dist(b,3) is dropped by filter onlyFront: it matches rule 2")
            bob.log.filter { it.startsWith("FINE light(f,2) is dropped by filter onlyFront: it matches rule 1") }.shouldNotBeEmpty()
            bob.log.filter { "SEVERE" in it }.shouldBeEmpty()
        }
        logger.level = null
    }

    test("an agent can ask why another percept stands, and a log level tells it too") {
        project.filter("steady", "<smooth annotate='true'><predicate>dist</predicate><parameter id='1' median='3'/></smooth>")
        val logger = Logger.getLogger("${Arch::class.java.name}.bob").apply { level = Level.FINE }
        project.agent("""
            !start.
            +!start <- argo.change_filter(steady); argo.port(ttyACM0); argo.limit(5); argo.percepts(open).
            +dist(f,40)[smoothed] <- .wait(50); argo.explain(dist(f,300),A); .print("why ", A).
        """).use { bob ->
            bob.perceives("dist(f,40)").shouldPrint("why dist(f,300) is replaced by filter steady: by smoothing rule 1")
            bob.perceives("dist(f,300)").shouldBelieve("dist(f,300)[smoothed]")
            bob.log.filter { it.startsWith("FINE dist(f,300) is replaced by filter steady") }.shouldNotBeEmpty()
        }
        logger.level = null
    }

    test("an agent with a board believes its environment's percepts beside the board's") {
        val hall = Environment()
        project.agent(start) { environment = hall }.use { bob ->
            hall.shows("weather(rain)")
            bob.perceives("dist(f,3)").shouldBelieve("weather(rain) & dist(f,3)")
            hall.shows("weather(sun)")
            bob.shouldBelieve("weather(sun) & dist(f,3) & not weather(rain)")
        }
    }
})
