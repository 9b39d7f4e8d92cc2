package javino.session

import javino.wire.CriticalReport
import javino.wire.FrameKind
import javino.wire.Welcome
import javino.wire.WireFrame
import java.util.SplittableRandom

internal class Order(private val words: String) : SessionCommand {
    var isGivenUp = false
    override fun text() = words
    override fun isOver() = isGivenUp
    override fun toString() = words
}

/** A session. The test passes frames and time to it. */
internal class SessionProbe(answerLimit: Int = 65_536, seed: Long = 1) : SessionListener<Order>, WaitingCommands<Order> {
    var now = 0L
    val waiting = ArrayDeque<Order>()
    val outcomes = mutableListOf<Pair<Order, CommandOutcome>>()
    val answers = mutableListOf<String>()
    val heard = mutableListOf<String>()
    val reports = mutableListOf<CriticalReport>()
    var boards = 0
    var sessions = 0
    var lapses = 0
    val otherRevisions = mutableListOf<Int>()
    var dropped = 0
    val unreadable = mutableListOf<FrameKind>()
    val undescribed = mutableListOf<Pair<Int, Int>>()
    val session = ComputerSession(BYTE_NANOS, answerLimit, SplittableRandom(seed), this)

    fun offer(vararg texts: String): List<Order> = texts.map(::Order).also(waiting::addAll)

    /** Returns the next frame and marks it as written now. */
    fun next(): WireFrame? = session.next(now, this)?.also { session.wrote(now) }

    fun all(): List<WireFrame> = generateSequence(::next).toList()

    fun after(millis: Int): SessionProbe = apply { now += millis * 1_000_000L }

    fun receive(frames: List<WireFrame>) = frames.forEach { session.received(it, now) }

    /** Lets the board answer until neither side sends anything. */
    fun exchangeWith(board: BoardModel) {
        for (frame in generateSequence(::next)) receive(board.received(frame))
    }

    override fun head(): Order? {
        while (waiting.firstOrNull()?.isGivenUp == true) waiting.removeFirst()
        return waiting.firstOrNull()
    }

    override fun begin() {
        waiting.removeFirst()
    }

    override fun found() {
        boards++
    }

    override fun unreadable(kind: FrameKind) {
        unreadable += kind
    }

    override fun undescribed(described: Int, total: Int) {
        undescribed += described to total
    }

    override fun otherRevision(revision: Int) {
        otherRevisions += revision
    }

    override fun began(welcome: Welcome) {
        sessions++
    }

    override fun ended(command: Order, outcome: CommandOutcome) {
        outcomes += command to outcome
    }

    override fun answered(percepts: String) {
        answers += percepts
    }

    override fun heard(percepts: String) {
        heard += percepts
    }

    override fun dropped() {
        dropped++
    }

    override fun reported(report: CriticalReport) {
        reports += report
    }

    override fun lapsed() {
        lapses++
        session.open(now)
    }

    companion object {
        const val BYTE_NANOS = 86_805L
    }
}
