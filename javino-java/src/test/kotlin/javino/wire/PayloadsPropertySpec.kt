package javino.wire

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.orNull
import io.kotest.property.checkAll
import javino.wire.BoardRule.Condition
import javino.wire.BoardRule.Operator

private val items: Arb<CommandItem> = Arb.choice(
    Arb.int(0..CommandItem.MAX_ACTION).map { CommandItem.Action(it) },
    texts(1..20).map { CommandItem.Text(it) },
    Arb.int(1..CommandItem.MAX_TEXT).map { CommandItem.Text("x".repeat(it)) },
    Arb.constant(CommandItem.Nothing()),
)

private val actions: Arb<List<BoardAction>> = Arb.list(
    Arb.bind(texts(0..30), Arb.int(0..BoardAction.ANY)) { name, arguments -> BoardAction(name, arguments) },
    0..40,
)

private val words = Arb.element("dist", "~clear", "a4\u00A5\u00A4", "x")
private val numbers = Arb.element("40", "-1.5", "+007", "0.0")
private val conditions = Arb.bind(Arb.int(1..9), Arb.element(Operator.entries), numbers, numbers.orNull()) {
        place, operator, value, until -> Condition(place, operator, value, until)
}
private val rules: Arb<BoardRule> = Arb.bind(words, Arb.list(conditions, 0..4), texts(1..20).orNull()) { functor, all, reflex ->
    BoardRule(functor, all, reflex)
}

class PayloadsPropertySpec : FunSpec({
    test("commands come back, and of a row that is cut those in front of the cut") {
        checkAll(Arb.list(items, 0..8)) { row ->
            val payload = row.joinToString("") { it.payload() }
            CommandItem.read(payload) shouldContainExactly row
            val ends = row.runningFold(0) { end, item -> end + item.payload().length }
            for (cut in payload.indices) CommandItem.read(payload.take(cut)) shouldContainExactly row.take(ends.count { it <= cut } - 1)
        }
    }

    test("any bytes are a row of commands, and what comes behind does not change those that are whole") {
        checkAll(5 * PropertyTesting.defaultIterationCount, texts(0..60), texts(0..9)) { payload, more ->
            val row = CommandItem.read(payload)
            CommandItem.read(payload + more).take(row.size) shouldBe row
        }
    }

    test("the long form of a text is read for any length but 0, which ends a row as an empty rule does") {
        for (end in listOf("\u0000\u0000", "\u00FF\u0000")) {
            CommandItem.read("\u0000\u0002hi\u0080$end\u0081") shouldContainExactly listOf(CommandItem.Text("hi"), CommandItem.Action(0))
        }
    }

    test("a welcome comes back, longer ones too, and one that is cut is none") {
        checkAll(Arb.int(0..255), Arb.int(0..255), Arb.int(0..255), Arb.int(0..255)) { nonce, credit, longest, rules ->
            val welcome = Welcome(nonce, credit, longest, rules)
            Welcome.read(welcome.payload() + "later") shouldBe welcome
            for (cut in 0..3) Welcome.read(welcome.payload().take(cut)) shouldBe null
            Welcome.read(welcome.payload().take(4)) shouldBe Welcome(nonce, credit, longest, rules, 0, 0)
        }
    }

    test("a vocabulary comes back, page by page") {
        checkAll(500, actions, Arb.int(60..255)) { all, maxPayload ->
            val read = mutableListOf<BoardAction>()
            while (read.size < all.size) {
                val payload = VocabularyPage.of(9, read.size, all, maxPayload).payload()
                (payload.length <= maxPayload) shouldBe true
                val page = VocabularyPage.read(payload)!!
                listOf(page.request(), page.first(), page.total()) shouldBe listOf(9, read.size, all.size)
                read += page.actions()
            }
            read shouldBe all
        }
    }

    test("a page that is cut within an action is none") {
        checkAll(200, actions) { all ->
            val page = VocabularyPage.of(1, 0, all, 255)
            val payload = page.payload()
            val ends = page.actions().runningFold(3) { end, action -> end + 2 + action.name().length }
            for (cut in payload.indices) (VocabularyPage.read(payload.take(cut)) != null) shouldBe (cut in ends)
        }
    }

    test("a rule comes back from its command, and one that is cut is another or none") {
        checkAll(rules, Arb.int(1..255)) { rule, number ->
            val text = rule.setting(number).text()
            text[0].code shouldBe number
            BoardRule.read(CommandItem.Rule(text)) shouldBe rule
            for (cut in 1 until text.length) BoardRule.read(CommandItem.Rule(text.take(cut)))?.let { it.functor() shouldBe rule.functor() }
        }
    }

    test("any bytes are a rule or none") {
        checkAll(5 * PropertyTesting.defaultIterationCount, texts(0..40)) { BoardRule.read(CommandItem.Rule("\u0007$it")) }
    }

    test("what removes rules sets none") {
        BoardRule.removal(7) shouldBe CommandItem.Rule("\u0007")
        BoardRule.removal(0) shouldBe CommandItem.Rule("\u0000")
        listOf(BoardRule.removal(7), BoardRule.removal(0)).map(BoardRule::read) shouldBe listOf(null, null)
    }

    for ((what, text) in mapOf(
        "of number 0" to "\u0000d\u0000", "without a functor" to "\u0007\u0000",
        "without a value" to "\u0007d\u00001<\u0000",
        "with an empty reflex" to "\u0007d\u0000\u0002", "that orders words" to "\u0007d\u00001<f\u0000",
        "at place 0" to "\u0007d\u00000<40\u0000", "of an unknown operator" to "\u0007d\u00001?40\u0000",
        "without the second value" to "\u0007d\u00001<40\u0001\u0000",
    )) {
        test("there is no rule $what") { BoardRule.read(CommandItem.Rule(text)) shouldBe null }
    }
})
