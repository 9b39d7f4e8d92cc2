package argo.filters.jason

import argo.filters.dropFilter
import argo.filters.format.XmlFilters
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeSameInstanceAs
import jason.asSyntax.Literal

private fun read(text: String): List<Literal> = if (text == "broken(") emptyList() else listOf(PerceptReader.read(text))

private fun texts(literals: List<Literal>) = literals.map { "$it" }

class MessageSessionSpec : StringSpec({
    "one call makes percepts of a message: split, filtered, read and limited" {
        val session = MessageSession(::read) { kept, _ -> kept.take(2) }
        session.switchTo(XmlFilters.read("<PerceptionFilter><filter><predicate>temp</predicate></filter></PerceptionFilter>", "f.xml"))
        val perception = session.perceive("dist(f,1);temp(3);broken(;say(\"a;b\");dist(b,2);", 0)
        perception.texts.received shouldContainExactly listOf("dist(f,1)", "temp(3)", "broken(", "say(\"a;b\")", "dist(b,2)")
        perception.texts.kept shouldContainExactly listOf("dist(f,1)", "broken(", "say(\"a;b\")", "dist(b,2)")
        texts(perception.percepts) shouldContainExactly listOf("dist(f,1)", "say(\"a;b\")")
        perception.unreadable shouldBe setOf("broken(")
        perception.seen shouldBeSameInstanceAs perception.percepts
        perception.critical.shouldBeEmpty()
        perception.texts.nextDueMs shouldBe null
    }

    "what stands for a held-back percept is perceived and not seen, until the other is due" {
        val session = MessageSession(::read)
        session.switchTo(dropFilter("f") { drop("dist") { everyMs(100) } })
        session.perceive("dist(1)", 0)
        val held = session.perceive("dist(2);light(3)", 50)
        texts(held.percepts) shouldContainExactly listOf("dist(1)", "light(3)")
        texts(held.seen) shouldContainExactly listOf("light(3)")
        held.texts.nextDueMs shouldBe 100
        session.due(99) shouldBe null
        val due = session.due(100)!!
        texts(due.percepts) shouldContainExactly listOf("dist(2)", "light(3)")
        texts(due.seen) shouldContainExactly listOf("dist(2)", "light(3)")
    }

    "critical percepts come with their rules, and the limit knows them" {
        val session = MessageSession(::read) { kept, critical -> (critical + kept).take(1) }
        session.switchTo(dropFilter("f") { critical("dist") { argument(0) lt 15; reflex("stop") } })
        val perception = session.perceive("light(3);dist(14)", 0)
        texts(perception.percepts) shouldContainExactly listOf("dist(14)")
        perception.critical.map { it.rule.reflex to "${it.percept}" } shouldContainExactly listOf("stop" to "dist(14)")
    }

    "a perception does not change with those after it" {
        val session = MessageSession(::read)
        val first = session.perceive("dist(1)", 0)
        session.perceive("dist(2)", 1)
        first.texts.received shouldContainExactly listOf("dist(1)")
        texts(first.percepts) shouldContainExactly listOf("dist(1)")
    }
})
