package javino.wire

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.of
import io.kotest.property.checkAll

/** Percepts that share shapes, with digits anywhere. Some are long, some have any bytes. */
private val percepts: Arb<List<String>> = Arb.list(
    Arb.choice(
        Arb.list(Arb.element("dist(", "f", ",", "12", "007", "0", "-", ".", ")", "9999999999", "\"1\""), 0..6)
            .map { it.joinToString("") + ";" },
        Arb.int(0..300).map { "s${it % 7}($it);" },
        texts(0..20).map { it.replace(';', ',') + ";" },
        Arb.int(250..600).map { "long(" + "x1".repeat(it / 2) + ");" },
    ),
    0..30,
)

class PerceptItemsPropertySpec : FunSpec({
    test("a session's answers come back to the byte, whatever the board has room for, is lost and is known") {
        checkAll(500, Arb.list(percepts, 1..8), Arb.of(0, 1, 5, 30, 126), Arb.list(Arb.boolean(), 8..8), Arb.int(0..200)) {
                answers, capacity, lost, claimed ->
            val board = PerceptWriter(capacity)
            val computer = PerceptDecoder()
            answers.forEachIndexed { i, texts ->
                val items = board.items(texts, if (i % 3 == 0) minOf(claimed, computer.known()) else computer.known())
                if (!lost[i]) computer.read(items, LIMIT).get() shouldBe texts.joinToString("")
            }
        }
    }

    test("a computer whose session begins anew is understood when it knows nothing") {
        checkAll(200, percepts, percepts) { first, second ->
            val board = PerceptWriter(126)
            PerceptDecoder().read(board.items(first, 0), LIMIT)
            PerceptDecoder().read(board.items(second, 0), LIMIT).get() shouldBe second.joinToString("")
        }
    }

    test("a text that is known crosses as its digits") {
        val board = PerceptWriter(126)
        val computer = PerceptDecoder()
        val texts = listOf("dist(f,123);", "light(f,95);")
        computer.read(board.items(texts, 0), LIMIT)
        board.items(texts, computer.known()) shouldBe "\u0080\u0002\u0012\u003F\u0095\u00FF"
    }

    test("items that are cut or damaged give a text or none, and never throw") {
        checkAll(percepts, Arb.int(0..2_000), texts(1..1)) { texts, at, octet ->
            val board = PerceptWriter(126)
            val computer = PerceptDecoder()
            computer.read(board.items(texts, 0), LIMIT)
            val items = board.items(texts, computer.known())
            val cut = at % (items.length + 1)
            computer.read(items.substring(0, cut) + octet + items.drop(cut + 1), LIMIT)
            computer.read(items.substring(0, cut), LIMIT)
            computer.forget()
            computer.read(board.items(texts, computer.known()), LIMIT).get() shouldBe texts.joinToString("")
        }
    }

    test("any bytes as items do no harm, and what cannot be read leaves nothing known") {
        checkAll(5 * PropertyTesting.defaultIterationCount, texts(0..40)) { items ->
            val computer = PerceptDecoder()
            if (computer.read(items, LIMIT).isEmpty) computer.known() shouldBe 0
        }
    }

    test("an answer whose items stand for more than the limit is given up there, and what it taught stays") {
        val texts = (0 until 126).joinToString("") { "${it.toChar()}\u00ff" + "a".repeat(255) }
        val bomb = texts + "\u0080\u007e".repeat(32_768) // a gigabyte
        val computer = PerceptDecoder()
        shouldThrow<PerceptDecoder.TooLongException> { computer.read(bomb, LIMIT) }
        computer.known() shouldBe 126
        computer.read("\u0080\u0002", LIMIT).get() shouldBe "a".repeat(510)
        shouldThrow<PerceptDecoder.TooLongException> { computer.read("\u0080\u0002", 509) }
    }
})

private const val LIMIT = 65_536
