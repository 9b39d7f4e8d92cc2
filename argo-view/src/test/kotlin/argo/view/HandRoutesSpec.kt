package argo.view

import argo.observing.ObservedAgent
import argo.observing.Order
import argo.observing.Outcome
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class HandRoutesSpec : FunSpec({
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

    test("an agent that does not answer in time is waited for no longer") {
        val agent = Ordered().apply { outcome = null }
        with(agent.ask("/begin", """{"text":"drive"}""")) {
            first shouldBe 202
            second shouldContain "in its next reasoning cycle"
        }
    }
})

/** An agent that notes its orders and answers with [outcome]; null: not at all. */
private class Ordered : ObservedAgent by Nobody {
    var outcome: Outcome? = Outcome(null)
    val orders = ArrayList<Order>()
    private val routes = HandRoutes(this).routes

    override fun order(order: Order, done: (Outcome) -> Unit) {
        orders += order
        outcome?.let(done)
    }

    override fun reload(done: (Outcome) -> Unit) = outcome?.let(done) ?: Unit

    fun ask(path: String, json: String): Pair<Int, String> =
        routes.getValue(path).respond(Request("POST", path, null, HttpResponse.JSON, json.toByteArray()))
            .run { status to body.decodeToString() }
}
