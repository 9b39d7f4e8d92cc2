package javino.session

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldBeSorted
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import javino.wire.BoardAction
import javino.wire.WireFrame
import java.util.SplittableRandom

private const val COMMANDS = 200

/** One direction of a line. Frames stay in order. Some are late, some are lost, some arrive twice. */
private class Way(private val random: SplittableRandom, private val loss: Double) {
    private val frames = ArrayDeque<Pair<Long, WireFrame>>()
    private var lastAt = 0L
    var lost = 0

    fun put(frame: WireFrame, now: Long) {
        lastAt = maxOf(lastAt, now + random.nextLong(1_000_000, 30_000_000))
        if (random.nextDouble() < loss) lost++ else frames += lastAt to frame
    }

    fun take(now: Long): List<WireFrame> {
        val taken = frames.takeWhile { it.first <= now }
        repeat(taken.size) { frames.removeFirst() }
        return taken.map { it.second }
    }
}

/** A session and a board on a line that loses frames, and the outcomes of [COMMANDS] commands. */
private class Run(seed: Long, loss: Double, restarts: Double) {
    private val random = SplittableRandom(seed)
    private val there = Way(random.split(), loss)
    private val back = Way(random.split(), loss)
    private val probe = SessionProbe(seed = seed)
    val carriedOut = mutableListOf<String>()
    private val board = BoardModel(
        listOf(BoardAction("stop", 0)), random.nextInt(10, 100), { "n(${carriedOut.size});level(${carriedOut.size % 7},on);" }, ::act,
    )
    private var finishAt = Long.MAX_VALUE
    private var restarted = 0
    val outcomes get() = probe.outcomes.associate { it.first.text() to it.second }
    val answers get() = probe.answers
    val refused = mutableSetOf<String>()
    val lapses get() = probe.lapses

    private fun act(text: String): Boolean? = when {
        "refused" in text -> false.also { refused += text }
        "long" in text -> null.also { finishAt = probe.now + random.nextLong(1_000_000, 400_000_000) }.also { carriedOut += text }
        else -> true.also { carriedOut += text }
    }

    init {
        probe.session.open(0)
        var offered = 0
        while (probe.outcomes.size < COMMANDS) {
            if (offered < COMMANDS && probe.waiting.size < 20 && random.nextInt(4) == 0) {
                probe.offer(listOf("c", "c", "c", "refused", "long")[random.nextInt(5)] + "(${offered++})")
            }
            if (random.nextInt(20) == 0) probe.session.request("", probe.now)
            step(restarts)
            check(probe.now < 600_000_000_000) { "of $offered commands ${probe.outcomes.size} have an outcome" }
        }
    }

    private fun step(restarts: Double) {
        probe.after(1)
        if (random.nextDouble() < restarts) {
            board.restart()
            finishAt = Long.MAX_VALUE
            restarted++
        }
        probe.next()?.let { there.put(it, probe.now) }
        if (finishAt <= probe.now) {
            finishAt = Long.MAX_VALUE
            back.put(board.finish(), probe.now)
        }
        for (frame in there.take(probe.now)) board.received(frame).forEach { back.put(it, probe.now) }
        probe.receive(back.take(probe.now))
    }
}

class ComputerSessionPropertySpec : FunSpec({
    fun numbers(texts: Collection<String>) = texts.map { it.substringAfter('(').dropLast(1).toInt() }

    for (loss in listOf(0.0, 0.02, 0.2, 0.4)) for (restarts in listOf(0.0, 0.001)) {
        test("with $loss of the frames lost and $restarts restarts a millisecond each command is carried out once, in order, as is said") {
            for (seed in 1L..25) withClue("seed $seed") {
                val run = Run(seed, loss, restarts)
                numbers(run.carriedOut).shouldBeUnique().shouldBeSorted()
                for ((text, outcome) in run.outcomes) withClue(text) {
                    when (outcome) {
                        CommandOutcome.DONE -> check(text in run.carriedOut)
                        CommandOutcome.REFUSED -> check(text in run.refused && text !in run.carriedOut)
                        else -> check(restarts > 0 || run.lapses > 0) { "the outcome is not known" }
                    }
                }
                if (loss < 0.1 && restarts == 0.0) run.outcomes.filterValues { it == CommandOutcome.UNCONFIRMED }.keys.shouldBeEmpty()
                run.answers.size shouldBeGreaterThan 0
                run.answers.count { !Regex("n\\(\\d+\\);level\\([0-6],on\\);").matches(it) } shouldBe 0
            }
        }
    }
})
