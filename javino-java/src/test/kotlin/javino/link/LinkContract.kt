package javino.link

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeInstanceOf
import javino.PortBusyException
import javino.PortGoneException
import javino.PortTimeoutException
import javino.async
import javino.failure
import javino.sim.FakeBoard
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.time.Duration.Companion.seconds

/** A board that can be reached at [port], and a function that unplugs it. */
internal class Bench(val port: String, val board: FakeBoard, val unplug: () -> Unit, private val release: () -> Unit) : AutoCloseable {
    val link: Link by lazy { open() }
    private val links = mutableListOf<Link>()

    fun open(settings: LinkSettings = FAST, owner: String = "the test"): Link = Link.open(port, settings, owner).also(links::add)

    override fun close() {
        links.forEach(Link::close)
        release()
    }

    companion object {
        val FAST: LinkSettings = LinkSettings.defaults().withBaud(115_200)
    }
}

private const val LONG_MILLIS = 20_000

/** More late answers than the line can hold in this contract. */
private const val MAX_LATE = 10

/** The contract of a link over any transport. A subclass supplies the board. */
internal abstract class LinkContract(available: Enabled, bench: () -> Bench) : FunSpec({
    fun contract(name: String, body: Bench.() -> Unit) =
        test(name).config(enabledOrReasonIf = { available }, timeout = 60.seconds, blockingTest = true) { bench().use(body) }

    contract("a request brings its answer") {
        board.whenAsked("getPercepts").answer("dist(f,10);", "dist(f,9);")
        link.request("getPercepts", LONG_MILLIS).text() shouldBe "dist(f,10);"
        link.request("getPercepts", LONG_MILLIS).text() shouldBe "dist(f,9);"
        board.verify()
    }

    contract("the longest message comes through in both directions") {
        val longest = String(CharArray(255) { (it + 1).toChar() })
        board.whenAsked(longest).answer(longest)
        link.request(longest, LONG_MILLIS).text() shouldBe longest
    }

    contract("an empty answer is an answer") {
        board.whenAsked("getPercepts").answer("")
        link.request("getPercepts", LONG_MILLIS).text() shouldBe ""
    }

    contract("actions reach the board in their order") {
        val actions = (1..20).map { "speed($it)" }
        actions.forEach { link.sendAndAwait(it, LONG_MILLIS) }
        actions.map { board.awaitMessage(LONG_MILLIS) } shouldContainExactly actions
        board.verify()
    }

    contract("listening brings what the board sends of its own accord") {
        link.request("getPercepts", LONG_MILLIS).text()
        board.send("bump(front);")
        link.listen(LONG_MILLIS).text() shouldBe "bump(front);"
    }

    contract("listening waits no longer than its time limit") {
        shouldThrow<PortTimeoutException> { link.listen(20).text() }.message shouldContain "20 ms"
    }

    contract("a silent board is a timeout, and the link stays usable") {
        link.request("getPercepts", LONG_MILLIS).text()
        board.whenAsked("getPercepts").staySilent()
        val timeout = shouldThrow<PortTimeoutException> { link.request("getPercepts", 50).text() }
        timeout.port() shouldBe port
        timeout.message shouldContain "50 ms"
        board.whenAsked("getPercepts").answer("dist(f,10);")
        link.request("getPercepts", LONG_MILLIS).text() shouldBe "dist(f,10);"
    }

    contract("noise in front of an answer costs nothing") {
        board.whenAsked("getPercepts").answerRaw("fffeZZ\u0000\u00ffffffe05hello")
        link.request("getPercepts", LONG_MILLIS).text() shouldBe "hello"
    }

    contract("an answer that noise swallowed is found when the line falls silent") {
        link.request("getPercepts", LONG_MILLIS).text()
        board.whenAsked("getPercepts").answerRaw("fffeFFfffe05hello")
        link.request("getPercepts", LONG_MILLIS).text() shouldBe "hello"
    }

    // On a busy machine, the pause between two late answers may be longer than the silence that ends the wait for them. Tests in virtual
    // time show that the next request gets its own answer.
    contract("after missed answers, requests get their own answers again, and not for good those before") {
        var count = 0
        link.request("getPercepts", LONG_MILLIS).text()
        board.stall()
        board.whenAsked("getPercepts").answer { "count(${++count});" }
        repeat(5) { shouldThrow<PortTimeoutException> { link.request("getPercepts", 30).text() } }
        val last = async { link.request("getPercepts", LONG_MILLIS).text() }
        board.resume()
        last.get(30, TimeUnit.SECONDS)
        board.verify() // the board has handled all requests, so only answers on the line are late
        (1..MAX_LATE).any { link.request("getPercepts", LONG_MILLIS).text() == "count($count);" } shouldBe true
        repeat(3) { link.request("getPercepts", LONG_MILLIS).text() shouldBe "count($count);" }
    }

    contract("requests and actions take turns, and the actions keep their order") {
        val actions = (1..40).map { "speed($it)" }
        link.request("getPercepts", LONG_MILLIS).text()
        val sender = async { actions.forEach { link.sendAndAwait(it, LONG_MILLIS) } }
        var answers = 0
        while (!sender.isDone) {
            link.request("getPercepts", LONG_MILLIS).text()
            answers++
        }
        sender.get()
        actions.map { board.awaitMessage(LONG_MILLIS) } shouldContainExactly actions
        check(answers > 1) { "requests got no turn between the actions" }
    }

    contract("a port has one owner, whose name the next one is told") {
        open(owner = "agent bob").use {
            Link.ownerOf(port).get() shouldBe "agent bob"
            val busy = shouldThrow<PortBusyException> { open(owner = "agent alice") }
            busy.owner() shouldBe "agent bob"
            busy.message shouldContain "agent bob"
        }
        Link.ownerOf(port).isPresent shouldBe false
    }

    contract("a request that waits ends when the plug is pulled") {
        link.request("getPercepts", LONG_MILLIS).text()
        board.whenAsked("getPercepts").staySilent()
        val request = async { link.request("getPercepts", LONG_MILLIS).text() }
        val listener = async { link.listen(LONG_MILLIS).text() }
        unplug()
        request.failure().shouldBeInstanceOf<PortGoneException>()
        listener.failure().shouldBeInstanceOf<PortGoneException>()
    }

    contract("once the plug is pulled every call throws the same, and the port has no owner") {
        link.request("getPercepts", LONG_MILLIS).text()
        unplug()
        val first = shouldThrow<PortGoneException> { link.request("getPercepts", LONG_MILLIS).text() }
        link.isOpen shouldBe false
        for (call in listOf(
            { link.sendAndAwait("stop", LONG_MILLIS) }, { link.listen(LONG_MILLIS).text() },
            { link.request("getPercepts", LONG_MILLIS).text() },
        )) {
            shouldThrow<PortGoneException> { call() }.message shouldBe first.message
        }
        Link.ownerOf(port).isPresent shouldBe false
    }

    contract("calls that wait end when the link is closed") {
        link.request("getPercepts", LONG_MILLIS).text()
        board.whenAsked("getPercepts").staySilent()
        val request = async { link.request("getPercepts", LONG_MILLIS).text() }
        val sends = (1..10).map { async { link.sendAndAwait("x".repeat(200), LONG_MILLIS) } }
        board.awaitMessage(LONG_MILLIS)
        link.close()
        request.failure().shouldBeInstanceOf<PortGoneException>().message shouldContain "closed"
        sends.last { !it.isDone || it.isCompletedExceptionally }.failure().shouldBeInstanceOf<PortGoneException>()
        board.lenient()
    }

    contract("an interrupted call throws, and the link stays usable") {
        link.request("getPercepts", LONG_MILLIS).text()
        val caller = thread(isDaemon = true) { runCatching { link.listen(LONG_MILLIS).text() } }
        caller.interrupt()
        caller.join(TimeUnit.SECONDS.toMillis(20))
        caller.isAlive shouldBe false
        link.request("getPercepts", LONG_MILLIS).text() shouldBe ""
    }
})
