package javino.link

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import javino.LineClock
import javino.PortGoneException
import javino.Protocol
import javino.Transport
import javino.sim.VirtualBoard2
import javino.virtual.EventLine
import javino.virtual.FAULTLESS
import javino.virtual.FaultyExchanges
import javino.virtual.FaultyExchanges.Companion.FAST
import javino.virtual.FaultyExchanges.Companion.ninePercepts
import javino.virtual.FaultyExchanges.Companion.numberIn
import javino.virtual.OneFault
import javino.virtual.Piece
import javino.virtual.RandomFaults
import kotlin.math.exp
import kotlin.math.pow
import kotlin.math.roundToInt
import kotlin.time.Duration.Companion.minutes

private const val REQUEST = "getPercepts"

/** Length of a request. An answer of nine percepts with known texts has this length too. */
private const val ASK_BYTES = 7
private const val ANSWER_BYTES = 42

/** Number of exchanges at each fault rate, half of them actions. `./argo bench faults` makes a million. */
private val EXCHANGES = Integer.getInteger("argo.exchanges", 5_000)

/** The share of exchanges that one of three tries completes undamaged. */
private fun inThreeTries(wrongBits: Double, wrongBytes: Double, there: Int, back: Int): Double {
    val bytes = there + back
    return 1 - (1 - ((1 - wrongBits).pow(8) * (1 - wrongBytes)).pow(bytes)).pow(3)
}

/**
 * The number of damaged frames that a 16-bit checksum cannot detect. The checksum misses one in 65,536 frames with four or more wrong
 * bits, because the distance of its code is four. The checksum also misses one in 65,536 frames with a damaged length field. The receiver
 * reads the checksum of such a frame at a wrong place.
 */
private fun missed(rate: Double, frames: Double, bytes: Int): Double {
    val bits = 8 * bytes
    var term = (1 - rate).pow(bits)
    var upToThree = term
    for (k in 1..3) {
        term *= (bits - k + 1.0) / k * rate / (1 - rate)
        upToThree += term
    }
    val length = 1 - (1 - rate).pow(16)
    return frames * ((1 - upToThree).coerceAtLeast(0.0) + length) / 65_536
}

/** A limit for a number with the average [expected]. Less than one of a million runs exceeds it. */
private fun most(expected: Double): Int {
    var term = exp(-expected)
    var sum = term
    var k = 0
    while (sum < 1 - 1e-6) {
        term *= expected / ++k
        sum += term
    }
    return k
}

private fun report(words: String, outcomes: FaultyExchanges, exchanges: Int) {
    println(
        "measured: $words, $exchanges exchanges in version 2: " +
            "${outcomes.confirmations} of ${exchanges / 2} actions confirmed, ${outcomes.twice} twice, ${outcomes.wrong.size} wrong; " +
            "${outcomes.answered} of ${exchanges / 2} requests answered; ${outcomes.corruptFrames} frames dropped for their checksum",
    )
}

class LinkFaultSpec : FunSpec({
    for (rate in listOf(1e-5, 1e-4, 1e-3)) {
        test("with one bit in ${(1 / rate).roundToInt()} wrong no action is carried out twice or wrongly, and no percept is").config(
            timeout = 30.minutes,
        ) {
            val outcomes = FaultyExchanges(EXCHANGES, RandomFaults(rate, seed = 2026), RandomFaults(rate, seed = 7))
            val half = EXCHANGES / 2
            val answer = ANSWER_BYTES
            val requests = inThreeTries(rate, 0.0, ASK_BYTES, answer)
            val missed = missed(rate, 3.0 * half, answer)
            report("one bit in ${(1 / rate).roundToInt()} wrong", outcomes, EXCHANGES)
            println(("measured: confirmed %.5f, answered %.5f, of which three tries leave possible %.5f; " +
                "%d corrupted percepts believed, %.3g expected of a 16-bit checksum").format(
                outcomes.confirmations / half.toDouble(), outcomes.answered / half.toDouble(), requests,
                outcomes.corruptBelieved.size, missed,
            ),
            )
            outcomes.wrong.shouldBeEmpty()
            outcomes.twice shouldBe 0
            withClue(outcomes.corruptBelieved) {
                outcomes.corruptBelieved.size shouldBeLessThanOrEqual if (rate < 5e-4) 0 else maxOf(1, most(missed))
            }
            outcomes.confirmations / half.toDouble() shouldBeGreaterThan if (rate < 5e-4) 0.99999 else 0.999
            outcomes.answered / half.toDouble() shouldBeGreaterThan requests - 0.01
        }
    }

    for ((words, timeouts, faults) in listOf<Triple<String, Double, (Long) -> RandomFaults>>(
        Triple("lost", 0.0) { RandomFaults(lost = 1e-3, seed = it) },
        Triple("doubled", 0.0) { RandomFaults(doubled = 1e-3, seed = it) },
        Triple("up to 30 ms late", 0.0) { RandomFaults(late = 1e-3, latestNanos = 30_000_000, seed = it) },
        // 500 ms are too short for three tries
        Triple("up to 400 ms late", 0.1) { RandomFaults(late = 1e-3, latestNanos = 400_000_000, seed = it) },
    )) {
        test("with one byte in 1000 $words no action is carried out twice or wrongly, and no percept is").config(timeout = 30.minutes) {
            val exchanges = maxOf(2_000, EXCHANGES / 10)
            val outcomes = FaultyExchanges(exchanges, faults(11), faults(12))
            report("one byte in 1000 $words", outcomes, exchanges)
            outcomes.wrong.shouldBeEmpty()
            outcomes.twice shouldBe 0
            outcomes.corruptBelieved.shouldBeEmpty()
            val half = exchanges / 2
            outcomes.confirmations / half.toDouble() shouldBeGreaterThan 0.999
            outcomes.answered / half.toDouble() shouldBeGreaterThan inThreeTries(0.0, 1e-3, ASK_BYTES, ANSWER_BYTES) - 0.01 - timeouts
        }
    }

    for ((rate, least) in listOf(1e-5 to 0.99, 1e-4 to 0.99, 1e-3 to 0.6)) {
        test("with one bit in ${(1 / rate).roundToInt()} wrong a version 2 board is found to be one") {
            val found = (1L..LINKS).count { seed ->
                EventLine(FAST, VirtualBoard2(), RandomFaults(rate, seed = seed), RandomFaults(rate, seed = -seed)).use { line ->
                    runCatching { line.link.request(REQUEST, 500).text() }
                    line.link.protocol() == Protocol.V2
                }
            }
            println(
                "measured: one bit in ${(1 / rate).roundToInt()} wrong: " +
                    "$found of $LINKS version 2 boards are found to be that with the first request",
            )
            found / LINKS.toDouble() shouldBeGreaterThan least
        }
    }

    test("a frame of version 2 may be cut, lose, double or delay a byte anywhere, in either direction") {
        val faults = mapOf<String, (ByteArray, Int) -> List<Piece>>(
            "cut" to { bytes, at -> listOf(Piece(bytes.copyOf(at))) },
            "lost" to { bytes, at -> listOf(Piece(bytes.copyOf(at) + bytes.drop(at + 1))) },
            "doubled" to { bytes, at -> listOf(Piece(bytes.copyOf(at + 1) + bytes.drop(at))) },
        ) + listOf(5L, 60, 150, 400).associate { late ->
            "$late ms late" to { bytes: ByteArray, at: Int ->
                listOf(Piece(bytes.copyOf(at)), Piece(bytes.copyOfRange(at, bytes.size), late * 1_000_000))
            }
        }
        var tried = 0
        for ((name, fault) in faults) for (toBoard in listOf(true, false)) for (turn in 2..3) {
            var length = Int.MAX_VALUE
            var at = 0
            while (at < length) {
                val one = OneFault(turn) { bytes -> length = bytes.size; fault(bytes, at) }
                val board = VirtualBoard2().apply { answer = ::ninePercepts }
                withClue("$name at byte $at of write $turn, to the board: $toBoard") {
                    val (there, back) = if (toBoard) one to FAULTLESS else FAULTLESS to one
                    EventLine(FAST.withProtocol(Protocol.V2), board, there, back).use { line ->
                        for (i in 1..3) {
                            val text = line.link.request(REQUEST, 1_000).text()
                            text shouldBe ninePercepts(numberIn(text))
                            line.link.sendAndAwait("speed($i)", 1_000)
                        }
                    }
                    board.handled.filter { REQUEST !in it } shouldContainExactly (1..3).map { "2:speed($it)" }
                }
                at++
                tried++
            }
        }
        println(
            "measured: a frame of version 2 cut, or short of a byte, or with one doubled or late, $tried ways: " +
                "all actions carried out once, all requests answered",
        )
    }

    test("when the plug is pulled every action has been carried out at most once, and each that was confirmed has") {
        val board = VirtualBoard2()
        val confirmed = mutableListOf<String>()
        val name = "pulled"
        var millis = 0.0
        var number = 0
        for (pull in 1..DISCONNECTIONS) {
            EventLine(FAST.withProtocol(Protocol.V2), board, goneAfter = pull * 13L, startMillis = millis, open = owned(name)).use { line ->
                try {
                    while (true) {
                        val action = "speed(${++number})"
                        line.link.sendAndAwait(action, 500)
                        confirmed += action
                        line.link.request(REQUEST, 500).text()
                    }
                } catch (_: PortGoneException) {
                    line.link.isOpen shouldBe false
                    Link.ownerOf(name).isPresent shouldBe false
                }
                millis = line.millis + 1
            }
        }
        val done = board.handled.filter { REQUEST !in it }.map { it.drop(2) }
        println(
            "measured: $DISCONNECTIONS disconnections: $number actions, ${confirmed.size} confirmed, ${done.size} carried out, " +
                "${done.size - done.toSet().size} twice",
        )
        done.toSet().size shouldBe done.size
        (confirmed - done.toSet()).shouldBeEmpty()
    }
})

private fun owned(name: String) = { line: Transport, settings: LinkSettings, clock: LineClock ->
    Link(line, settings, PortOwners.claim(name, "the test"), clock)
}

private const val LINKS = 300
private const val DISCONNECTIONS = 100
