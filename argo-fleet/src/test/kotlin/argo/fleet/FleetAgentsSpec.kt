package argo.fleet

import argo.fleet.cluster.Overloaded
import argo.fleet.cluster.Refused
import argo.fleet.cluster.Unreachable
import argo.fleet.node.FleetMessage
import argo.fleet.node.Kill
import argo.fleet.node.Offer
import argo.fleet.node.RosterNews
import argo.fleet.node.Say
import argo.fleet.node.Stop
import argo.fleet.node.Unanswered
import argo.observing.AgentThere
import argo.observing.ObservedComputer
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSemantics.Message
import jason.infra.local.LocalAgArch
import java.util.concurrent.CopyOnWriteArrayList
import kotlin.math.abs
import kotlin.time.Duration.Companion.seconds

/** Agents of one computer of a fleet. The test plays the other computers. */
class FleetAgentsSpec : FunSpec({
    fun whole(vararg agents: String) = RosterNews(isWhole = true, came = agents.toSet())

    /** Makes the computer `base` with an agent `a`, which gets the goal `go` on request, and `scout1` with the agent `b`. */
    suspend fun computer(program: String, options: String = "", also: OneComputer.() -> Unit = {}, test: suspend OneComputer.() -> Unit) =
        OneComputer("a $options at \"base\"; late at \"scout2\";", "a" to "$program\n+failed(E)[source(self)].").use {
            it.cluster.view("scout1" to "1")
            it.cluster.receives("scout1", whole("b"))
            it.also()
            it.cluster.receives("scout1", Say("mid1", null, "achieve", "b", "a", "go"))
            it.test()
        }

    context("a message to another computer") {
        test("keeps its content, and the plan goes on when it has been taken") {
            computer("+!go <- .send(b, tell, x::p(\"q\\\"\",1.5,[X])[e]); +done.") {
                val sent = cluster.next()
                sent.to shouldBe "scout1"
                (sent.message as Say).run {
                    listOf(force, from, to) shouldBe listOf("tell", "a", "b")
                    content shouldContain "x::p(\"q\\\"\",1.5,["
                }
                believed("a") shouldNotContain "done[source(self)]"
                sent.end.complete(null)
                shouldBelieve("a", "done[source(self)]")
            }
        }

        test("that has not arrived fails the plan with unreachable") {
            computer("+!go <- .send(b, tell, x). -!go[error(E)] <- +failed(E).") {
                cluster.next().end.completeExceptionally(Unreachable("scout1 is off"))
                shouldBelieve("a", "failed(unreachable)[source(self)]")
            }
        }

        test("fails with no_agent if the agent is not there any more, which is also the error of one computer") {
            computer("+!go <- .send(b, tell, x). -!go[error(no_agent),error(receiver_not_found)] <- +failed(both).") {
                cluster.next().end.completeExceptionally(Refused("no_agent", "there is no agent b on scout1"))
                shouldBelieve("a", "failed(both)[source(self)]")
            }
        }

        test("that is refused fails the plan with the error of the refusal") {
            computer("+!go <- .send(b, tell, x). -!go[error(E),error_msg(M)] <- +failed(E); +told(M).") {
                cluster.next().end.completeExceptionally(Refused("moved", "a runs on another computer now"))
                shouldBelieve("a", "failed(moved)[source(self)]", "told(\"a runs on another computer now\")[source(self)]")
            }
        }

        test("fails at once with no_agent if no computer has the agent, and with unreachable if its computer is off") {
            val program = "+!go <- !say(nobody); !say(late); !say(guest). " +
                "+!say(To) <- .send(To, tell, x). -!say(To)[error(E)] <- +failed(To,E)."
            computer(program, also = {
                cluster.view("scout1" to "1", "scout2" to "1")
                cluster.receives("scout2", whole("guest"))
                cluster.view("scout1" to "1")
            }) {
                shouldBelieve(
                    "a", "failed(nobody,no_agent)[source(self)]", "failed(late,unreachable)[source(self)]",
                    "failed(guest,unreachable)[source(self)]",
                )
            }
        }

        test("may hold a plan, and fails with not_sendable if it holds a Java object") {
            computer("+!go <- .send(b, tell, {+!g <- +h}); .queue.create(Q); .send(b, tell, Q). -!go[error(E)] <- +failed(E).") {
                cluster.next().end.complete(null)
                shouldBelieve("a", "failed(not_sendable)[source(self)]")
            }
        }

        test("of megabytes that cannot go is shown in the error by its beginning") {
            val program = "+!go <- !tell(\"${"x".repeat(100_000)}\"). +!tell(X) <- .send(nobody, tell, p(X)). " +
                "-!tell(_)[error_msg(M)] <- .length(M,L); +length(L)."
            computer(program) {
                eventually(60.seconds) {
                    val length = believed("a").single { it.startsWith("length") }
                    length.removePrefix("length(").substringBefore(")").toInt() shouldBeLessThan 700
                }
            }
        }

        test("to several agents waits for all of them, and does not hold up other intentions") {
            computer("+!go <- .send([b,b], tell, x); +done. +!other <- +meanwhile.") {
                val (first, second) = cluster.next() to cluster.next()
                first.end.complete(null)
                cluster.receives("scout1", Say("mid2", null, "achieve", "b", "a", "other"))
                shouldBelieve("a", "meanwhile[source(self)]")
                believed("a") shouldNotContain "done[source(self)]"
                second.end.complete(null)
                shouldBelieve("a", "done[source(self)]")
            }
        }
    }

    context("of messages of one action that do not arrive, each that fails no plan is told in the log") {
        test("whether the action goes on behind them") {
            computer("+!go <- .send([b,c], tell, x). -!go[error_msg(M)] <- +failed(M).", also = {
                cluster.view("scout1" to "1", "scout2" to "1")
                cluster.receives("scout2", whole("c"))
            }) {
                cluster.next().end.completeExceptionally(Unreachable("b is lost"))
                cluster.next().end.completeExceptionally(Unreachable("c is lost"))
                shouldBelieve("a", "failed(\"b is lost\")[source(self)]")
                shouldLog("a message to c has not arrived: c is lost")
            }
        }

        test("or not") {
            computer("+!go <- .send([b,nobody], tell, x). -!go[error(E)] <- +failed(E).") {
                cluster.next().end.completeExceptionally(Unreachable("b is lost"))
                shouldBelieve("a", "failed(no_agent)[source(self)]")
                shouldLog("a message to b has not arrived: b is lost")
            }
        }
    }

    context("a question to another computer") {
        val program = "+!go <- .send(b, askOne, p(X), A); +got(A). -!go[error(E)] <- +failed(E)."

        test("is answered") {
            computer(program) {
                val sent = cluster.next()
                sent.end.complete(null)
                val asked = sent.message as Say
                cluster.receives("scout1", Say("mid9", asked.id, "tell", "b", "a", "p(7)[source(self)]"))
                eventually(60.seconds) { believed("a").filter { it.startsWith("got(p(7)") }.size shouldBe 1 }
            }
        }

        test("fails if it does not arrive") {
            computer(program) {
                cluster.next().end.completeExceptionally(Unreachable("off"))
                shouldBelieve("a", "failed(unreachable)[source(self)]")
            }
        }

        test("fails if that computer goes off before it has answered") {
            computer(program) {
                cluster.next().end.complete(null)
                cluster.view()
                shouldBelieve("a", "failed(unreachable)[source(self)]")
            }
        }

        test("fails if the asked agent ends before it has answered") {
            computer(program) {
                cluster.next().end.complete(null)
                cluster.receives("scout1", RosterNews(gone = setOf("b")))
                shouldBelieve("a", "failed(unreachable)[source(self)]")
            }
        }

        test("fails with the reason why the answer does not arrive, and without an intention that waits the log tells it") {
            computer(program) {
                val sent = cluster.next()
                sent.end.complete(null)
                val asked = (sent.message as Say).id.orEmpty()
                cluster.receives("scout1", Unanswered(asked, "a", "not_sendable", "b has answered in vain: it is a Java object"))
                shouldBelieve("a", "failed(not_sendable)[source(self)]")
                cluster.receives("scout1", Unanswered("mid7", "a", "overloaded", "b has answered in vain: it is too long"))
                shouldLog("a question gets no answer: b has answered in vain: it is too long")
                cluster.receives("scout1", Unanswered("mid8", "nobody", "overloaded", "b has answered in vain"))
            }
        }

        test("has another number than those of the program's last run, whose answers may still come") {
            val numbers = List(2) { OneComputer("a at \"base\";", "a" to "").use { Message("tell", "a", "b", "x").msgId } }
            numbers.map { it.removePrefix("mid").toInt() }.let { (first, second) -> abs(first - second) shouldBeGreaterThan 1000 }
        }

        test("whose time is over ends with that, and no failure of its computer fails it any more") {
            computer("+!go <- .send(b, askOne, p(X), A, 10); +got(A). -!go <- +failed.") {
                cluster.next().end.complete(null)
                shouldBelieve("a", "got(timeout)[source(self)]")
                cluster.view()
                cluster.view("scout1" to "1")
                believed("a") shouldNotContain "failed[source(self)]"
            }
        }

        test("fails for good behind one that could not be asked: its late answer ends nothing") {
            val asking = "+!go <- !!stay; !ask(nobody); !ask(b). +!ask(To) <- .send(To, askOne, p(X), A); +got(A). " +
                "-!ask(To)[error(E)] <- +failed(To,E). +!stay <- .wait({+told}); +stayed."
            computer(asking) {
                val sent = cluster.next()
                sent.end.complete(null)
                cluster.view()
                shouldBelieve("a", "failed(nobody,no_agent)[source(self)]", "failed(b,unreachable)[source(self)]")
                cluster.view("scout1" to "1")
                cluster.receives("scout1", Say("mid9", (sent.message as Say).id, "tell", "b", "a", "p(7)"))
                cluster.receives("scout1", Say("mid10", null, "tell", "b", "a", "told"))
                shouldBelieve("a", "stayed[source(self)]")
                believed("a").filter { it.startsWith("got") } shouldBe emptyList()
            }
        }

        test("fails once if there is no such agent, and nothing is left that waits") {
            computer("+!go <- .send(nobody, askOne, p(X), A); +got(A). -!go[error(E)] <- ?n(N); -+n(N+1); +failed(E). n(0).") {
                shouldBelieve("a", "failed(no_agent)[source(self)]", "n(1)[source(self)]")
            }
        }
    }

    context("a message from another computer") {
        test("becomes a belief with its source, its variables are not the receiver's, and a question is answered there") {
            computer("p(7).") {
                cluster.receives("scout1", Say("mid2", null, "tell", "b", "a", "n::told(\"x\")[extra]"))
                eventually(60.seconds) {
                    believed("a").filter { it.startsWith("n::told(\"x\")") && "source(b)" in it && "extra" in it }.size shouldBe 1
                }
                cluster.receives("scout1", Say("samid5", null, "askOne", "b", "a", "p(X)"))
                (cluster.next().message as Say).run {
                    inReplyTo shouldBe "samid5"
                    content shouldContain "p(7)"
                }
            }
        }

        test("keeps equal variables equal and others apart, whatever numbers Jason has counted on the other computer") {
            computer("+!kqml_received(_,tell,p(N,A,B,C),_) <- A = 1; B = 2; +got(N,A,B,C).") {
                for ((number, variables) in listOf("_99999999,_99999998,_99999999", "_1,_2,_1", "_3,_2,_3", "X,_7,X").withIndex()) {
                    cluster.receives("scout1", Say("mid2", null, "tell", "b", "a", "p($number,$variables)"))
                    shouldBelieve("a", "got($number,1,2,1)[source(self)]")
                }
            }
        }

        test("brings a plan whose label, which Jason has made, another plan here has; the program's own labels stay") {
            computer("+!go <- +done. +!mine <- +mine.") {
                shouldBelieve("a", "done[source(self)]")
                fun plan(label: String, goal: String) = "#plan(0,\"\",#none,#pred($label),#event(0,add,achieve,#none,$goal),#none,#none," +
                    "#body(0,addBel,#none,$goal))"
                val labels = planLabels("a")
                val taken = labels.first { it.matches(Regex("[lp]__[0-9]+")) }
                cluster.receives("scout1", Say("mid2", null, "tellHow", "b", "a", "[${plan(taken, "one")},${plan("two_label", "two")}]"))
                eventually(60.seconds) { planLabels("a") shouldContain "two_label" }
                cluster.receives("scout1", Say("mid3", null, "achieve", "b", "a", "one"))
                cluster.receives("scout1", Say("mid4", null, "achieve", "b", "a", "two"))
                shouldBelieve("a", "one[source(self)]", "two[source(self)]")
                planLabels("a").toSet().size shouldBe labels.size + 2
            }
        }

        test("whose answer does not arrive is told in the log, since Jason's own plans send it, and to the asker") {
            val told = CopyOnWriteArrayList<FleetMessage>()
            computer("p(7). +!make <- .queue.create(Q); +object(Q).", also = {
                cluster.answer = { one ->
                    told += one.message
                    one.end.complete(null)
                }
            }) {
                cluster.receives("scout1", Say("samid5", null, "askOne", "b", "a", "p(X)"))
                cluster.next().end.completeExceptionally(Overloaded("it is too long"))
                shouldLog("a message to b has not arrived: it is too long")
                eventually(60.seconds) {
                    told shouldContain Unanswered("samid5", "b", "overloaded", "a has answered in vain: it is too long")
                }
                cluster.receives("scout1", Say("mid6", null, "achieve", "b", "a", "make"))
                eventually(60.seconds) { believed("a").filter { it.startsWith("object") }.size shouldBe 1 }
                cluster.receives("scout1", Say("samid6", null, "askOne", "b", "a", "object(X)"))
                eventually(60.seconds) {
                    told.filterIsInstance<Unanswered>().map { it.question to it.error } shouldContain ("samid6" to "not_sendable")
                }
            }
        }

        test("to an agent that is not here, one that cannot be read, and garbage are refused") {
            computer("") {
                fun error(act: () -> Unit) = shouldThrow<Refused> { act() }.error
                error { cluster.receives("scout1", Say("mid2", null, "tell", "b", "nobody", "x")) } shouldBe "no_agent"
                error { cluster.receives("scout1", Say("mid2", null, "tell", "b", "a", "p(")) } shouldBe "not_readable"
                error { cluster.receives("scout1", Say("mid2", null, "tell", "b", "a", "f(".repeat(100_000))) } shouldBe "not_readable"
                error { cluster.receives("scout1", byteArrayOf(7)) } shouldBe "not_readable"
                shouldLog("a message of scout1 is refused: it is of format 7")
                shouldLog("a message of b cannot be read and is refused")
                cluster.receives("scout1", Say("mid3", null, "tell", "b", "a", "still"))
                eventually(60.seconds) { believed("a") shouldContain "still[source(b)]" }
            }
        }
    }

    test("a message of an agent that the sending computer does not have is refused, and told") {
        computer("") {
            shouldThrow<Refused> { cluster.receives("scout1", Say("mid2", null, "tell", "late", "a", "x")) }.error shouldBe "not_sender"
            shouldLog("a message of late is refused: it comes from scout1, which has no such agent")
        }
    }

    test("names are those of all computers in touch, and broadcasts go to all of them") {
        computer("+!go <- .all_names(L); +names(L); .broadcast(tell, hello); +done.") {
            val sent = cluster.next()
            (sent.message as Say).to shouldBe "b"
            sent.end.complete(null)
            shouldBelieve("a", "done[source(self)]")
            believed("a").single { it.startsWith("names") } shouldContain "b"
        }
    }

    test("services of all computers are found, and told to subscribers") {
        computer("+!go <- .df_register(dig); .df_subscribe(fly); .df_search(dig,L); +found(L).") {
            shouldBelieve("a", "found([a])[source(self)]")
            fleet.directory.roster("base").offers shouldBe setOf(Offer("a", "dig"))
            cluster.receives("scout1", RosterNews(offered = setOf(Offer("b", "fly"))))
            shouldBelieve("a", "provider(b,\"fly\")[source(df)]")
        }
    }

    test("services that are too much for another computer are told in the log, and to that computer again") {
        val told = CopyOnWriteArrayList<RosterNews>()
        computer("+!go <- .df_register(dig).", also = {
            cluster.answer = { sent ->
                (sent.message as? RosterNews)?.let(told::add)
                sent.end.completeExceptionally(Overloaded("a message of 9000000 bytes to scout1 is too long"))
            }
        }) {
            shouldLog("scout1 does not take all agents and services of base: they are too much")
            eventually(60.seconds) { told.count { it.isWhole } shouldBeGreaterThan 1 }
            logged("they are too much").size shouldBe 1
        }
    }

    test("an agent of another computer is killed there, and one here by a wish of another computer") {
        computer("+!go <- .kill_agent(b); +done.") {
            val sent = cluster.next()
            sent.message shouldBe Kill("b", "a", 0)
            sent.end.complete(null)
            shouldBelieve("a", "done[source(self)]")
            cluster.receives("scout1", Kill("a", "b", 0))
            eventually(60.seconds) { fleet.directory.names shouldNotContain "a" }
            shouldThrow<Refused> { cluster.receives("scout1", Kill("a", "b", 0)) }.error shouldBe "no_agent"
        }
    }

    test("an agent that is not there or out of touch is not killed, which fails the plan as a message to it does") {
        val program = "+!go <- !end(nobody); !end(late). +!end(Agent) <- .kill_agent(Agent). -!end(Agent)[error(E)] <- +failed(Agent,E)."
        computer(program) {
            shouldBelieve("a", "failed(nobody,no_agent)[source(self)]", "failed(late,unreachable)[source(self)]")
        }
    }

    test("a new agent has a name that no agent of the fleet has, and the fleet is told of it") {
        val news = ArrayList<RosterNews>()
        computer("+!go <- .create_agent(b); .clone(\"c\"); +done.", also = {
            cluster.answer = { sent ->
                (sent.message as? RosterNews)?.let(news::add)
                sent.end.complete(null)
            }
        }) {
            shouldBelieve("a", "done[source(self)]")
            fleet.directory.names shouldContainExactlyInAnyOrder listOf("a", "b", "b_1", "c")
            news shouldContain RosterNews(came = setOf("b_1"))
        }
    }

    test("a computer that comes, or starts anew, is told all that is here") {
        computer("") {
            val told = ArrayList<Pair<String, RosterNews>>()
            cluster.answer = { sent ->
                (sent.message as? RosterNews)?.let { told += sent.to to it }
                sent.end.complete(null)
            }
            cluster.view("scout1" to "2", "scout2" to "1")
            told shouldContainExactlyInAnyOrder listOf("scout1", "scout2").map { it to whole("a").copy(asksBack = true) }
            fleet.directory.names shouldNotContain "b" // until scout1, which is new, has reported its agents
            told.clear()
            cluster.receives("scout1", whole("b").copy(asksBack = true))
            told shouldBe listOf("scout1" to whole("a"))
        }
    }

    test("a computer that was out of touch and goes on is not asked again for what it has told; it may have missed nobody") {
        computer("+!go <- .send(b, tell, x); +done.", also = {
            cluster.view()
            fleet.directory.names shouldNotContain "b"
            cluster.view("scout1" to "1")
        }) {
            cluster.next().end.complete(null)
            shouldBelieve("a", "done[source(self)]")
        }
    }

    test("an agent of the project that has been killed is gone, and its name is free") {
        computer("+!go <- .send(late, tell, x). -!go[error(E)] <- +failed(E); .create_agent(late).", also = {
            cluster.view("scout1" to "1", "scout2" to "1")
            cluster.receives("scout2", whole("late"))
            cluster.receives("scout2", RosterNews(gone = setOf("late")))
        }) {
            shouldBelieve("a", "failed(no_agent)[source(self)]")
            eventually(60.seconds) { fleet.directory.roster("base").agents shouldContain "late" }
        }
    }

    test("the end of the system is told to all computers") {
        val stops = ArrayList<Stop>()
        computer("+!go <- .stopMAS(0,false).", also = {
            cluster.answer = { sent ->
                (sent.message as? Stop)?.let(stops::add)
                sent.end.complete(null)
            }
        }) {
            eventually(60.seconds) { isRunning shouldBe false }
            stops shouldBe listOf(Stop(0, stopsJvm = false, exitStatus = 0))
        }
    }

    test("an agent whose program is missing is told in one line, and the others begin") {
        OneComputer("a at \"base\"; b nothing.asl at \"base\";", "a" to "!go. +!go <- +done.").use { base ->
            base.shouldBelieve("a", "done[source(self)]")
            base.shouldLog("agent b cannot be created: ")
            base.thrown("agent b cannot be created: ") shouldBe listOf(null)
        }
    }

    test("an option of Jason's pools of threads, and a wrong word about percepts, are told") {
        computer("", options = "[argo_fleet=robots, cycles=3]") {
            shouldLog("a: cycles has no effect in a fleet")
            shouldLog("argo_fleet=robots: the value is computers and agents, or one of them")
        }
    }

    test("an agent of a name that another computer's has is told") {
        computer("") {
            cluster.receives("scout1", RosterNews(came = setOf("a")))
            shouldLog("an agent called a runs here and on scout1")
        }
    }

    test("a live view shows the computers, and which agents are where, with the ports of their views") {
        val a = "a agentArchClass argo.Arch at \"base\"; b [argo_view=8081] agentArchClass argo.Arch at \"scout1\";"
        OneComputer(a, "a" to "").use { base ->
            base.cluster.view("scout1" to "1")
            base.cluster.receives("scout1", whole("c", "b"))
            base.observed("a") shouldBe listOf(
                ObservedComputer("base", "127.0.0.1", isHere = true, isNear = true, isOn = true, listOf(AgentThere("a", null))),
                ObservedComputer(
                    "scout1", "127.0.0.1", isHere = false, isNear = true, isOn = true, listOf(AgentThere("b", 8081), AgentThere("c", null)),
                ),
                ObservedComputer("scout2", "127.0.0.1", isHere = false, isNear = true, isOn = false, emptyList()),
            )
        }
    }

    test("an idle agent that all news wake sleeps longer than one whose architecture may have to be asked") {
        OneComputer("a at \"base\"; b agentArchClass argo.Arch at \"base\";", "a" to "", "b" to "").use { base ->
            base.longestSleepMs("a") shouldBeGreaterThan base.longestSleepMs("b")
            base.longestSleepMs("b") shouldBe LocalAgArch.MAX_SLEEP.toLong()
        }
    }

    test("an agent perceives computers and agents if it asks for that") {
        computer("", options = "[argo_fleet=\"computers,agents\"]") {
            shouldBelieve(
                "a", "computer(base,on)[source(percept)]", "computer(scout1,on)[source(percept)]", "computer(scout2,off)[source(percept)]",
                "agent(a,base)[source(percept)]", "agent(b,scout1)[source(percept)]",
            )
            cluster.view("rasp-pi" to "1")
            shouldBelieve("a", "computer(scout1,off)[source(percept)]", "computer(\"rasp-pi\",off)[source(percept)]")
            eventually(60.seconds) { believed("a") shouldNotContain "agent(b,scout1)[source(percept)]" }
            cluster.receives("rasp-pi", whole("c"))
            shouldBelieve("a", "computer(\"rasp-pi\",on)[source(percept)]", "agent(c,\"rasp-pi\")[source(percept)]")
        }
    }
})
