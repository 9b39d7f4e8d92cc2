package argo.behaviour

import argo.testkit.TestAgent
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.ASSyntax
import jason.environment.Environment
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class CriticalSpec : FunSpec({
    val project = Project(tempdir().toPath())
    val near = """<critical reflex="stop"><predicate>dist</predicate><parameter id="1" operator="LT">15</parameter></critical>"""
    fun start(options: String = "baud(115200)") =
        "!start.\n+!start <- argo.port(ttyACM0, [$options]); argo.limit(10); argo.change_filter(careful); argo.percepts(open)."

    fun TestAgent.reflexes() = board.commands.count { it == "stop" }
    fun TestAgent.isTo(goal: String) = hears("user", "achieve", goal)

    test("its plan runs before the hundreds of events that wait") {
        project.filter(
            "careful",
            near.replace(" reflex=\"stop\"", "") + "<filter><predicate>light</predicate></filter>",
        )
        val rooms = Environment()
        var nearAt = Duration.INFINITE
        project.agent("""
            ${start()}
            +dist(f,X) : X < 15 <- .count(handled(_), N); argo.act(stop_after(N)).
            +dist(f,X) <- +sees.
            +room(I) : not held <- argo.behaviour.busy(500); +held; +handled(I).
            +room(I) <- +handled(I).
        """) {
            environment = rooms
            board.shows { at -> listOf("dist(f,${if (at < nearAt) 90 else 9})", "light(${at.inWholeMilliseconds})") }
        }.use { bob ->
            nearAt = bob.shouldBelieve("sees").now + 200.milliseconds
            repeat(500) { rooms.addPercept(ASSyntax.parseLiteral("room(${it + 1})")) }
            rooms.informAgsEnvironmentChanged()
            bob.after(400.milliseconds)
            val handled = bob.shouldBelieve("dist(f,9)").after(100.milliseconds).sent.single { it.startsWith("stop_after") }
            Regex("\\d+").find(handled)!!.value.toInt() shouldBeLessThan 20
            bob.shouldBelieve(".count(handled(_), 500)")
        }
    }

    test("a reflex goes out while the agent is busy, once while its rule stays met, and again when it begins anew") {
        project.filter("careful", "$near<filter><predicate>dist</predicate></filter>")
        val stops = sortedMapOf<Duration, Int>() // the number of stops at each request
        project.agent("""
            ${start()}
            +light(_) : not held <- +held; argo.behaviour.busy(2000); +free.
            +dist(f,9) <- +saw_it.
        """) {
            board.shows { at ->
                stops[at] = board.commands.count { it == "stop" }
                val cm = if (at < 1.seconds) 90 else if (at < 1.3.seconds) 9 else if (at < 1.6.seconds) 80 else 8
                listOf("dist(f,$cm)", "light(${at.inWholeMilliseconds})")
            }
        }.use { bob ->
            bob.shouldBelieve("held & free", within = 3.seconds).shouldNotBelieve("dist(f,9)", during = 0.seconds)
            stops.headMap(1.seconds).values.toSet() shouldBe setOf(0)
            stops.subMap(1.1.seconds, 1.6.seconds).values.toSet() shouldBe setOf(1)
            stops.tailMap(1.7.seconds).values.toSet() shouldBe setOf(2)
            bob.perceives("dist(f,9)").shouldBelieve("saw_it").reflexes() shouldBe 2 // the rule sees dist, although the filter drops it
        }
    }

    test("a reflex goes before commands that wait") {
        project.filter("careful", near)
        project.agent("""
            ${start()}
            +!wander <- for (.range(I,1,300)) { !!walk(I) }.
            +!walk(I) <- argo.act(walk(I)).
        """).use { bob ->
            bob.perceives("dist(f,90)").isTo("wander").shouldSend("walk(1)")
            bob.board.shows("dist(f,9)")
            bob.shouldSend("stop", within = 100.milliseconds)
            bob.sent shouldNotContain "walk(100)"
            bob.shouldSend("walk(300)", within = 60.seconds).reflexes() shouldBe 1
        }
    }

    test("a reflex that a board refuses is told once, and sensing goes on") {
        project.filter("careful", near)
        project.agent("${start("baud(115200), protocol(2)")}\n+dist(f,X) : X < 15 <- argo.act(saw(X)).") {
            board.version2().refuses("stop")
        }.use { bob ->
            for (cm in listOf(90, 9, 90, 8, 90, 7)) {
                bob.perceives("dist(f,$cm)")
                if (cm < 15) bob.shouldSend("saw($cm)")
            }
            bob.reflexes() shouldBe 3
            bob.log.count { "the reflex stop of the critical rule" in it } shouldBe 1
            bob.log.joinToString("\n") shouldContain "refuses \"stop\""
            bob.beliefs shouldContain "port(ttyACM0,on)"
            bob.beliefs shouldContain "reflex(stop,failed)"
        }
    }

    test("a filter that keeps other functors has a board of version 2 asked for critical ones too") {
        project.filter("careful", "$near<filter><predicate>light</predicate></filter>", "keep=\"true\"")
        project.agent("${start("baud(115200), protocol(2)")}\n+dist(f,X) <- argo.act(saw(X)).") { board.version2() }.use { bob ->
            bob.perceives("dist(f,90)", "light(1)").shouldNotSend("saw(90)")
            bob.board.requests.takeLast(3) shouldBe List(3) { "getPercepts(light,dist)" }
            bob.perceives("dist(f,9)", "light(1)").shouldSend("saw(9)").shouldSend("stop").shouldSendNothingElse()
        }
    }

    test("without its filter, or while perceiving is blocked, no reflex is sent") {
        project.filter("careful", near)
        project.agent("""
            ${start()}
            +!off <- argo.change_filter(none).
            +!blocked <- argo.percepts(block); argo.change_filter(careful).
            +!open <- argo.percepts(open).
        """).use { bob ->
            bob.perceives("dist(f,90)").isTo("off").perceives("dist(f,9)").shouldBelieve("dist(f,9)").shouldSendNothingElse()
            bob.isTo("blocked").shouldSendNothingElse()
            bob.isTo("open").shouldSend("stop")
        }
    }

    test("under in_cycle its reflex is sent too") {
        project.filter("careful", near)
        project.agent(start()) { options("argo_sensing" to "in_cycle") }.use { bob ->
            bob.perceives("dist(f,90)").perceives("dist(f,9)").shouldSend("stop").shouldSendNothingElse()
        }
    }
})
