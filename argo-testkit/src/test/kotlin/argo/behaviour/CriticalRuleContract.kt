package argo.behaviour

import argo.testkit.Board
import argo.testkit.TestAgent
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/**
 * The behaviour of critical rules, whether the board or the computer checks them.
 *
 * @param watcher the side that checks the rules, as `argo.explain` names it
 * @param canRefuse true if the board reports refused commands
 * @param setUp makes the board
 */
abstract class CriticalRuleContract(watcher: String, canRefuse: Boolean = true, setUp: Board.() -> Unit) : FunSpec({
    val project = Project(tempdir().toPath())
    val near = """<critical reflex="stop"><predicate>dist</predicate><parameter id="1" operator="LT">15</parameter></critical>"""
    val hot = """<critical reflex="fan(on)"><predicate>temp</predicate><parameter id="0" operator="GE">80.5</parameter></critical>"""
    project.filter("careful", near)
    project.filter("careful2", "$near$hot<filter><predicate>light</predicate></filter>")
    project.filter("relaxed", "<filter><predicate>light</predicate></filter>")

    fun TestAgent.isTo(goal: String) = hears("user", "achieve", goal)
    fun TestAgent.count(command: String) = board.commands.count { it == command }

    /** Starts an agent with the filter `careful`. Waits until board and computer have settled its rules. */
    fun bob(filter: String = "careful") = project.agent("""
        !start.
        +!start <- argo.port(ttyACM0, [baud(115200)]); argo.limit(20); argo.change_filter($filter); argo.percepts(open).
        +!filter(F) <- argo.change_filter(F).
        +!percepts(W) <- argo.percepts(W).
        +!explain(P) <- argo.explain(P, Why); .print(Why).
        +dist(f,X) <- +saw(X).
    """) {
        board.setUp()
        board.shows("dist(f,90)", "temp(20)")
    }.apply { shouldBelieve("saw(90)", within = 5.seconds).after(300.milliseconds) }

    test("a reflex is carried out once when its rule begins to be met, and again when it begins anew") {
        bob().use { bob ->
            bob.board.shows("dist(f,9)", "temp(20)")
            bob.shouldBelieve("reflex(stop,done)", within = 100.milliseconds).after(500.milliseconds).count("stop") shouldBe 1
            bob.board.shows("dist(f,8)", "temp(20)")
            bob.after(500.milliseconds).count("stop") shouldBe 1
            bob.board.shows("dist(f,80)", "temp(20)")
            bob.after(200.milliseconds).beliefs shouldNotContain "reflex(stop,done)"
            bob.board.shows("dist(f,7)", "temp(20)")
            bob.shouldBelieve("reflex(stop,done)", within = 100.milliseconds).count("stop") shouldBe 2
        }
    }

    test("the agent perceives the critical percept") {
        bob().use { bob ->
            bob.board.shows("dist(f,9)", "temp(20)")
            bob.shouldBelieve("saw(9) & dist(f,9) & temp(20)", within = 200.milliseconds)
            bob.beliefs shouldNotContain "dist(f,90)"
        }
    }

    test("each of several rules has its reflex") {
        bob("careful2").use { bob ->
            bob.board.shows("dist(f,90)", "temp(80.5)")
            bob.shouldBelieve("reflex(fan(on),done) & not reflex(stop,_)", within = 200.milliseconds)
            bob.board.shows("dist(f,9)", "temp(80.5)")
            bob.shouldBelieve("reflex(fan(on),done) & reflex(stop,done)", within = 200.milliseconds).after(300.milliseconds)
            bob.board.commands.sorted() shouldBe listOf("fan(on)", "stop")
        }
    }

    test("a rule that stays in the filter stays met when the filter changes, and one that goes has no reflex any more") {
        bob().use { bob ->
            bob.board.shows("dist(f,9)", "temp(20)")
            bob.shouldBelieve("reflex(stop,done)").isTo("filter(careful2)").after(500.milliseconds).count("stop") shouldBe 1
            bob.beliefs shouldContain "reflex(stop,done)"
            bob.isTo("filter(relaxed)").after(500.milliseconds).beliefs shouldNotContain "reflex(stop,done)"
            bob.board.shows("dist(f,90)", "temp(20)")
            bob.after(200.milliseconds).board.shows("dist(f,9)", "temp(99)")
            bob.after(500.milliseconds).board.commands shouldBe listOf("stop")
        }
    }

    test("a rule that is met when it becomes active has its reflex, at the change perhaps twice") {
        bob("relaxed").use { bob ->
            bob.board.shows("dist(f,9)", "temp(20)")
            bob.after(300.milliseconds).isTo("filter(careful)").shouldBelieve("reflex(stop,done)").after(500.milliseconds)
            bob.count("stop") shouldBeInRange 1..2
        }
    }

    test("while perceiving is blocked there are no reflexes and no beliefs about them") {
        bob().use { bob ->
            bob.board.shows("dist(f,9)", "temp(20)")
            bob.shouldBelieve("reflex(stop,done)").isTo("percepts(block)").after(300.milliseconds)
            bob.beliefs shouldNotContain "reflex(stop,done)"
            bob.board.shows("dist(f,90)", "temp(20)")
            bob.after(200.milliseconds).board.shows("dist(f,9)", "temp(20)")
            bob.after(300.milliseconds).count("stop") shouldBe 1
            bob.isTo("percepts(open)").shouldBelieve("reflex(stop,done)").after(500.milliseconds).count("stop") shouldBeInRange 2..3
        }
    }

    if (canRefuse) test("a reflex that the board refuses is believed to have failed, and is not tried again while its rule stays met") {
        bob().use { bob ->
            bob.board.refuses("stop").shows("dist(f,9)", "temp(20)")
            bob.shouldBelieve("reflex(stop,failed)", within = 200.milliseconds).after(500.milliseconds).count("stop") shouldBe 1
            bob.log.count { "the reflex stop of the critical rule" in it } shouldBe 1
        }
    }

    test("the filter may change while a reflex is under way") {
        bob().use { bob ->
            bob.board.takes(100.milliseconds, "stop").shows("dist(f,9)", "temp(20)")
            bob.after(30.milliseconds).isTo("filter(careful2)").isTo("filter(relaxed)").isTo("filter(careful)")
            bob.shouldBelieve("reflex(stop,done)", within = 2.seconds).after(1.seconds).count("stop") shouldBeInRange 1..3
            bob.beliefs shouldContain "reflex(stop,done)"
        }
    }

    test("argo.explain tells who watches the rule") {
        bob().use { bob ->
            bob.isTo("explain(dist(f,3))").after(50.milliseconds)
            bob.printed.last() shouldContain "it matches critical rule 1: dist where argument 1 is less than 15"
            bob.printed.last() shouldContain "; $watcher watches it"
            bob.isTo("explain(dist(f,30))").after(50.milliseconds).printed.last().contains("watches") shouldBe false
        }
    }

    test("after a restart of the board its rules are watched again") {
        bob().use { bob ->
            bob.board.disconnects()
            bob.shouldBelieve("port(ttyACM0,off)", within = 3.seconds).board.reconnects()
            bob.shouldBelieve("port(ttyACM0,on)", within = 5.seconds).after(2.seconds)
            bob.board.shows("dist(f,9)", "temp(20)")
            bob.shouldBelieve("reflex(stop,done)", within = 200.milliseconds).count("stop") shouldBe 1
            bob.isTo("explain(dist(f,3))").after(50.milliseconds).printed.last() shouldContain "; $watcher watches it"
        }
    }
})

class BoardWatchesSpec : CriticalRuleContract("the board", setUp = { version2().holdsRules(8) })

class BoardWatchesOneRuleSpec : CriticalRuleContract("the board", setUp = { version2().holdsRules(1) })

class ComputerWatchesSpec : CriticalRuleContract("the computer", setUp = { version2() })

class ComputerWatchesVersion1Spec : CriticalRuleContract("the computer", canRefuse = false, setUp = { })
