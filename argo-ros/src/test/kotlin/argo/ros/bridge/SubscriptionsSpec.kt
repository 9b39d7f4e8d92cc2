package argo.ros.bridge

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.SmoothingRule
import argo.filters.TermTest
import argo.links.Wish
import argo.ros.mapping.mappingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class SubscriptionsSpec : FunSpec({
    val rules = mappingOf(
        """
        percepts:
          - /front sensor_msgs/Range -> dist(f, range)
          - /back sensor_msgs/Range -> dist(b, range)
          - /bump std_msgs/Bool -> bump if data == 'true'
          - /bump std_msgs/Bool -> free if data == 'false'
        """.trimIndent(),
        "t",
    ).percepts

    fun subscribed(filter: PerceptionFilter) = Wish(true, 50, filter).subscriptions(rules).map { it.topic to it.throttleMs }

    fun subscribed(vararg of: Rule, mode: Mode = Mode.DROP, critical: List<CriticalRule> = emptyList()) =
        subscribed(PerceptionFilter("f", of.asList(), mode, critical = critical))

    fun argument(index: Int, operator: Operator, value: String) =
        Condition.Argument(index, TermTest.Compare(operator, GroundTerm.of(value)))
    val all = listOf("/front" to 50, "/back" to 50, "/bump" to 50)

    test("without a filter all topics are subscribed to, each once, and none while the agent does not perceive") {
        Wish(true, 50, null).subscriptions(rules).map { it.topic to it.throttleMs } shouldBe all
        Wish(false, 50, null).subscriptions(rules) shouldBe emptyList()
    }
    test("a topic all of whose percepts are dropped is not") {
        subscribed(Rule("dist")) shouldBe listOf("/bump" to 50)
        subscribed(Rule("bump")) shouldBe all
        subscribed(Rule("bump"), Rule("free")) shouldBe all.dropLast(1)
        subscribed(Rule(Predicate("dist"), arity = 3)) shouldBe all
    }
    test("a topic of which each message counts is not throttled") {
        val each = listOf("/a std_msgs/Bool -> a all", "/b std_msgs/Bool -> b if data == 'true' for 1 s", "/c std_msgs/Bool -> c for 1 s")
        val mapping = mappingOf(each.joinToString("\n", "percepts:\n") { "  - $it" }, "t")
        val all = Wish(true, 50, null).subscriptions(mapping.percepts)
        all.map { "${it.topic} ${it.throttleMs} ${it.queueLength}" } shouldBe listOf("/a 0 0", "/b 0 0", "/c 50 1")
    }
    test("conditions count where they are about what the rule says itself") {
        subscribed(Rule("dist", argument(0, Operator.NE, "f"))) shouldBe listOf("/front" to 50, "/bump" to 50)
        subscribed(Rule("dist", argument(0, Operator.EQ, "f"), argument(1, Operator.GT, "2"))) shouldBe all
        subscribed(Rule("dist", argument(5, Operator.EQ, "f"))) shouldBe all
    }
    test("a filter that keeps what its rules meet drops the topics of all others") {
        val farBehind = Rule("dist", argument(0, Operator.EQ, "b"), argument(1, Operator.GT, "2"))
        subscribed(farBehind, mode = Mode.KEEP) shouldBe listOf("/back" to 50)
        subscribed(mode = Mode.KEEP) shouldBe emptyList()
    }
    test("a percept that a critical rule is about is never dropped") {
        subscribed(Rule("dist"), critical = listOf(CriticalRule(Rule("dist")))) shouldBe all
    }
    test("a rate that holds all percepts of a topic back makes its throttle") {
        subscribed(Rule(Predicate("dist"), rate = Rate(everyMs = 400))) shouldBe listOf("/front" to 400, "/back" to 400, "/bump" to 50)
        subscribed(Rule(Predicate("dist"), rate = Rate(everyMs = 10))) shouldBe all
        val slow = listOf(Rule(Predicate("dist"), rate = Rate(everyMs = 400)))
        subscribed(PerceptionFilter("f", slow, smoothing = listOf(SmoothingRule(Rule("dist"), 1, median = 3)))) shouldBe all
        subscribed(Rule(Predicate("bump"), rate = Rate(everyMs = 400))) shouldBe all
    }
})
