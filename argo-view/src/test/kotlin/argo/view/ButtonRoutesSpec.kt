package argo.view

import argo.observing.Breakpoint
import argo.observing.ObservedAgent
import argo.observing.Order
import argo.observing.Outcome
import argo.observing.PausePhase
import argo.observing.PauseState
import argo.observing.Pausing
import argo.observing.StopAt
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class ButtonRoutesSpec : FunSpec({
    test("the buttons order the agent, and its answer is the response") {
        val agent = Ordered()
        agent.ask("/believe", """{"text":"-+limit(30)"}""") shouldBe (200 to """{"message":"-+limit(30): believed"}""")
        agent.ask("/forget", """{"text":"likes(tea)[source(self)]"}""").first shouldBe 200
        agent.ask("/begin", """{"text":"drive"}""") shouldBe (200 to """{"message":"drive: begun"}""")
        agent.ask("/drop", """{"text":"drive"}""").first shouldBe 200
        agent.orders shouldBe
            listOf(Order.Believe("-+limit(30)"), Order.Forget("likes(tea)[source(self)]"), Order.Begin("drive"), Order.Drop("drive"))
    }

    test("what the agent tells of an order is the response, also of one that it refuses") {
        val agent = Ordered()
        agent.outcome = Outcome("there is no plan for +!fly")
        agent.ask("/begin", """{"text":"fly"}""") shouldBe (422 to """{"message":"there is no plan for +!fly"}""")
        agent.outcome = Outcome(null, listOf("1 plan changed", "new initial beliefs, not believed: limit(9)"))
        agent.ask("/reload", "{}") shouldBe (200 to """{"message":"1 plan changed\nnew initial beliefs, not believed: limit(9)"}""")
        agent.outcome = Outcome("robot.asl, line 3: a plan ends with a dot")
        agent.ask("/reload", "{}") shouldBe (422 to """{"message":"robot.asl, line 3: a plan ends with a dot"}""")
        agent.outcome = Outcome(null, listOf("the agent believed tea already"))
        agent.ask("/believe", """{"text":"tea"}""") shouldBe (200 to """{"message":"the agent believed tea already"}""")
    }

    test("the agent is paused, and goes on until something") {
        val agent = Ordered()
        agent.ask("/pause", "{}").first shouldBe 200
        agent.ask("/step", "{}").first shouldBe 200
        agent.ask("/go", "{}").first shouldBe 200
        listOf("+!drive", "@fast", " dist(f,_)").forEach { agent.ask("/until", """{"text":"$it"}""").first shouldBe 200 }
        agent.pausing.asked shouldBe listOf(
            "pause", "${StopAt.NextCycle}", "go on", "${StopAt.ChosenPlan("+!drive")}", "${StopAt.ChosenPlan("fast")}",
            "${StopAt.Belief("dist(f,_)")}",
        )
        agent.ask("/until", """{"text":"dist("}""") shouldBe (422 to """{"message":"dist( is no literal"}""")
    }

    test("an agent that cannot be paused says why") {
        val agent = Ordered()
        agent.pausing.refusal = "this agent has three threads"
        agent.ask("/pause", "{}") shouldBe (422 to """{"message":"this agent has three threads"}""")
        agent.pausing.asked.shouldBeEmpty()
    }

    test("a breakpoint is at the line of a step, which may be a later one; one that is at none is refused") {
        val agent = Ordered()
        agent.ask("/breakpoint", """{"place":"robot.asl:11"}""") shouldBe (200 to """{"message":"the agent stops at robot.asl:12"}""")
        agent.ask("/breakpoint", """{"place":"robot.asl:12"}""").first shouldBe 200
        agent.ask("/breakpoint", """{"place":"other.asl:3"}""").first shouldBe 200
        with(agent.ask("/breakpoint", """{"place":"robot.asl:99"}""")) {
            first shouldBe 422
            second shouldContain "robot.asl:99: no plan is there"
        }
        agent.page.all shouldBe listOf(BreakpointState("other.asl", 3), BreakpointState("robot.asl", 12))
        agent.pausing.lines shouldBe mapOf("robot.asl" to listOf(12), "other.asl" to listOf(3))
        agent.ask("/breakpoint", """{"place":"robot.asl:12","isSet":false}""").first shouldBe 200
        agent.pausing.lines shouldBe mapOf("robot.asl" to emptyList(), "other.asl" to listOf(3))
        agent.page.all shouldBe listOf(BreakpointState("other.asl", 3))
        agent.pausing.found["other.asl"] = listOf(Breakpoint("other.asl", 3, null, "the plan of line 3 is gone"))
        agent.page.all shouldBe listOf(BreakpointState("other.asl", 3, "the plan of line 3 is gone"))
        agent.ask("/breakpoint", """{"place":"other.asl:5"}""").first shouldBe 200
        agent.page.all shouldBe listOf(BreakpointState("other.asl", 5))
        agent.ask("/breakpoint", """{"place":"line 12"}""").second shouldContain "write robot.asl:12"
    }

    test("an agent that does not answer in time is waited for no longer") {
        val agent = Ordered().apply { outcome = null }
        with(agent.ask("/begin", """{"text":"drive"}""")) {
            first shouldBe 202
            second shouldContain "in its next reasoning cycle"
        }
    }
})

/** An agent that notes its orders and answers with [outcome]. A null [outcome] means no answer. */
private class Ordered : ObservedAgent by Nobody {
    var outcome: Outcome? = Outcome(null)
    val orders = ArrayList<Order>()
    override val pausing = Pauses()
    val page = PageBreakpoints(this)
    private val routes = ButtonRoutes(this, page).routes

    override fun order(order: Order, done: (Outcome) -> Unit) {
        orders += order
        outcome?.let(done)
    }

    override fun reload(done: (Outcome) -> Unit) = outcome?.let(done) ?: Unit

    fun ask(path: String, json: String): Pair<Int, String> =
        routes.getValue(path).respond(Request("POST", path, null, HttpResponse.JSON, json.toByteArray()))
            .run { status to body.decodeToString() }
}

/** Notes the requests for pauses. The agent runs. */
internal class Pauses : Pausing {
    override var refusal: String? = null
    override val state = PauseState(PausePhase.RUNNING, null, emptyList(), null, null, 0)
    val asked = ArrayList<String>()
    val lines = HashMap<String, List<Int>>()
    val found = HashMap<String, List<Breakpoint>>()

    override fun pause(owner: Any) { asked += "pause" }
    override fun goOn() { asked += "go on" }
    override fun goOnUntil(stop: StopAt, owner: Any) {
        require(stop != StopAt.Belief("dist(")) { "dist( is no literal" }
        asked += "$stop"
    }
    override fun breakAt(owner: Any, file: String, lines: List<Int>): List<Breakpoint> {
        this.lines[file] = lines
        return lines.map { line ->
            if (line > 90) Breakpoint(file, line, null, "no plan is there") else Breakpoint(file, line, if (line == 11) 12 else line, null)
        }.also { found[file] = it }
    }
    override fun breakpoints(owner: Any) = found.values.flatten()
    override fun release(owner: Any) = Unit
    override fun follow(listener: (PauseState) -> Unit) = AutoCloseable {}
    override fun look(look: () -> Unit) = false
}
