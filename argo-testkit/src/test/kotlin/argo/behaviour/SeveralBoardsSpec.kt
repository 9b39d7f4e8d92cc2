package argo.behaviour

import argo.observing.AgentObserver
import argo.observing.AgentObserverProvider
import argo.observing.ObservedAgent
import argo.observing.PerceivedMessage
import argo.testkit.TestAgent
import argo.testkit.VirtualTime
import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.util.concurrent.atomic.AtomicInteger
import java.util.logging.Logger
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class SeveralBoardsSpec : FunSpec({
    val project = Project(tempdir().toPath())
    val leftAndRight = """
        !start.
        +!start <- argo.ports([port(ttyACM0,[as(left),baud(115200),boot(0)]), port(ttyACM1,[as(right),baud(115200),boot(0)])]);
            argo.limit(20); argo.percepts(open).
    """

    fun TestAgent.left() = board("ttyACM0")
    fun TestAgent.right() = board("ttyACM1")

    context("what boards say") {
        test("is believed in their namespaces, and events come and go there") {
            agentOf("""
                $leftAndRight
                +left::dist(f,X) <- argo.act(saw(X)).
                -left::dist(f,X) <- +gone(X).
                +B::bumped <- +bumped_at(B).
            """).use { bob ->
                bob.left().shows("dist(f,30)")
                bob.right().shows("dist(f,40)", "bumped")
                bob.shouldBelieve("left::dist(f,30) & right::dist(f,40) & right::bumped & not dist(_,_) & not left::bumped")
                bob.shouldSend("saw(30)").shouldBelieve("bumped_at(right)")
                bob.left().shows("dist(f,31)")
                bob.shouldSend("saw(31)").shouldBelieve("gone(30) & not left::dist(f,30)")
                bob.beliefs.filter { it.startsWith("gone") } shouldBe listOf("gone(30)")
            }
        }

        test("is one belief without namespaces, which stays until none of them says it") {
            agentOf("""
                !start.
                +!start <- argo.ports([ttyACM0, ttyACM1]); argo.limit(20); argo.percepts(open).
                +light(X) <- +lit(X).
                -light(X) <- +unlit(X).
            """).use { bob ->
                bob.left().shows("light(3)", "dist(1)")
                bob.right().shows("light(3)", "temp(20)")
                bob.shouldBelieve("light(3) & dist(1) & temp(20) & lit(3)")
                bob.left().shows("dist(2)")
                bob.shouldBelieve("light(3) & dist(2) & temp(20)").shouldNotBelieve("unlit(_)", during = 300.milliseconds)
                bob.right().shows("temp(20)")
                bob.shouldBelieve("not light(3) & unlit(3) & dist(2) & temp(20)")
            }
        }

        test("cannot be put into the namespace of another board") {
            agentOf(leftAndRight).use { bob ->
                bob.left().shows("right::dist(f,1)")
                bob.shouldBelieve("left::dist(f,1)").shouldNotBelieve("right::dist(_,_)", during = 100.milliseconds)
            }
        }

        test("has its namespace in the outcome of a reflex") {
            val near = """<critical reflex="stop"><predicate>dist</predicate><parameter id="1" operator="LT">15</parameter></critical>"""
            project.filter("careful", near)
            project.agent(leftAndRight.replace("argo.limit", "argo.change_filter(careful); argo.limit")).use { bob ->
                bob.left().shows("dist(f,30)")
                bob.right().shows("dist(f,9)")
                bob.shouldBelieve("right::reflex(stop,done) & not left::reflex(_,_) & not reflex(_,_)")
                bob.right().commands shouldBe listOf("stop")
                bob.left().commands shouldHaveSize 0
            }
        }
    }

    context("a module for a board") {
        test("is included once for each, and is of its board's percepts") {
            project.file("wheels.asl", """
                +dist(f,X) : X < 15 <- +near(X).
                -dist(f,X) <- +left_behind(X).
                +!report : dist(f,X) <- +reported(X).
            """)
            project.agent("""
                { include("wheels.asl", left) }
                { include("wheels.asl", right) }
                $leftAndRight
            """).use { bob ->
                bob.left().shows("dist(f,9)")
                bob.right().shows("dist(f,40)")
                bob.shouldBelieve("left::near(9) & right::dist(f,40)").shouldNotBelieve("right::near(_)", during = 100.milliseconds)
                bob.right().shows("dist(f,12)")
                bob.shouldBelieve("right::near(12) & right::left_behind(40) & not left::left_behind(_)")
                bob.hears("user", "achieve", "left::report").shouldBelieve("left::reported(9) & not right::reported(_)")
            }
        }

        test("waits for a percept of its board, or the event of one") {
            project.file("wheels.asl", """
                +!rest <- .wait(::touch(F)); +touched(F).
                +!stay <- .wait({+::touch(F)}); +felt(F).
            """)
            project.agent("""
                { include("wheels.asl", left) }
                { include("wheels.asl", right) }
                $leftAndRight
            """).use { bob ->
                for (goal in listOf("left::rest", "left::stay")) bob.hears("user", "achieve", goal)
                bob.right().shows("touch(1)")
                bob.shouldBelieve("right::touch(1)").shouldNotBelieve("left::touched(_) | left::felt(_)", during = 100.milliseconds)
                bob.left().shows("touch(2)")
                bob.shouldBelieve("left::touched(2) & left::felt(2)")
            }
        }
    }

    context("each board") {
        test("has an interval of its own, until all have the same again") {
            agentOf("$leftAndRight\n+!slow <- argo.limit(200,[port(ttyACM1)]). +!all <- argo.limit(50).").use { bob ->
                bob.shouldBelieve("port(ttyACM1,on)").hears("user", "achieve", "slow").after(1.seconds)
                var (left, right) = bob.left().requests.size to bob.right().requests.size
                bob.after(2.seconds)
                bob.left().requests.size - left shouldBeInRange 98..101
                bob.right().requests.size - right shouldBeInRange 9..11
                bob.hears("user", "achieve", "all").after(100.milliseconds)
                left = bob.left().requests.size
                right = bob.right().requests.size
                bob.after(2.seconds)
                bob.left().requests.size - left shouldBeInRange 39..41
                bob.right().requests.size - right shouldBeInRange 39..41
            }
        }

        test("has a filter of its own, until all have the same again, and is explained by it") {
            project.file("filters/noDist.json", """{"rules": [{"predicate": "dist"}]}""")
            project.agent("""
                $leftAndRight
                +!half <- argo.change_filter(noDist,[port(ttyACM1)]).
                +!none <- argo.change_filter(none).
                +!why <- argo.explain(left::dist(f,1), L); argo.explain(right::dist(f,1), R); +why(L,R).
            """).use { bob ->
                bob.left().shows("dist(f,1)")
                bob.right().shows("dist(f,2)")
                bob.shouldBelieve("left::dist(f,1) & right::dist(f,2)").hears("user", "achieve", "half")
                bob.shouldBelieve("left::dist(f,1) & not right::dist(_,_)").hears("user", "achieve", "why")
                bob.shouldBelieve("why(_,_)").beliefs.single { it.startsWith("why") }.let {
                    it.substringBefore("\",\"") shouldContain "kept"
                    it.substringAfter("\",\"") shouldContain "dropped"
                }
                bob.hears("user", "achieve", "none").shouldBelieve("right::dist(f,2)")
            }
        }

        test("has ages of its own, and the skew is the time between their readings") {
            agentOf("""
                $leftAndRight
                +!look <- argo.age(left::dist(f,_),L); argo.age(right::dist(f,_),R); argo.skew(S); +ages(L,R,S).
            """).use { bob ->
                bob.left().shows("dist(f,1)")
                bob.right().shows("dist(f,2)")
                bob.shouldBelieve("left::dist(f,1) & right::dist(f,2)").right().hangs()
                bob.after(200.milliseconds).hears("user", "achieve", "look")
                bob.shouldBelieve("ages(L,R,S) & L < 40 & R >= 190 & S >= 160 & S <= R")
            }
        }

        test("is perceived with the others' though its filter takes longer than theirs") {
            agentOf(leftAndRight) { options(SlowFilter.OPTION to "ttyACM1") }.use { bob ->
                bob.left().shows("dist(f,1)")
                bob.right().shows("dist(f,2)")
                bob.shouldBelieve("left::dist(f,1) & right::dist(f,2)").after(200.milliseconds)
                val before = SlowFilter.perceivedAlone.get()
                bob.after(2.seconds)
                SlowFilter.perceivedAlone.get() - before shouldBe 0
            }
        }

        test("is perceived again and again, though the agent is too slow for all of them") {
            val boards = 0 until 4
            val ports = boards.joinToString { "port(ttyACM$it,[as(b$it),baud(115200),boot(0)])" }
            val program = "!start.\n+!start <- argo.limit(20); argo.percepts(open); argo.ports([$ports]).\n+B::at(_)."
            agentOf(program) {
                cycleTime = 20.milliseconds
                board("ttyACM${boards.last}").opensAfter(1.seconds)
            }.use { bob ->
                for (i in boards) bob.board("ttyACM$i").shows { listOf("at(${it.inWholeMilliseconds})") }
                bob.after(2.seconds)
                repeat(10) {
                    bob.after(100.milliseconds)
                    val times = bob.beliefs.filter { "::at(" in it }.map { it.substringAfter("at(").substringBefore(')').toInt() }
                    times.size shouldBe boards.count()
                    times.max() - times.min() shouldBeLessThan 2 * boards.count() * 20
                }
            }
        }

        test("that is off counts for no skew") {
            agentOf("$leftAndRight\n+!look <- argo.skew(S); +skew(S).\n-!look[error(E)] <- +failed(E).").use { bob ->
                bob.shouldBelieve("port(ttyACM1,on)").after(100.milliseconds).right().disconnects()
                bob.shouldBelieve("port(ttyACM1,off)").after(500.milliseconds).hears("user", "achieve", "look").shouldBelieve("skew(0)")
                bob.left().disconnects()
                bob.shouldBelieve("port(ttyACM0,off)").hears("user", "achieve", "look").shouldBelieve("failed(not_perceived)")
            }
        }

        test("is stale in its time, alone") {
            agentOf(leftAndRight.replace("as(right)", "as(right),stale(300)")).use { bob ->
                bob.left().shows("dist(f,1)")
                bob.right().shows("dist(f,2)")
                bob.shouldBelieve("left::dist(f,1) & right::dist(f,2)").right().hangs()
                bob.shouldNotBelieve("stale(_)", during = 250.milliseconds).shouldBelieve("stale(ttyACM1)", within = 100.milliseconds)
                bob.shouldNotBelieve("stale(ttyACM0)")
                bob.right().recovers()
                bob.shouldBelieve("not stale(_) & port(ttyACM1,on)")
            }
        }

        test("keeps its filter, interval and namespace when its cable was out") {
            project.file("filters/noDist.json", """{"rules": [{"predicate": "dist"}]}""")
            project.agent("""
                $leftAndRight
                +!half <- argo.change_filter(noDist,[port(ttyACM1)]); argo.limit(200,[port(ttyACM1)]).
            """).use { bob ->
                bob.right().shows("dist(f,2)", "light(3)")
                bob.shouldBelieve("right::dist(f,2)").hears("user", "achieve", "half").shouldBelieve("not right::dist(_,_)")
                bob.right().disconnects()
                bob.shouldBelieve("port(ttyACM1,off)").right().reconnects()
                bob.right().shows("dist(f,2)", "light(4)")
                bob.shouldBelieve("right::light(4) & not right::dist(_,_)", within = 5.seconds)
                val asked = bob.right().requests.size
                bob.after(2.seconds)
                bob.right().requests.size - asked shouldBeInRange 9..11
            }
        }

        test("that is silent, hangs or is unplugged delays no other board's percepts") {
            agentOf("$leftAndRight\n+left::dist(f,X) <- argo.act(saw(X)).").use { bob ->
                bob.left().shows("dist(f,0)")
                bob.right().shows("dist(f,0)")
                bob.shouldSend("saw(0)").after(1.seconds)
                listOf<() -> Unit>({ bob.right().ignoresRequests() }, { bob.right().hangs() }, { bob.right().disconnects() })
                    .forEachIndexed { i, trouble ->
                        trouble()
                        repeat(10) { n ->
                            bob.left().shows("dist(f,${100 * (i + 1) + n})")
                            bob.shouldSend("saw(${100 * (i + 1) + n})", within = 40.milliseconds)
                        }
                    }
            }
        }
    }

    context("a command") {
        val asking = """
            $leftAndRight
            +!act(A) <- argo.act(A); +done(A).
            +!stop_right <- argo.act(right::stop); +done(stop).
            +!beep_left <- argo.act(left::beep); +done(beep).
            +!stop_arm <- argo.act(arm::stop).
            -!stop_arm[error(E),error_msg(M)] <- +failed(stop,E,M).
            +!act(A,P) <- argo.act(A,[port(P)]); +done(A).
            -!act(A)[error(E),error_msg(M)] <- +failed(A,E,M).
            -!act(A,P)[error(E),error_msg(M)] <- +failed(A,E,M).
        """

        fun described(left: Array<String>, right: Array<String>) = agentOf(asking) {
            board("ttyACM0").version2().knows(*left)
            board("ttyACM1").version2().knows(*right)
        }.after(3.seconds)

        test("goes to the board of its namespace, which is not sent") {
            agentOf(asking).use { bob ->
                bob.shouldBelieve("port(ttyACM1,on)").hears("user", "achieve", "stop_right").shouldBelieve("done(stop)")
                bob.right().commands shouldBe listOf("stop")
                bob.hears("user", "achieve", "stop_arm").shouldBelieve("failed(stop,unknown_board,_)")
                bob.beliefs.single { it.startsWith("failed") } shouldContain "there are left, right"
                bob.left().commands shouldHaveSize 0
            }
        }

        test("goes to the board on the port of its options, perceived or not") {
            agentOf("$asking +!one <- argo.port(ttyACM0).").use { bob ->
                bob.shouldBelieve("port(ttyACM1,on)").hears("user", "achieve", "act(stop,ttyACM1)").shouldBelieve("done(stop)")
                bob.hears("user", "achieve", "one").after(1.seconds).hears("user", "achieve", "act(go,ttyACM1)").shouldBelieve("done(go)")
                bob.right().commands shouldBe listOf("stop", "go")
                bob.hears("user", "achieve", "act(stop,ttyACM9)").shouldBelieve("failed(stop,unknown_board,_)")
            }
        }

        test("goes to the one board that has described itself with it, and to the port in use if none has") {
            described(arrayOf("beep", "turn/1"), arrayOf("beep", "grip/1")).use { bob ->
                bob.hears("user", "achieve", "act(grip(3))").shouldBelieve("done(grip(3))")
                bob.right().commands shouldBe listOf("grip(3)")
                bob.hears("user", "achieve", "act(fly)").shouldBelieve("failed(fly,act_refused,_)")
                bob.hears("user", "achieve", "act(beep)").shouldBelieve("failed(beep,ambiguous_action,_)")
                bob.beliefs.single { "ambiguous" in it } shouldContain "ttyACM0 and ttyACM1"
                bob.hears("user", "achieve", "beep_left").shouldBelieve("done(beep)")
                bob.left().commands shouldBe listOf("beep")
            }
        }

        test("of version 1 goes to the port in use") {
            agentOf(asking).use { bob ->
                bob.shouldBelieve("port(ttyACM1,on)").hears("user", "achieve", "act(stop)").shouldBelieve("done(stop)")
                bob.left().commands shouldBe listOf("stop")
            }
        }

        test("in a module goes to the board of the module, whatever the version") {
            project.file("wheels.asl", """
                +dist(f,X) : X < 15 <- argo.act(stop).
                +!halt <- argo.act(::stop).
                +!reverse <- argo.act(back).
            """)
            project.agent("""
                { include("wheels.asl", left) }
                { include("wheels.asl", right) }
                $leftAndRight
            """).use { bob ->
                bob.right().shows("dist(f,9)")
                bob.shouldSend("stop").right().commands shouldBe listOf("stop")
                bob.hears("user", "achieve", "right::halt").shouldSend("stop")
                bob.hears("user", "achieve", "right::reverse").shouldSend("back")
                bob.right().commands shouldBe listOf("stop", "stop", "back")
                bob.left().commands shouldHaveSize 0
            }
        }

        test("is asked for with argo.can, of one board or of any") {
            agentOf("""
                $leftAndRight
                +!all <- .findall(A, argo.can(A), As); .print(As).
                +!lefts <- .findall(left::A, argo.can(left::A), As); .print(As).
                +!who <- .findall(B, argo.can(B::beep), Bs); .print(Bs).
                +!one : argo.can(left::turn(_)) & not argo.can(right::turn(_)) & argo.can(turn(1)) & not argo.can(fly) <- +right_answers.
            """) {
                board("ttyACM0").version2().knows("beep", "turn/1")
                board("ttyACM1").version2().knows("beep")
            }.use { bob ->
                bob.after(3.seconds).hears("user", "achieve", "one").shouldBelieve("right_answers").hears("user", "achieve", "all")
                bob.shouldPrint("[beep,turn(_").hears("user", "achieve", "lefts").shouldPrint("[left::beep,left::turn(_")
                bob.hears("user", "achieve", "who").shouldPrint("[left,right]")
            }
        }

        test("to a board that is dead or slow holds up no percepts of another board") {
            agentOf("""
                $leftAndRight
                +left::dist(f,X) <- argo.act(right::turn(X)).
            """).use { bob ->
                bob.right().takes(10.seconds, "turn(0)")
                bob.left().shows("dist(f,0)")
                bob.right().shows("temp(1)")
                bob.shouldBelieve("right::temp(1) & left::dist(f,0)").after(1.seconds)
                for (n in 1..20) {
                    bob.left().shows("dist(f,$n)")
                    bob.shouldBelieve("left::dist(f,$n)", within = 150.milliseconds)
                }
            }
        }
    }

    context("what boards sense at one instant") {
        test("is mostly perceived together, though one answers later than the other") {
            agentOf("""
                $leftAndRight
                +left::n(X) : not right::n(X) <- +torn(X).
                +right::n(X) : not left::n(X) <- +torn(X).
            """).use { bob ->
                bob.after(1.seconds).left().shows { listOf("n(${(it.inWholeMilliseconds + 10) / 20})") }
                bob.right().shows { listOf("n(${(it.inWholeMilliseconds + 10) / 20})", "b(1)") }
                bob.after(500.milliseconds)
                val before = bob.beliefs.count { it.startsWith("torn") }
                bob.after(2.seconds).beliefs.count { it.startsWith("torn") } - before shouldBeInRange 0..20 // of 100 instants
            }
        }

        test("wakes the agent once, with the last answer") {
            agentOf(leftAndRight).use { bob ->
                bob.after(1.seconds).left().shows { listOf("n(${it.inWholeMilliseconds})") }
                bob.right().shows { listOf("n(${it.inWholeMilliseconds})", "b(1)") }
                bob.after(500.milliseconds)
                val before = bob.ts.agArch.cycleNumber
                bob.after(2.seconds).ts.agArch.cycleNumber - before shouldBeInRange 100..120 // for 100 instants
            }
        }

        test("is not waited for when a board misses its answers") {
            agentOf("$leftAndRight\n+left::n(X) <- argo.act(left::saw(X)).").use { bob ->
                bob.left().shows("n(0)")
                bob.right().shows("m(0)")
                bob.shouldSend("saw(0)").after(1.seconds).right().ignoresRequests()
                bob.after(1.seconds)
                for (n in 1..20) {
                    bob.left().shows("n($n)")
                    bob.shouldSend("saw($n)", within = 30.milliseconds)
                }
            }
        }
    }

    context("argo.ports with another list") {
        test("disturbs no board that is in both, and forgets what the others said") {
            agentOf("""
                $leftAndRight
                +!add <- argo.ports([ttyACM0, ttyACM1, port(ttyACM2,[as(arm),boot(0)])]).
                +!drop <- argo.ports([ttyACM0, ttyACM2]).
                -left::dist(_,_) <- +forgotten.
            """).use { bob ->
                bob.left().shows("dist(f,1)")
                bob.right().shows("dist(f,2)")
                bob.board("ttyACM2").shows("grip(open)").opensAfter(2.seconds)
                bob.shouldBelieve("left::dist(f,1) & right::dist(f,2)").after(1.seconds).hears("user", "achieve", "add")
                val asked = bob.left().requests.size
                bob.after(2.seconds).left().requests.size - asked shouldBeInRange 98..102
                bob.shouldBelieve("left::dist(f,1) & right::dist(f,2) & arm::grip(open)").hears("user", "achieve", "drop")
                bob.shouldBelieve("not right::dist(_,_)", within = 10.milliseconds)
                bob.shouldBelieve("left::dist(f,1) & arm::grip(open) & port(ttyACM1,on)").shouldNotBelieve("forgotten")
                bob.right().isOpen shouldBe true
                val unasked = bob.right().requests.size
                bob.after(1.seconds).right().requests.size - unasked shouldBeInRange 0..1
            }
        }

        test("has each board perceived as soon as its port is open, and goes on when all are") {
            agentOf("""
                +!start <- argo.percepts(open); argo.ports([port(ttyACM0,[as(left),boot(0)]), port(ttyACM1,[as(right),boot(0)])]); +all.
            """) { board("ttyACM1").opensAfter(3.seconds) }.use { bob ->
                bob.left().shows("dist(f,1)")
                bob.right().shows("dist(f,2)")
                bob.hears("user", "achieve", "start").shouldBelieve("left::dist(f,1) & not all")
                bob.shouldBelieve("right::dist(f,2) & all", within = 3.seconds)
            }
        }

        test("fails with the first board that is away, and perceives the others") {
            agentOf("""
                +!start <- argo.percepts(open); argo.ports([port(ttyACM0,[as(left),boot(0)]), ttyACM1, ttyACM2]).
                -!start[error(E),error_msg(M)] <- +failed(E,M).
            """).use { bob ->
                bob.left().shows("dist(f,1)")
                bob.right().disconnects()
                bob.board("ttyACM2").disconnects()
                bob.hears("user", "achieve", "start").shouldBelieve("failed(no_such_port,_) & left::dist(f,1)")
                bob.shouldBelieve("port(ttyACM0,on) & port(ttyACM1,off) & port(ttyACM2,off)")
                bob.beliefs.single { it.startsWith("failed") }.let {
                    it shouldContain "2 of 3 ports"
                    it shouldContain "ttyACM1"
                    it shouldContain "ttyACM2"
                }
            }
        }

        test("changes nothing if none can be opened") {
            agentOf("""
                !start.
                +!start <- argo.port(ttyACM0,[boot(0)]); argo.percepts(open); argo.ports([ttyACM1, ttyACM2]).
                -!start[error(E)] <- +failed(E).
            """) {
                board("ttyACM1").disconnects()
                board("ttyACM2").disconnects()
            }.use { bob ->
                bob.left().shows("dist(f,1)")
                bob.shouldBelieve("failed(no_such_port) & dist(f,1)")
                bob.left().shows("dist(f,2)")
                bob.shouldBelieve("dist(f,2)")
            }
        }

        test("takes another namespace without opening the port anew") {
            agentOf("""
                !start.
                +!start <- argo.port(ttyACM0,[as(left),boot(2000)]); argo.limit(20); argo.percepts(open).
                +!rename <- argo.port(ttyACM0,[as(right),boot(2000)]).
            """).use { bob ->
                bob.left().shows("dist(f,1)")
                bob.shouldBelieve("left::dist(f,1)", within = 3.seconds).hears("user", "achieve", "rename")
                bob.shouldBelieve("right::dist(f,1) & not left::dist(_,_)", within = 100.milliseconds)
            }
        }

        test("is not understood unless it is a list of ports") {
            for (wrong in listOf("[]", "ttyACM0", "[none]", "[port(ttyACM0,left)]", "[f(X)]", "[port(ttyACM0,[as(\"left\")])]")) {
                agentOf("!start.\n+!start <- argo.ports($wrong).\n-!start[error(E)] <- +failed(E).").use { bob ->
                    bob.shouldBelieve("failed(wrong_arguments)")
                }
            }
        }
    }

    test("argo.port perceives the board on that port alone") {
        agentOf("$leftAndRight\n+!one <- argo.port(ttyACM1).").use { bob ->
            bob.left().shows("dist(f,1)")
            bob.right().shows("dist(f,2)")
            bob.shouldBelieve("left::dist(f,1) & right::dist(f,2)").hears("user", "achieve", "one")
            bob.shouldBelieve("right::dist(f,2) & not left::dist(_,_)", within = 100.milliseconds)
        }
    }

    test("a limit or a filter for a board that the agent does not have fails") {
        agentOf("""
            $leftAndRight
            +!limit <- argo.limit(20,[port(ttyACM7)]).
            -!limit[error(E)] <- +limit(E).
            +!filter <- argo.change_filter(none,[port(ttyACM7)]).
            -!filter[error(E),error_msg(M)] <- +filter(E,M).
        """).use { bob ->
            bob.shouldBelieve("port(ttyACM1,on)").hears("user", "achieve", "limit").shouldBelieve("limit(unknown_board)")
            bob.hears("user", "achieve", "filter").shouldBelieve("filter(unknown_board,_)")
            bob.beliefs.single { it.startsWith("filter") } shouldContain "ttyACM0, ttyACM1"
        }
    }
})

/** Makes the filter of one board take a millisecond. Counts the cycles that perceive only one board. */
internal class SlowFilter(private val port: String) : AgentObserver {
    private var perceived = 0

    override fun messageFiltered(message: PerceivedMessage) {
        val time = VirtualTime.active() ?: return
        if (message.portName == port) time.block(time.nanos() + 1.milliseconds.inWholeNanoseconds, interruptible = false) { false }
    }

    override fun messagePerceived(message: PerceivedMessage) {
        perceived++
    }

    override fun cycleFinished() {
        if (perceived == 1) perceivedAlone.incrementAndGet()
        perceived = 0
    }

    override fun close() = Unit

    companion object {
        const val OPTION = "argo_slow_filter"

        val perceivedAlone = AtomicInteger()
    }
}

internal class SlowFilterProvider : AgentObserverProvider {
    override val option = SlowFilter.OPTION
    override val usage = "a port"
    override fun open(value: String, agent: ObservedAgent, log: Logger) = SlowFilter(value)
}
