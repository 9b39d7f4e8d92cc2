package javino

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import javino.sim.FakeBoard
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import kotlin.concurrent.thread
import kotlin.time.Duration.Companion.seconds

private const val LONG_MILLIS = 20_000
private val boards = AtomicInteger()

/** Several threads on one link to a version 2 board: who waits for an acknowledgement and who for an answer read for each other. */
class LinkThreadsSpec : FunSpec({
    fun robot(name: String, work: suspend (FakeBoard, Link) -> Unit) = test(name).config(timeout = 60.seconds, blockingTest = true) {
        FakeBoard.plugIn("threads${boards.incrementAndGet()}").version2().lenient().use { board ->
            Link.open(board.port(), Bench.FAST.withProtocol(Protocol.V2), "the test").use { work(board, it) }
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

    for (protocol in listOf(Protocol.V1, Protocol.V2)) {
        test("each command has an outcome, whenever the link is closed: $protocol").config(timeout = 60.seconds, blockingTest = true) {
            FakeBoard.plugIn("threads${boards.incrementAndGet()}").version2().lenient().use { board ->
                repeat(60) {
                    Link.open(board.port(), Bench.FAST.withProtocol(protocol), "the test").use { link ->
                        val writer = async { runCatching { link.writeCommandsUntilClosed() } }
                        val outcomes = CopyOnWriteArrayList<CompletableFuture<Void>>()
                        val sender = async { while (link.isOpen) outcomes += link.send("front", SendOptions.defaults()) }
                        Thread.sleep(1)
                        link.close()
                        sender.get()
                        writer.get()
                        for (outcome in outcomes) {
                            val failure = runCatching { outcome.get(10, TimeUnit.SECONDS) }.exceptionOrNull()
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
        board.whenAsked("walk").after(1_500)
        val failure = CompletableFuture<Throwable?>()
        val sender = thread(isDaemon = true) { failure.complete(runCatching { link.sendAndAwait("walk", LONG_MILLIS) }.exceptionOrNull()) }
        eventually(20.seconds) { board.received() shouldContain "walk" }
        sender.interrupt()
        failure.get(20, TimeUnit.SECONDS).shouldBeInstanceOf<PortInterruptedException>()
        link.request("getPercepts", LONG_MILLIS)
    }
})
