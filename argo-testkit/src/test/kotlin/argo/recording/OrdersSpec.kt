package argo.recording

import argo.observing.Order
import argo.recording.replay.Recording
import argo.testkit.TestAgent
import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.datatest.withData
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSemantics.Agent
import jason.asSemantics.Intention
import jason.asSyntax.Literal
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class StumblingAgent : Agent() {
    override fun brf(beliefToAdd: Literal?, beliefToDel: Literal?, i: Intention?): Array<MutableList<Literal>>? {
        if (beliefToAdd?.functor == "stumbles") throw StackOverflowError()
        return super.brf(beliefToAdd, beliefToDel, i)
    }
}

/** An agent carries out a user's orders between two reasoning cycles. A replay carries out the recorded orders. */
class OrdersSpec : FunSpec({
    fun TestAgent.carriesOut(order: Order) = ordered(order).refusal.shouldBeNull()

    test("a person's belief is the agent's own: its plans find it, replace it and remove it") {
        agentOf("limit(40). +!lower : limit(L) <- -+limit(L - 5). +limit(L)[source(S)] <- .print(L, S). +!no <- -limit(_).").use { robot ->
            robot.carriesOut(Order.Believe("-+limit(20 + 10)"))
            robot.shouldBelieve("limit(30)[source(self)]").shouldNotBelieve("limit(40)", 0.seconds)
            robot.hears("boss", "achieve", "lower").shouldBelieve("limit(25)").shouldNotBelieve("limit(30)", 0.seconds)
            robot.hears("boss", "achieve", "no").after(100.milliseconds).shouldNotBelieve("limit(_)", 0.seconds)
            robot.printed shouldContainExactly listOf("40self", "30self", "25self")
        }
    }

    test("a belief is forgotten in each of its sources, or in the one that is named") {
        agentOf("p(1). p(2). q(1). +!tell(X) <- +X[source(bob)]. -p(X) <- .print(X).").use { robot ->
            robot.hears("boss", "achieve", "tell(q(1))").shouldBelieve("q(1)[source(bob)]")
            robot.carriesOut(Order.Forget("q(1)[source(bob)]"))
            robot.shouldBelieve("q(1)[source(self)]").shouldNotBelieve("q(1)[source(bob)]", 0.seconds)
            robot.ordered(Order.Forget("p(_)")).told shouldContainExactly listOf("the agent has forgotten 2 beliefs")
            robot.shouldNotBelieve("p(_)", 0.seconds)
            robot.printed.sorted() shouldContainExactly listOf("1", "2")
        }
    }

    test("a goal begins as an intention of its own, and its intentions and events are dropped") {
        agentOf("+!patrol(X) <- .print(patrol, X); .wait(600000). +!idle(X) <- !patrol(X).").use { robot ->
            robot.carriesOut(Order.Begin("!patrol(north)"))
            robot.carriesOut(Order.Begin("idle(_)"))
            robot.shouldIntend("patrol(north)").shouldIntend("idle(_)")
            robot.carriesOut(Order.Drop("idle(_)"))
            robot.after(100.milliseconds).intentions shouldContainExactly listOf("!patrol(north) at .wait(600000)")
            robot.carriesOut(Order.Drop("!patrol(_)"))
            robot.after(100.milliseconds).intentions shouldContainExactly emptyList()
        }
    }

    context("the agent refuses in words, and stays as it is") {
        withData(
            mapOf(
                "what is no literal" to
                    (Order.Believe("limit(") to "'limit(' is no belief that Jason can read: Encountered \"<EOF>\" at line 1"),
                "a belief with a variable" to (Order.Believe("limit(X)") to "limit(X) has a variable without a value"),
                "a truth value" to (Order.Believe("true") to "true is a word of AgentSpeak, which cannot be a belief's name"),
                "a percept" to (Order.Believe("dist(f,3)[source(percept)]") to "is believed as long as the agent perceives it"),
                "a variable" to (Order.Believe("X") to "a belief is a literal such as near(wall), not X"),
                "a string" to (Order.Begin("\"patrol\"") to "is no goal that Jason can read"),
                "a rule" to (Order.Believe("near :- dist(_,_)") to "does not belong there"),
                "an internal action as a goal" to (Order.Begin(".print(x)") to "a goal is a literal such as near(wall), not .print(x)"),
                "a goal without a plan" to (Order.Begin("fly(1)") to "the agent has no plan for +!fly/1"),
                "a belief that it has not" to (Order.Forget("likes(tea)") to "the agent does not believe likes(tea)"),
                "to forget a percept" to (Order.Forget("dist(_,_)") to "it cannot forget dist"),
                "a goal that it has not" to (Order.Drop("start") to "the agent has no intention and no event for !start"),
            ),
        ) { (order, why) ->
            val program = "limit(40). !begin. +!begin <- argo.port(ttyACM0); argo.percepts(open). +!start."
            agentOf(program, { board("ttyACM0").shows("dist(f,9)") }).use { robot ->
                robot.shouldBelieve("dist(f,9)")
                val before = robot.beliefs
                robot.ordered(order).refusal.orEmpty() shouldContain why
                robot.beliefs shouldBe before
                robot.intentions shouldContainExactly emptyList()
            }
        }
    }

    test("an order that fails in the project's own code is told, and the agent goes on") {
        agentOf("+likes(X) <- .print(X).", { agentClass = StumblingAgent::class.java }).use { robot ->
            robot.ordered(Order.Believe("stumbles(1)")).refusal.orEmpty() shouldContain "it failed, perhaps in the middle: java.lang.Stack"
            robot.mas.open { robot.observed.order(Order.Believe("likes(tea)")) { error("the view is gone") } }
            robot.after(20.milliseconds)
            robot.carriesOut(Order.Believe("likes(milk)"))
            robot.printed shouldContainExactly listOf("tea", "milk")
        }
    }

    test("a drive with orders is replayed as it was, refused ones included") {
        val program = """
            limit(40). !go.
            +!go : limit(L) & math.random(L) < 20 <- .print(low); .wait(30); !go.
            +!go <- .wait("+ready(_)"); !note(waited).
            +!note(T) <- -+noted(T); !go.
            -limit(L) <- .print(gone, L).
        """
        val file = recorded(program) {
            after(200.milliseconds)
            ordered(Order.Believe("-+limit(math.random(10))"))
            ordered(Order.Believe("limit("))
            ordered(Order.Begin("note(_)"))
            ordered(Order.Believe("ready(1)"))
            ordered(Order.Forget("limit(_)"))
            ordered(Order.Drop("go"))
            after(200.milliseconds)
        }
        shouldReplay(file)
        val orders = Recording(file).use { recording -> recording.cycles("agent").flatMap { it.input.orders }.toList() }
        orders.map { it.kind } shouldContainExactly listOf("believe", "believe", "begin", "believe", "forget", "drop")
        orders shouldContain GivenOrder("forget", "limit(_)")
    }
})
