package javino.virtual

import javino.PerceptsRequest
import javino.Protocol
import javino.Transport
import javino.link.BoardListener
import javino.link.LinkSettings
import javino.link.SendOptions
import javino.wire.BoardAction
import javino.wire.BoardRule
import javino.wire.ReflexOutcome
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import kotlin.random.Random

/** A measured time and its bound, in ns. */
internal class Closest(val measured: Long, val bound: Long, val course: BoundsCase) {
    val share: Double get() = measured.toDouble() / bound

    override fun toString() = "$measured of $bound ns, $course"
}

/** Makes exchanges on [course] in virtual time, and compares their times with the bounds. */
internal class BoundsRun(private val course: BoundsCase, private val random: Random) : AutoCloseable {
    private var escapes = 0
    private var alarm: Pair<Long, () -> Unit>? = null
    private val sketch = Sketch()
    private val bounds = Bounds(course)
    private val line: EventLine = EventLine(
        LinkSettings.defaults().withBaud(course.baud).withProtocol(Protocol.V2).withBootMillis(0),
        Alarmed(LoopBoard(course.times, course.byteNanos, random, sketch, listOf(BoardAction("stop", 0), BoardAction("speed", 1)))),
        ::count, ::count,
    )
    private val link get() = line.link
    private val now get() = line.clock.nanos()

    var exchanges = 0
        private set

    /** For each bound, the measurement that came closest to it or exceeded it most. */
    val closest = HashMap<Bounded, Closest>()

    init {
        repeat(3) { request() }
        settle(link.send("stop", URGENT)) // also waits for the vocabulary, which the session requests after the command
        if (course.hasRules) {
            link.onBoardEvents(Reports())
            settle(link.sendRule(RULE.setting(1), URGENT))
        }
        rest()
    }

    /** Counts the escape bytes, which the bounds leave out. */
    private fun count(bytes: ByteArray): List<Piece> {
        escapes += bytes.count { it == ESCAPE }
        return FAULTLESS.pass(bytes)
    }

    fun step() = if (course.hasRules) when (random.nextInt(4)) {
        0 -> answer()
        1 -> urgent()
        2 -> plan()
        else -> reflex()
    } else when (random.nextInt(4)) {
        0 -> answer()
        1 -> command()
        2 -> urgent()
        else -> plan()
    }

    private fun request() = link.request(PerceptsRequest.ALL, LIMIT_MS).text().also { exchanges++ }

    private fun settle(outcome: CompletableFuture<Void>) {
        while (!outcome.isDone) link.watch(1)
        outcome.join()
        exchanges++
    }

    /** Waits until the line is silent. A request may get a second answer. Then waits until a random point of the board's loop. */
    private fun rest() {
        link.watch(1 + TimeUnit.NANOSECONDS.toMillis(bounds.answer() + course.byteNanos * 100).toInt())
        await(now + random.nextLong(2 * course.times.loop))
    }

    private fun await(nanos: Long) {
        while (now < nanos) line.pass(nanos - now)
    }

    private fun record(what: Bounded, measured: Long, bound: Long) {
        val found = Closest(measured, bound + escapes * course.byteNanos + ROUNDING, course)
        if (found.share > (closest[what]?.share ?: -1.0)) closest[what] = found
    }

    private fun answer() {
        rest()
        escapes = 0
        val start = now
        request()
        record(if (course.hasRules) Bounded.PARTS else Bounded.ANSWER, now - start, bounds.answer())
    }

    private fun command() {
        rest()
        escapes = 0
        val start = now
        val text = sketch.await("speed(${random.nextInt(10, 100)})")
        var endedAt = 0L
        settle(link.send(text, SendOptions.defaults()).thenRun { endedAt = now })
        record(Bounded.COMMAND, sketch.begunAt - start, bounds.command(text.length + Bounds.AROUND_COMMAND))
        record(Bounded.OUTCOME, endedAt - start, bounds.outcome(text.length + Bounds.AROUND_COMMAND))
    }

    private fun urgent() {
        rest()
        escapes = 0
        val others = List(random.nextInt(20)) { link.send("speed(${random.nextInt(10)})", SendOptions.defaults()) }
        val text = "speed(${random.nextInt(10, 100)})"
        var outcome: CompletableFuture<Void>? = null
        var start = 0L
        alarm = now + random.nextLong(bounds.answer()) to {
            start = now
            sketch.await(text)
            outcome = link.send(text, URGENT)
        }
        request()
        while (outcome == null) link.watch(1)
        settle(checkNotNull(outcome))
        record(Bounded.URGENT, sketch.doneAt - start, bounds.urgent(text.length + Bounds.AROUND_COMMAND, sketch.before))
        others.forEach(::settle)
    }

    /** Requests percepts at the interval until a percept is new. Then sends a command because of that percept. */
    private fun plan() {
        rest()
        escapes = 0
        var start = 0L
        alarm = now + random.nextLong(2 * course.intervalMs * NANOS_PER_MS) to {
            start = now
            sketch.news++
        }
        val known = sketch.news
        while (true) {
            val asked = now
            val news = link.request({ PerceptsRequest.ALL }, LIMIT_MS, course.intervalMs).text().substringAfter('(').substringBefore(')')
            exchanges++
            if (news.toInt() != shown(known)) break
            watchUntil(asked + course.intervalMs * NANOS_PER_MS)
        }
        val text = sketch.await("speed(${random.nextInt(10, 100)})")
        settle(link.send(text, URGENT))
        record(Bounded.PLAN, sketch.begunAt - start, bounds.planFromAnswer(text.length + Bounds.AROUND_COMMAND))
    }

    private fun watchUntil(nanos: Long) {
        while (nanos - now >= NANOS_PER_MS) link.watch(minOf(SLICE_MS, TimeUnit.NANOSECONDS.toMillis(nanos - now)).toInt())
        await(nanos)
    }

    /** Makes a rule match while percepts are requested. The computer sends a command because of the board's report. */
    private fun reflex() {
        rest()
        escapes = 0
        var start = 0L
        val text = "speed(${random.nextInt(10, 100)})"
        var outcome: CompletableFuture<Void>? = null
        var reflexAt = 0L
        sketch.await(REFLEX)
        reported = {
            reflexAt = sketch.begunAt
            sketch.await(text)
            outcome = link.send(text, URGENT)
        }
        alarm = now + random.nextLong(2 * bounds.answer()) to {
            start = now
            sketch.isNear = true
        }
        while (outcome == null) {
            request()
            link.watch(1)
        }
        settle(checkNotNull(outcome))
        exchanges++
        record(Bounded.REFLEX, reflexAt - start, bounds.reflex())
        record(
            Bounded.REPORT, sketch.begunAt - start,
            bounds.planFromReport(NEAR.length + Bounds.AROUND_REPORT, text.length + Bounds.AROUND_COMMAND),
        )
        sketch.isNear = false
        watchUntil(now + 2 * bounds.reflex()) // enough time for the board to see the change
    }

    private var reported: () -> Unit = {}

    private inner class Reports : BoardListener {
        override fun critical(rule: Int, outcome: ReflexOutcome, percept: String, receivedNanos: Long) = reported()

        override fun sessionBegan(rules: Int) = Unit
    }

    override fun close() = line.close()

    /** Runs the action of [alarm] when it is due. */
    private inner class Alarmed(private val board: EventBoard) : EventBoard {
        override val dueMillis: Double get() = minOf(board.dueMillis, alarm?.let { it.first / 1e6 } ?: Double.POSITIVE_INFINITY)

        override fun look(end: Transport, now: Double) {
            val (at, action) = alarm ?: (Long.MAX_VALUE to {})
            if (at <= Math.round(now * 1e6)) {
                alarm = null
                action()
                line.wake()
            }
            board.look(end, now)
        }
    }

    private inner class Sketch : TimedSketch {
        var news = 0
        var isNear = false
        var begunAt = 0L
            private set
        var doneAt = 0L
            private set

        /** Number of commands under way at [await], plus those carried out between [await] and the awaited command. */
        var before = 0
            private set
        private var awaited: String? = null
        private val ends = ArrayDeque<Long>() // times at which the last commands ended
        private val others = List(course.percepts) { i -> "dist(${('a' + i % 26).toString().repeat(1 + i / 26)},%s);" }.joinToString("")

        /** Records when the board carries out [command]. */
        fun await(command: String): String {
            awaited = command
            before = ends.count { it > now }
            return command
        }

        override fun percepts(nanos: Long): String {
            val values = Array(course.percepts) { "${random.nextInt(9) + 1}".repeat(course.digits) }
            return "news(${shown(news)});${if (isNear) NEAR else FAR}" + others.format(*values)
        }

        override fun carriedOut(command: String, fromNanos: Long, toNanos: Long) {
            if (command != awaited) {
                before++
                ends += toNanos
                if (ends.size > MAX_OUT) ends.removeFirst()
                return
            }
            awaited = null
            begunAt = fromNanos
            doneAt = toNanos
        }
    }

    private companion object {
        const val ESCAPE = 0xA4.toByte()
        const val LIMIT_MS = 5_000
        const val NANOS_PER_MS = 1_000_000L
        const val SLICE_MS = 10L
        const val REFLEX = "stop"

        /** The most unacknowledged commands. */
        const val MAX_OUT = 16
        const val NEAR = "near(1);"
        const val FAR = "near(0);"

        /** An allowance for the rounding of event times, in ns. */
        const val ROUNDING = 10_000L

        /** Returns two digits that stand for the number [news] in percepts. */
        fun shown(news: Int) = 10 + news % 90
        val URGENT = SendOptions(true, 0)
        val RULE = BoardRule("near", listOf(BoardRule.Condition(1, BoardRule.Operator.EQUAL, "1")), REFLEX)
    }
}
