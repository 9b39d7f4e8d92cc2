package javino.link

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import javino.LineSettings
import javino.LineTime
import javino.PortGoneException
import javino.PortInterruptedException
import javino.Protocol
import javino.Transport
import javino.async
import javino.failure
import javino.sim.BoardProgram
import javino.sim.BoardSession
import javino.sim.FakeBoard
import javino.wire.FrameKind
import javino.wire.WireDecoder
import javino.wire.WireFrame
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.CountDownLatch
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.thread
import kotlin.concurrent.withLock
import kotlin.time.Duration.Companion.seconds

private const val LONG_MILLIS = 20_000
private val boards = AtomicInteger()

/** A line to a board that answers at once. The test can drop commands to the board and hold answers back. */
private class LossyLine : Transport {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val arrived = ArrayDeque<ByteArray>()
    private val held = ArrayDeque<ByteArray>()
    private val board = BoardSession(program, BoardSession.Capacity.FULL) { frame, nonce ->
        (if (holdsAnswers && frame.kind() != FrameKind.VOCABULARY) held else arrived) += frame.toBytes(nonce)
    }
    private val decoder = WireDecoder(false, Long.MAX_VALUE / 2, board::nonce) { if (!isLost(it)) board.receive(it) }
    private val limits = ArrayList<Int>()
    private var isWaiting = false
    private var isClosed = false

    /** If true, drops commands and holds answers until [release]. */
    @Volatile
    var holdsAnswers = false

    /** The time limit of the present read in ms, or null if nobody reads. */
    val limit: Int? get() = lock.withLock { limits.lastOrNull().takeIf { isWaiting } }

    @Volatile
    var writes = 0
        private set

    private fun isLost(frame: WireFrame) = holdsAnswers && frame.kind() == FrameKind.COMMANDS

    fun release() = lock.withLock {
        arrived += held
        held.clear()
        changed.signalAll()
    }

    override fun name() = "lossy"

    override fun line() = LineSettings(1_000_000)

    override fun isWritableNow(unread: Long) = true

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) = lock.withLock {
        decoder.accept(b, off, len, 0)
        writes++
        changed.signalAll()
    }

    override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int = lock.withLock {
        limits += timeoutMillis
        isWaiting = true
        while (arrived.isEmpty() && timeoutMillis > 0 && !isClosed) changed.await()
        isWaiting = false
        if (isClosed) throw PortGoneException(name(), "it was closed")
        val bytes = arrived.removeFirstOrNull() ?: return 0
        bytes.copyInto(b, off)
        bytes.size
    }

    override fun close() = lock.withLock {
        isClosed = true
        changed.signalAll()
    }

    private companion object {
        val program = object : BoardProgram {
            override fun carryOut(command: String) = BoardProgram.Outcome.DONE

            override fun percepts(request: String) = "p;"
        }
    }
}

/**
 * Several threads on one link to a version 2 board. Threads that wait for acknowledgements and threads that wait for answers read for
 * each other.
 */
class LinkThreadsSpec : FunSpec({
    fun robot(name: String, work: suspend (FakeBoard, Link) -> Unit) = test(name).config(timeout = 60.seconds, blockingTest = true) {
        FakeBoard.plugIn("threads${boards.incrementAndGet()}").version2().lenient().use { board ->
            Link.open(board.port(), Bench.FAST.withProtocol(Protocol.V2), "the test").use { work(board, it) }
        }
    }

    test("the first command finds out the version while another thread listens").config(timeout = 60.seconds, blockingTest = true) {
        FakeBoard.plugIn("threads${boards.incrementAndGet()}").version2().lenient().use { board ->
            Link.open(board.port(), Bench.FAST.withProtocol(Protocol.AUTO).withBootMillis(0), "the test").use { link ->
                val listener = thread(isDaemon = true) { runCatching { link.listen(LONG_MILLIS) } }
                eventually(20.seconds) { listener.stackTrace.any { it.methodName == "read" } shouldBe true }
                link.sendAndAwait("on", LONG_MILLIS)
                link.protocol() shouldBe Protocol.V2
                listener.isAlive shouldBe true
            }
        }
    }

    robot("requests and actions do not wait for each other, and each action is carried out once, in its order") { board, link ->
        val actions = (1..100).map { "speed($it)" }
        val sender = async { actions.forEach { link.sendAndAwait(it, LONG_MILLIS) } }
        var answers = 0
        while (!sender.isDone) {
            link.request("getPercepts", LONG_MILLIS).text() shouldBe ""
            answers++
        }
        sender.get()
        board.received().filter { it != "getPercepts" } shouldContainExactly actions
        check(answers > 10) { "$answers requests were answered meanwhile" }
    }

    robot("several senders and a listener share the line") { board, link ->
        link.request("getPercepts", LONG_MILLIS).text()
        val listener = async { link.listen(LONG_MILLIS).text() }
        val senders = (1..4).map { n -> async { repeat(25) { link.sendAndAwait("at($n,$it)", LONG_MILLIS) } } }
        senders.forEach { it.get(30, TimeUnit.SECONDS) }
        board.received().count { it.startsWith("at(") } shouldBe 100
        board.send("bump;")
        listener.get(30, TimeUnit.SECONDS) shouldBe "bump;"
    }

    fun lossy(name: String, work: suspend (LossyLine, Link) -> Unit) = test(name).config(timeout = 60.seconds, blockingTest = true) {
        val line = LossyLine()
        val settings = LinkSettings.defaults().withProtocol(Protocol.V2).withPaced(false).withBootMillis(0)
        Link.over(line, settings, LineTime()).use { link -> // each wait ends with a signal or never
            link.request("getPercepts", LONG_MILLIS)
            link.sendAndAwait("on", LONG_MILLIS) // afterwards the board describes itself
            work(line, link)
        }
    }

    suspend fun LossyLine.readsFor(): Int = eventually(20.seconds) { checkNotNull(limit) { "nobody reads" } }

    lossy("who reads looks in time after a frame that was lost, though the thread that would have done so goes") { line, link ->
        line.holdsAnswers = true
        thread(isDaemon = true) { runCatching { link.sendAndAwait("off", LONG_MILLIS) } }
        line.readsFor()
        val writes = line.writes
        val asking = thread(isDaemon = true) { link.request("getPercepts", LONG_MILLIS) }
        eventually(20.seconds) { (line.writes > writes && asking.state == Thread.State.WAITING) shouldBe true }
        line.release()
        asking.join()
        line.readsFor() shouldBeLessThan 500
    }

    lossy("who listens looks in time after a frame that falls due meanwhile") { line, link ->
        thread(isDaemon = true) { runCatching { link.listen(LONG_MILLIS) } }
        line.readsFor() shouldBeLessThan 500
    }

    for (protocol in listOf(Protocol.V1, Protocol.V2)) {
        test("each command has an outcome, whenever the link is closed: $protocol").config(timeout = 60.seconds, blockingTest = true) {
            FakeBoard.plugIn("threads${boards.incrementAndGet()}").version2().lenient().use { board ->
                repeat(60) {
                    Link.open(board.port(), Bench.FAST.withProtocol(protocol), "the test").use { link ->
                        val writer = async { runCatching { link.writeCommandsUntilClosed() } }
                        val outcomes = CopyOnWriteArrayList<CompletableFuture<Void>>()
                        val mayClose = CountDownLatch(1 + it % 20) // closes while other commands are sent
                        val sender = async {
                            while (link.isOpen && outcomes.size < 500) { // on a busy machine the number would grow without end
                                outcomes += link.send("front", SendOptions.defaults())
                                mayClose.countDown()
                            }
                        }
                        mayClose.await()
                        link.close()
                        sender.get()
                        writer.get()
                        for (outcome in outcomes) {
                            val failure = runCatching { outcome.get(20, TimeUnit.SECONDS) }.exceptionOrNull()
                            if (failure != null) failure.shouldBeInstanceOf<ExecutionException>()
                        }
                    }
                }
            }
        }
    }

    robot("who waits for an acknowledgement is told when the plug is pulled, or the link closed") { board, link ->
        link.request("getPercepts", LONG_MILLIS).text()
        board.whenAsked("walk").after(LONG_MILLIS)
        val sender = async { link.sendAndAwait("walk", LONG_MILLIS) }
        val next = async { link.sendAndAwait("walk", LONG_MILLIS) }
        eventually(20.seconds) { board.received() shouldContain "walk" }
        link.close()
        sender.failure().shouldBeInstanceOf<PortGoneException>()
        next.failure().shouldBeInstanceOf<PortGoneException>()
    }

    robot("an interrupted sender throws, and the link stays usable") { board, link ->
        link.request("getPercepts", LONG_MILLIS)
        board.whenAsked("walk").after(3_000) // longer than the time until the interrupt
        val failure = CompletableFuture<Throwable?>()
        val sender = thread(isDaemon = true) { failure.complete(runCatching { link.sendAndAwait("walk", LONG_MILLIS) }.exceptionOrNull()) }
        eventually(20.seconds) { board.received() shouldContain "walk" }
        sender.interrupt()
        failure.get(20, TimeUnit.SECONDS).shouldBeInstanceOf<PortInterruptedException>()
        link.request("getPercepts", LONG_MILLIS)
    }
})
