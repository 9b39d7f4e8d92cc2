package javino.link

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import javino.ActionUnconfirmedException
import javino.CommandReplacedException
import javino.CommandWithdrawnException
import javino.LineClock
import javino.PortGoneException
import javino.Protocol
import javino.Transport
import javino.Transports
import javino.async
import javino.failure
import javino.sim.FakeBoard
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import kotlin.time.Duration.Companion.seconds
import io.kotest.matchers.string.shouldContain as shouldContainText

private const val LIMIT_S = 30L
private const val LIMIT_MS = 20_000
private val boards = AtomicInteger()
private val URGENT = SendOptions(true, 0)

/** Tests the queue of a line, whose commands a separate thread writes. */
class LinkQueueSpec : FunSpec({
    fun robot(name: String, protocol: Protocol, work: suspend (FakeBoard, Link) -> Unit) =
        test("$name: $protocol").config(timeout = 60.seconds, blockingTest = true) {
            FakeBoard.plugIn("queue${boards.incrementAndGet()}").lenient().apply { if (protocol == Protocol.V2) version2() }.use { board ->
                val settings = Bench.FAST.withBootMillis(0).withProtocol(protocol)
                val line = Transports.open(board.port(), settings.line())
                val slow = object : Transport by line {
                    override fun isWritableNow(unread: Long) = false // commands wait for the writing thread
                }
                Link.over(slow, settings, LineClock.system()).use { work(board, it) }
            }
        }

    fun link(name: String, work: suspend (FakeBoard, Link) -> Unit) = listOf(Protocol.V1, Protocol.V2).forEach { robot(name, it, work) }

    fun Link.writing() = async { writeCommandsUntilClosed() }

    link("commands go out in their order, urgent ones before the others, once a thread writes") { board, link ->
        val ordinary = listOf("a", "b", "c").map { link.send(it, SendOptions.defaults()) }
        val sent = ordinary + link.send("now", URGENT) + link.send("next", URGENT)
        sent.none { it.isDone } shouldBe true
        link.writing()
        sent.forEach { it.get(LIMIT_S, TimeUnit.SECONDS) }
        eventually(20.seconds) { board.received() shouldContainExactly listOf("now", "next", "a", "b", "c") }
    }

    link("a command whose time is over before it begins to go out never does") { board, link ->
        val late = link.send("late", SendOptions(false, 1))
        val failure = late.failure().shouldBeInstanceOf<CommandWithdrawnException>()
        failure.message shouldContainText "\"late\" had not begun to go out through port ${link.port()}"
        link.writing()
        link.send("after", SendOptions.defaults()).get(LIMIT_S, TimeUnit.SECONDS)
        eventually(20.seconds) { board.received() shouldContainExactly listOf("after") }
    }

    link("the latest command takes the place of those of its functor that wait, which fail with what replaced them") { board, link ->
        val old = link.send("speed(1)", SendOptions.defaults())
        val sent = listOf("a", "speedy(1)").map { link.send(it, SendOptions.defaults()) } +
            link.send("speed(2)", SendOptions(false, 0, true))
        old.failure().shouldBeInstanceOf<CommandReplacedException>().message shouldContainText "\"speed(2)\" took its place"
        val urgent = link.send("a(1)", SendOptions(true, 0, true))
        sent[0].failure().shouldBeInstanceOf<CommandReplacedException>()
        link.writing()
        (sent.drop(1) + urgent).forEach { it.get(LIMIT_S, TimeUnit.SECONDS) }
        eventually(20.seconds) { board.received() shouldContainExactly listOf("a(1)", "speed(2)", "speedy(1)") }
    }

    link("a command that is cancelled while it waits does not go out") { board, link ->
        link.send("no", SendOptions.defaults()).cancel(false)
        link.writing()
        link.send("after", SendOptions.defaults()).get(LIMIT_S, TimeUnit.SECONDS)
        eventually(20.seconds) { board.received() shouldContainExactly listOf("after") }
    }

    link("what a command's dependents throw ends no thread, and no other command") { board, link ->
        link.writing()
        repeat(3) { n -> link.send("say($n)", SendOptions.defaults()).whenComplete { _, _ -> error("unforeseen") } }
        link.send("after", SendOptions.defaults()).get(LIMIT_S, TimeUnit.SECONDS)
        eventually(20.seconds) { board.received() shouldContainExactly listOf("say(0)", "say(1)", "say(2)", "after") }
    }

    link("commands that wait fail when the link is closed, and later ones at once") { _, link ->
        val waiting = link.send("a", SendOptions.defaults())
        link.close()
        waiting.failure().shouldBeInstanceOf<PortGoneException>()
        link.send("b", SendOptions.defaults()).failure().shouldBeInstanceOf<PortGoneException>()
    }

    link("a thread that sends and waits takes the commands before its own along") { board, link ->
        val before = link.send("a", SendOptions.defaults())
        link.sendAndAwait("b", LIMIT_MS)
        before.isDone shouldBe true
        eventually(20.seconds) { board.received() shouldContainExactly listOf("a", "b") }
    }

    robot("a command that is under way when its time is over may have been carried out", Protocol.V2) { board, link ->
        board.whenAsked("walk").after(LIMIT_MS)
        link.writing()
        link.send("walk", SendOptions(false, 300)).failure().shouldBeInstanceOf<ActionUnconfirmedException>()
        val next = link.send("stop", SendOptions(false, LIMIT_MS))
        eventually(20.seconds) { board.received() shouldContain "walk" }
        next.isCompletedExceptionally shouldBe false
    }

    robot("a request gives way to the commands before it, but not for ever", Protocol.V1) { board, link ->
        board.whenAsked("getPercepts").answer("dist(f,1);")
        val stuck = link.send("a", SendOptions.defaults()) // no thread writes it
        val start = System.nanoTime()
        link.request({ "getPercepts" }, LIMIT_MS, 40).text() shouldBe "dist(f,1);"
        System.nanoTime() - start shouldBeGreaterThan TimeUnit.MILLISECONDS.toNanos(80)
        stuck.isDone shouldBe false
        link.writing()
        stuck.get(LIMIT_S, TimeUnit.SECONDS)
        link.request({ "getPercepts" }, LIMIT_MS, 40)
        eventually(20.seconds) { board.received() shouldContainExactly listOf("getPercepts", "a", "getPercepts") }
    }
})
