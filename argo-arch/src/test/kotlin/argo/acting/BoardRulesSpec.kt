package argo.acting

import argo.calls.Failure
import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.Rule
import argo.filters.TermTest
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import javino.wire.BoardRule
import javino.wire.CommandItem
import java.util.TreeMap
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import kotlin.random.Random

/** A board whose answers to commands the test decides. */
private class RulesBench {
    var wanted = emptyList<CriticalRule>()
    val sent = ArrayList<String>()
    private val changes = ArrayList<CommandItem.Rule>()
    private val waiting = ArrayDeque<(Failure?) -> Unit>()
    var isOpen = true
    val rules = BoardRules({ wanted }, { command, outcome ->
        sent += words(command)
        changes += command
        if (isOpen) waiting += outcome else outcome(Failure("port_gone", "the port is gone"))
    })

    fun wants(vararg rules: CriticalRule) {
        wanted = rules.toList()
        this.rules.renew()
    }

    val count get() = waiting.size

    /** Lets the board carry out the oldest waiting command, if there is one. [onBoard] are the board's rules by number. */
    fun handle(onBoard: MutableMap<Int, String>) {
        if (waiting.isEmpty()) return
        val command = changes[changes.size - waiting.size]
        val number = command.text()[0].code
        val rule = BoardRule.read(command)
        if (rule != null) onBoard[number] = rule.functor() else if (number == 0) onBoard.clear() else onBoard -= number
        ends()
    }

    /** Ends the oldest waiting command with [error], or without one. */
    fun ends(error: String? = null) = waiting.removeFirst()(error?.let { Failure(it, it) })

    fun endsAll() = repeat(waiting.size) { ends() }

    /** Returns the commands since the last call. */
    fun news(): List<String> = sent.toList().also { sent.clear() }

    private fun words(change: CommandItem.Rule): String {
        if (change == BoardRule.removal(0)) return "none"
        val number = change.text()[0].code
        val rule = BoardRule.read(change) ?: return "-$number"
        return "$number=${rule.functor()}"
    }
}

class BoardRulesSpec : FunSpec({
    val (a, b, c, d) = listOf("a", "b", "c", "d").map { CriticalRule(Rule(it), "stop") }
    val unwatchable = CriticalRule(Rule("x", Condition.Argument(0, TermTest.Matches("f.*"))))

    test("rules are set when a session begins, in the order of the filter, as far as there is room and a board can watch them") {
        val bench = RulesBench()
        bench.wants(a, unwatchable, b, b, c)
        bench.news().shouldBeEmpty()
        bench.rules.isEmpty shouldBe true
        bench.rules.began(2)
        bench.news() shouldBe listOf("1=a", "2=b")
        bench.rules.isEmpty shouldBe false
        bench.rules.began(0)
        bench.news().shouldBeEmpty()
        bench.rules.isEmpty shouldBe true
    }

    test("the computer watches a rule until the board has acknowledged it") {
        val bench = RulesBench()
        bench.wants(a, b)
        bench.rules.began(8)
        listOf(a, b).map(bench.rules::isWatching) shouldBe listOf(false, false)
        bench.rules.ruleOf(1) shouldBe a // a report may overtake the acknowledgement
        bench.ends()
        listOf(a, b).map(bench.rules::isWatching) shouldBe listOf(true, false)
    }

    test("a change sends the difference, removals first, and the computer watches what is removed") {
        val bench = RulesBench()
        bench.wants(a, b, c)
        bench.rules.began(3)
        bench.endsAll()
        bench.news()
        bench.wants(d, c, b)
        bench.news() shouldBe listOf("-1", "4=d")
        listOf(a, b, c, d).map(bench.rules::isWatching) shouldBe listOf(false, true, true, false)
        bench.wants(d, c, b)
        bench.news().shouldBeEmpty()
        bench.wants()
        bench.news() shouldBe listOf("none")
        bench.rules.isEmpty shouldBe true
    }

    test("a rule that has lost its place to one before it is the computer's") {
        val bench = RulesBench()
        bench.wants(a, b)
        bench.rules.began(2)
        bench.endsAll()
        bench.wants(c, a, b)
        bench.endsAll()
        bench.news() shouldBe listOf("1=a", "2=b", "-2", "3=c")
        listOf(a, b, c).map(bench.rules::isWatching) shouldBe listOf(true, false, true)
    }

    test("what the board refuses stays with the computer, and the next rule takes its place") {
        val bench = RulesBench()
        bench.wants(a, b, c)
        bench.rules.began(2)
        bench.ends("act_refused")
        bench.news() shouldBe listOf("1=a", "2=b", "3=c")
        bench.endsAll()
        listOf(a, b, c).map(bench.rules::isWatching) shouldBe listOf(false, true, true)
        bench.rules.renew()
        bench.news().shouldBeEmpty()
        bench.wants(a, b) // the board may now have room for it
        bench.news() shouldBe listOf("-3", "4=a")
    }

    test("a board that refuses all is asked for each rule once") {
        val bench = RulesBench()
        bench.wants(a, b, c, d)
        bench.rules.began(2)
        repeat(4) { bench.ends("act_refused") }
        bench.news() shouldBe listOf("1=a", "2=b", "3=c", "4=d")
        bench.rules.isEmpty shouldBe true
    }

    test("a rule that is not acknowledged may be on the board: the computer watches, and it is removed all the same") {
        val bench = RulesBench()
        bench.wants(a, b)
        bench.rules.began(2)
        bench.ends("act_unconfirmed")
        bench.rules.isWatching(a) shouldBe false
        bench.rules.ruleOf(1) shouldBe a
        bench.news()
        bench.wants(b)
        bench.news() shouldBe listOf("-1")
    }

    test("in a new session all are set again, and outcomes of the one before count no more") {
        val bench = RulesBench()
        bench.wants(a, b)
        bench.rules.began(2)
        bench.rules.began(2)
        bench.news() shouldBe listOf("1=a", "2=b", "none", "3=a", "4=b")
        bench.ends()
        bench.ends("act_refused")
        bench.ends()
        listOf(a, b).map(bench.rules::isWatching) shouldBe listOf(false, false)
        bench.endsAll()
        listOf(a, b).map(bench.rules::isWatching) shouldBe listOf(true, true)
    }

    test("whatever waits on the line while the board starts anew, it has the rules of now when all is handled") {
        for (seed in 1..500) {
            val random = Random(seed)
            val bench = RulesBench()
            val onBoard = TreeMap<Int, String>()
            bench.rules.began(8)
            repeat(random.nextInt(1, 20)) {
                when (random.nextInt(4)) {
                    0 -> {
                        onBoard.clear()
                        bench.rules.began(8)
                    }
                    1 -> bench.handle(onBoard)
                    else -> bench.wants(*listOf(a, b, c, d).filter { random.nextBoolean() }.toTypedArray())
                }
            }
            repeat(bench.count) { bench.handle(onBoard) }
            withClue("seed $seed") {
                onBoard.values.sorted() shouldBe bench.wanted.map { "${it.rule.predicate}" }
                bench.wanted.all(bench.rules::isWatching) shouldBe true
            }
        }
    }

    test("on a line that is gone no rule is set, and nothing is tried again") {
        val bench = RulesBench()
        bench.isOpen = false
        bench.wants(a, b)
        bench.rules.began(2)
        bench.sent.size shouldBeLessThan 3
        listOf(a, b).map(bench.rules::isWatching) shouldBe listOf(false, false)
    }

    test("a number is used again only after all others") {
        val bench = RulesBench()
        bench.rules.began(2)
        repeat(300) {
            bench.wants(a, if (it % 2 == 0) b else c)
            bench.endsAll()
        }
        bench.rules.isWatching(a) shouldBe true
        bench.rules.ruleOf(1) shouldBe a
        bench.news().filter { "=" in it }.drop(1).take(255).map { it.substringBefore('=').toInt() } shouldBe (2..255) + 2
    }

    context("a rule is mapped exactly, or not at all:") {
        fun argument(index: Int, operator: Operator, value: String) =
            Condition.Argument(index, TermTest.Compare(operator, GroundTerm.of(value)))

        fun mapped(vararg conditions: Condition, predicate: String = "dist") =
            boardRuleOf(CriticalRule(Rule(predicate, *conditions), "stop"))?.setting(7)?.text()?.replace('\u0000', '|')

        test("numbers and atoms with all operators") {
            mapped() shouldBe "\u0007dist|\u0002stop"
            mapped(argument(0, Operator.EQ, "front"), argument(1, Operator.LT, "15")) shouldBe "\u0007dist|1=front|2<15|\u0002stop"
            mapped(argument(0, Operator.GE, "-1.50"), argument(0, Operator.LE, "1e3")) shouldBe "\u0007dist|1}-1.5|1{1000|\u0002stop"
            mapped(argument(8, Operator.GT, "0.0001"), argument(1, Operator.NE, "'a b'")) shouldBe
                "\u0007dist|9>0.0001|2!'a b'|\u0002stop"
            mapped(predicate = "~open") shouldBe "\u0007~open|\u0002stop"
        }

        test("NE alone is not, since a filter's is false without the argument") {
            mapped(argument(0, Operator.NE, "front")) shouldBe null
            mapped(argument(1, Operator.NE, "front"), argument(0, Operator.GT, "1")) shouldBe null
            mapped(argument(0, Operator.NE, "front"), argument(1, Operator.GT, "1")) shouldBe "\u0007dist|1!front|2>1|\u0002stop"
        }

        test("what a board cannot compare is not") {
            mapped(argument(9, Operator.LT, "1")) shouldBe null
            mapped(argument(0, Operator.EQ, "\"front\"")) shouldBe null
            mapped(argument(0, Operator.EQ, "pos(1,2)")) shouldBe null
            mapped(argument(0, Operator.EQ, "[a]")) shouldBe null
            mapped(argument(0, Operator.EQ, "~open")) shouldBe null
            mapped(argument(0, Operator.LT, "1e999")) shouldBe null
            mapped(argument(0, Operator.LT, "0.12345678901234567")) shouldBe null
            mapped(Condition.Annotation("q")) shouldBe null
            mapped(Condition.Argument(0, TermTest.OneOf(setOf(GroundTerm.of("a"), GroundTerm.of("b"))))) shouldBe null
            mapped(predicate = "house::dist") shouldBe null
            mapped(predicate = "'Dist'") shouldBe null
            boardRuleOf(CriticalRule(Rule(argo.filters.Predicate.of("dist"), arity = 2))) shouldBe null
            boardRuleOf(CriticalRule(Rule("dist"), "x".repeat(255))) shouldBe null
        }
    }

    test("no lock is held while a command is sent, and commands go out in the order in which they were decided") {
        val sent = ArrayList<String>()
        lateinit var rules: BoardRules
        var wanted = listOf(a, b)
        rules = BoardRules({ wanted }, { command, _ ->
            sent += BoardRule.read(command)?.functor() ?: "none"
            val other = CompletableFuture.runAsync {
                if (sent.size == 1) wanted = listOf(c)
                rules.renew() // by another thread, which would wait for a lock
            }
            other.get(20, TimeUnit.SECONDS)
        })
        rules.began(8)
        sent shouldBe listOf("a", "b", "none", "c")
    }
})
