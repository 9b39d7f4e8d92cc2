package argo.jason

import argo.FussyProvider
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.longs.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.Frame
import javino.LineSettings
import javino.Transport
import javino.Transports
import javino.sim.BoardProgram
import javino.sim.BoardSession
import javino.sim.PseudoTerminals
import javino.sim.SimulatedBoard
import javino.sim.SimulatedBoards
import javino.wire.AnswerPart
import javino.wire.FrameKind
import javino.wire.WireDecoder
import javino.wire.WireFrame
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

private const val LIMIT_BYTES = 1024L

/**
 * Frames of a compressed answer that stands for a gigabyte of text. The first frame teaches 126 percepts of 255 bytes. The second repeats
 * all of them 32,000 times, with two bytes each time.
 */
private val BOMBS = listOf(
    (0 until 126).joinToString("") { "${it.toChar()}\u00ff" + "a".repeat(255) },
    "\u0080\u007e".repeat(32_000),
)

/** A board of version 2 that answers with [BOMBS], and carries out all commands. */
private class BombingBoard : SimulatedBoard, BoardProgram {
    val commands = CopyOnWriteArrayList<String>()

    @Volatile
    var answers = 0

    override fun carryOut(command: String) = BoardProgram.Outcome.DONE.also { commands += command }

    override fun percepts(request: String) = "p;"

    override fun run(line: Transport) {
        val session = BoardSession(this, BoardSession.Capacity.FULL) { frame, nonce ->
            if (frame.kind() == FrameKind.PERCEPTS) bomb(line, frame, nonce) else line.say(frame, nonce)
        }
        val decoder = WireDecoder(false, Long.MAX_VALUE / 2, session::nonce, session::receive)
        val buffer = ByteArray(256)
        while (true) decoder.accept(buffer, 0, line.read(buffer, 0, buffer.size, 1000), System.nanoTime())
    }

    private fun bomb(line: Transport, answer: WireFrame, nonce: Int) =
        AnswerPart.split(answer.payload()[0].code, BOMBS[answers++ % 2])
            .forEach { line.say(WireFrame.of(it.kind(), answer.number(), it.payload()), nonce) }

    private fun Transport.say(frame: WireFrame, nonce: Int) = frame.toBytes(nonce).let { write(it, 0, it.size, 60_000) }
}

/** A line that notes which threads write to it, how many bytes, and which threads would wait. */
private class NotedLine(private val line: Transport, private val bytes: MutableMap<String, Long>, private val waiting: MutableSet<String>) :
    Transport by line {
    override fun isWritableNow(unread: Long) = line.isWritableNow(unread)

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) {
        bytes.merge(Thread.currentThread().name, len.toLong(), Long::plus)
        if (timeoutMillis > 0) waiting += Thread.currentThread().name
        line.write(b, off, len, timeoutMillis)
    }
}

class HostileBoardsSpec : FunSpec({
    afterTest { FussyProvider.opening = FussyProvider::openSimulated }

    test("an answer that stands for a gigabyte is dropped with a line of log, and the agent goes on acting") {
        val board = BombingBoard()
        SimulatedBoards.plugIn("bomb", board)
        try {
            LocalMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:bomb", [baud(10000000), boot(0), timeout(2000)]);
                        argo.limit(0); argo.percepts(open); !beat(1).
                    +!beat(N) <- argo.act(beat(N)); .wait(5); !beat(N+1).
                    +port(_,timeout) <- +unanswered.
                """)
                eventually(LIMIT) { board.answers shouldBeGreaterThan 4 }
                val before = board.commands.size
                eventually(LIMIT) { board.commands.size shouldBeGreaterThan before + 20 }
                mas.awaitBelief("bob", "unanswered")
                mas.log shouldContain "sent percepts of more than 65536 bytes, which are dropped"
                mas.beliefs("bob").filter { it.length > 65_536 }.size shouldBe 0
            }
        } finally {
            SimulatedBoards.unplug("bomb")
        }
    }

    test("a far end that talks and does not read holds up neither agent nor reflexes").config(enabledOrReasonIf = { withTerminals }) {
        val bytes = ConcurrentHashMap<String, Long>()
        val waiting = ConcurrentHashMap.newKeySet<String>()
        val terminals = PseudoTerminals.open()
        val far = Transports.open(terminals.board().path, LineSettings(1_000_000))
        val talk = Frame.of("dist(front,1);").toBytes()
        val talking = thread(isDaemon = true) {
            runCatching {
                while (true) {
                    far.write(talk, 0, talk.size, 60_000)
                    TimeUnit.MILLISECONDS.sleep(5)
                }
            }
        }
        FussyProvider.opening = { _, line -> NotedLine(Transports.open(terminals.computer().path, line), bytes, waiting) }
        try {
            LocalMas().use { mas ->
                mas.file("near.xml", """
                    <PerceptionFilter><critical reflex="stop"><predicate>dist</predicate></critical></PerceptionFilter>
                """.trim())
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("fussy:deaf", [baud(1000000), boot(0), spacing(0), protocol(1)]);
                        argo.change_filter(near); argo.limit(5);
                        argo.percepts(open); .wait(dist(_,_)); for (.range(I,1,10000)) { !!act(I) }.
                    +!act(I) <- argo.act(say("${"x".repeat(180)}",I), [timeout(200)]); +sent(I).
                    -!act(I)[error(E)] <- +failed(I,E).
                    +!reach(G) <- +reached(G).
                """)
                val clue = { mas.log.take(2_000) + mas.beliefs("bob").take(5) }
                awaitGrowth(1_001, clue) { mas.beliefs("bob").count { it.startsWith("failed(") } }
                repeat(10) {
                    mas.achieve("bob", "reach(g$it)")
                    mas.awaitBelief("bob", "reached(g$it)")
                }
                awaitGrowth(10_000, clue) { mas.beliefs("bob").count { it.startsWith("failed(") || it.startsWith("sent(") } }
                mas.beliefs("bob").filter { it.startsWith("failed(") }.map { it.substringAfter(',').dropLast(1) }.toSet()
                    .filterNot { it in setOf("act_timeout", "act_unconfirmed") }.shouldBeEmpty()
                (waiting.filterNot { it.startsWith("argo-bob-") }).shouldBeEmpty()
                bytes.filterKeys { !it.startsWith("argo-bob-") }.values.sum() shouldBeLessThanOrEqual LIMIT_BYTES
                eventually(LIMIT) { mas.log.lines().filter { "does not read; this is not reported again" in it }.size shouldBe 1 }
            }
        } finally {
            talking.interrupt()
            terminals.close()
            far.close()
        }
    }
})
