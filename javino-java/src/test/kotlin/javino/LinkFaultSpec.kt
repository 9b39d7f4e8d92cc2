package javino

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlin.math.pow
import kotlin.math.roundToInt
import kotlin.random.Random

private const val REQUEST = "getPercepts"
private const val EXCHANGES = 3_000
private val FAST = LinkSettings.defaults().withBaud(115_200).withBootMillis(0)

/** Turns bits over, each with the same probability, in its own copy of the bytes. */
private class BitErrors(private val rate: Double, seed: Int) {
    private val random = Random(seed)

    fun damage(bytes: ByteArray): ByteArray = ByteArray(bytes.size) { i ->
        (0..7).fold(bytes[i].toInt()) { byte, bit -> if (random.nextDouble() < rate) byte xor (1 shl bit) else byte }.toByte()
    }
}

/** What became of many actions and requests on a line with bit errors. */
private class Outcomes(rate: Double, protocol: Protocol = Protocol.V2, exchanges: Int = EXCHANGES) {
    private val board = VirtualBoard2(damage = BitErrors(rate, seed = 2026)::damage).apply { answer = { percepts(it) } }
    val confirmed = mutableListOf<String>()
    val unconfirmed = mutableListOf<String>()
    val wrong = mutableListOf<String>()
    var answered = 0
    var corrupt = 0L
    var sentFrames = 0
    val handled get() = board.handled.filter { REQUEST !in it }.map { it.drop(2) }

    init {
        VirtualBench(FAST, board, protocol).use { bench ->
            for (i in 1..exchanges) {
                act(bench.link, "speed($i)")
                ask(bench.link)
            }
            corrupt = bench.link.corruptFrames()
        }
        sentFrames = board.received.size
    }

    private fun act(link: Link, action: String) = try {
        link.send(action, 500)
        confirmed += action
    } catch (_: ActionUnconfirmedException) {
        unconfirmed += action
    } catch (refused: ActionRefusedException) {
        wrong += "$refused"
    }

    private fun ask(link: Link) = try {
        val text = link.request(REQUEST, 500)
        answered++
        if (text != percepts(text.substringAfter('(').substringBefore(',').toIntOrNull() ?: 0)) wrong += text else answered
    } catch (_: PortTimeoutException) {
        answered
    }
}

private fun percepts(n: Int) = "count($n,${n * 31 % 1009});" + "dist(f,$n);".repeat(8)

/** The share of exchanges of these two payloads that one of three tries gets through unharmed. */
private fun inThreeTries(rate: Double, there: String, back: String): Double {
    val bits = 8 * listOf(there, back).sumOf { Frame.version2(it.toByteArray(), 0, 0).length() }
    return 1 - (1 - (1 - rate).pow(bits)).pow(3)
}

class LinkFaultSpec : FunSpec({
    for (rate in listOf(1e-5, 1e-4, 1e-3)) {
        test("with one bit in ${(1 / rate).roundToInt()} wrong no action is carried out twice or wrongly, and no percept is") {
            val outcomes = Outcomes(rate)
            println("bit error rate $rate, $EXCHANGES actions and requests: ${outcomes.confirmed.size} confirmed, " +
                "${outcomes.unconfirmed.size} unconfirmed, ${outcomes.answered} answered, ${outcomes.corrupt} answers or acknowledgements " +
                "dropped for their checksum, ${outcomes.wrong.size} wrong")
            outcomes.wrong.shouldBeEmpty()
            outcomes.handled.groupingBy { it }.eachCount().filterValues { it > 1 }.keys.shouldBeEmpty()
            (outcomes.handled - (outcomes.confirmed + outcomes.unconfirmed).toSet()).shouldBeEmpty()
            (outcomes.confirmed - outcomes.handled.toSet()).shouldBeEmpty()
            outcomes.handled shouldBe outcomes.handled.sortedBy { it.filter(Char::isDigit).toInt() }
            val middle = EXCHANGES / 2
            outcomes.confirmed.size.toDouble() / EXCHANGES shouldBeGreaterThan inThreeTries(rate, "speed($middle)", "") - 0.01
            outcomes.answered.toDouble() / EXCHANGES shouldBeGreaterThan inThreeTries(rate, REQUEST, percepts(middle)) - 0.01
        }
    }

    for ((rate, least) in listOf(1e-5 to 0.99, 1e-4 to 0.99, 1e-3 to 0.6)) {
        test("with one bit in ${(1 / rate).roundToInt()} wrong a version 2 board is found to be one") {
            val found = (1..LINKS).count { seed ->
                val board = VirtualBoard2(damage = BitErrors(rate, seed)::damage)
                VirtualBench(FAST, board, Protocol.AUTO).use { bench ->
                    runCatching { bench.link.request(REQUEST, 500) }
                    bench.link.protocol() == Protocol.V2
                }
            }
            println("bit error rate $rate: $found of $LINKS version 2 boards are found to be that with the first request")
            found / LINKS.toDouble() shouldBeGreaterThan least
        }
    }
})

private const val LINKS = 300
