package argo.connecting

import argo.FussyProvider
import argo.calls.Failure
import argo.jason.LIMIT
import argo.links.BoardLink
import argo.links.BoardMessage
import argo.platform.Platform
import argo.platform.TestTime
import argo.sensing.Sensing
import argo.sensing.SensingListener
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.nondeterministic.eventuallyConfig
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import io.kotest.matchers.types.shouldBeSameInstanceAs
import jason.asSyntax.ASSyntax
import javino.PerceptsRequest
import javino.PortException
import javino.PortFaultException
import javino.PortGoneException
import javino.PortPermissionException
import javino.PortTimeoutException
import javino.link.Link
import javino.link.LinkSettings
import javino.sim.FakeBoard
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import kotlin.time.Duration.Companion.milliseconds

private val QUICKLY = eventuallyConfig {
    duration = LIMIT
    interval = 2.milliseconds // each look advances the ports' time by one step
}

private class PortsBench(private val owner: String = "bob") : AutoCloseable {
    val told = ConcurrentLinkedQueue<String>()
    val time = TestTime()
    val closers = ConcurrentLinkedQueue<String>()

    /** Called before a line is closed, by the thread that closes it. */
    @Volatile
    var beforeClosing: () -> Unit = {}

    /** How many further starts of threads fail. */
    @Volatile
    var missingThreads = 0
    private val platform = object : Platform by time {
        override fun open(port: String, settings: LinkSettings, owner: String): BoardLink {
            val link = time.open(port, settings, owner)
            return object : BoardLink by link {
                override fun close() {
                    closers += Thread.currentThread().name
                    beforeClosing()
                    link.close()
                }
            }
        }

        override fun start(name: String, run: () -> Unit): Thread {
            if (missingThreads > 0) throw OutOfMemoryError("unable to create native thread").also { missingThreads-- }
            return time.start(name, run)
        }
    }
    val reasons = ConcurrentLinkedQueue<String>()
    private val states = PortStates { port, status, reason ->
        told += "$port ${status.word}"
        reason?.let(reasons::add)
    }
    private val listener = object : SensingListener {
        override val intervalMs get() = 50
        override fun isSensed(port: OpenPort) = false
        override fun request(port: OpenPort) = PerceptsRequest.ALL
        override fun mayReport(port: OpenPort) = false
        override fun received(port: OpenPort, message: BoardMessage, askedNanos: Long) = Unit
        override fun unanswered(port: OpenPort, trouble: PortTimeoutException) = Unit
        override fun answeredAgain(port: OpenPort) = Unit
        override fun lost(port: OpenPort, trouble: PortException) = ports.lost(port, trouble)
    }
    private val watches = ConcurrentHashMap<OpenPort, Sensing>()
    private val user = object : PortUser {
        override fun use(port: OpenPort) = Sensing(port, owner, listener, time).also { watches[port] = it }
        override fun opened(port: OpenPort) = watches.getValue(port).start()
        override fun portInUseChanged() = Unit
    }
    val ports: Ports = Ports(owner, states, user, paced = true, platform) { told += it }

    fun beliefs() = states.beliefs().map { "$it" }.toSet()

    fun choose(name: String, options: String? = null): Failure? {
        val outcome = CompletableFuture<Failure?>()
        ports.choose(ASSyntax.createString(name), name, options?.let { PortOptions.of(ASSyntax.parseTerm(it)) }, outcome::complete)
        return outcome.get(20, TimeUnit.SECONDS)
    }

    suspend fun awaitBelief(belief: String) = eventually(QUICKLY) { (belief in beliefs()) shouldBe true }

    /** Lets time pass until [belief] is held. */
    suspend fun passUntil(belief: String) = eventually(QUICKLY) {
        if (belief !in beliefs()) time.stepIfDue()
        (belief in beliefs()) shouldBe true
    }

    fun closeAll() = CompletableFuture<Unit>().also { ports.closeAll { it.complete(Unit) } }.get(20, TimeUnit.SECONDS)

    override fun close() {
        ports.stop()
        val left = Thread.getAllStackTraces().keys.filter { it.name.startsWith("argo-$owner-") }
        left.onEach { it.join(LIMIT.inWholeMilliseconds) }.filter { it.isAlive }.shouldBeEmpty()
    }
}

class PortsSpec : FunSpec({
    suspend fun bench(vararg boards: String, work: suspend PortsBench.(List<FakeBoard>) -> Unit) {
        val plugged = boards.map { FakeBoard.plugIn(it).lenient() }
        try {
            PortsBench().use { it.work(plugged) }
        } finally {
            FussyProvider.refusal = { _, _ -> null }
            plugged.forEach(FakeBoard::close)
        }
    }

    test("a port whose device was away is opened again as it was and is in use again") {
        bench("robot") { (board) ->
            choose("sim:robot", "[baud(115200), timeout(77)]") shouldBe null
            val before = ports.current!!
            board.unplug()
            awaitBelief("port(\"sim:robot\",off)")
            ports.all().shouldBeEmpty()
            eventually(QUICKLY) { reasons.single() shouldEndWith "; it is opened again when its device is back" }
            repeat(5) { time.step() }
            board.replug()
            passUntil("port(\"sim:robot\",on)")
            ports.all() shouldContainExactly listOf(ports.current)
            ports.current!!.options shouldBe before.options
            ports.current!!.link.isOpen shouldBe true
            told shouldContainExactly listOf("\"sim:robot\" on", "\"sim:robot\" off", "\"sim:robot\" on")
        }
    }

    test("a port that is not in use comes back without coming into use") {
        bench("left", "right") { (left, _) ->
            choose("sim:left") shouldBe null
            choose("sim:right") shouldBe null
            val current = ports.current
            left.unplug()
            awaitBelief("port(\"sim:left\",off)")
            left.replug()
            passUntil("port(\"sim:left\",on)")
            ports.current shouldBeSameInstanceAs current
            Link.ownerOf("sim:left").get() shouldBe "bob"
            left.unplug() // and the port is still watched
            awaitBelief("port(\"sim:left\",off)")
        }
    }

    test("who asks for a lost port has it as soon as its device is back, and nothing more comes of looking for it") {
        bench("robot") { (board) ->
            choose("sim:robot") shouldBe null
            board.unplug()
            awaitBelief("port(\"sim:robot\",off)")
            choose("sim:robot")?.error shouldBe "no_such_port"
            board.replug()
            choose("sim:robot") shouldBe null
            val port = ports.current
            while (!time.isIdle()) time.step()
            choose("sim:robot") shouldBe null
            ports.current shouldBeSameInstanceAs port
            told.count { it.endsWith(" on") } shouldBe 2
        }
    }

    test("a port that was never open is not looked for") {
        bench { _ ->
            choose("sim:robot")?.error shouldBe "no_such_port"
            FakeBoard.plugIn("robot").use {
                choose("sim:nobody")?.error shouldBe "no_such_port"
                time.isIdle() shouldBe true
                beliefs() shouldContain "port(\"sim:robot\",off)"
            }
        }
    }

    test("argo.port(none) ends the looking, and nothing is believed of what was lost") {
        bench("robot") { (board) ->
            choose("sim:robot") shouldBe null
            board.unplug()
            awaitBelief("port(\"sim:robot\",off)")
            closeAll()
            beliefs().shouldBeEmpty()
            board.replug()
            while (!time.isIdle()) time.step()
            closeAll() // after everything that was due
            time.isIdle() shouldBe true
            beliefs().shouldBeEmpty()
            Link.ownerOf("sim:robot").isPresent shouldBe false
        }
    }

    test("an agent's end is the end of looking") {
        bench("robot") { (board) ->
            choose("sim:robot") shouldBe null
            board.unplug()
            awaitBelief("port(\"sim:robot\",off)")
            ports.stop()
            board.replug()
            while (!time.isIdle()) time.step()
            Link.ownerOf("sim:robot").isPresent shouldBe false
        }
    }

    test("both names of a device come back") {
        bench("robot") { (board) ->
            choose("fussy:robot") shouldBe null
            choose("sim:robot") shouldBe null
            ports.all().size shouldBe 1
            board.unplug()
            awaitBelief("port(\"sim:robot\",off)")
            awaitBelief("port(\"fussy:robot\",off)")
            board.replug()
            passUntil("port(\"sim:robot\",on)")
            passUntil("port(\"fussy:robot\",on)")
            ports.all() shouldContainExactly listOf(ports.current)
        }
    }

    test("a device that is back but cannot be opened is told of once, and opened when it can be") {
        bench("robot") { (board) ->
            choose("fussy:robot") shouldBe null
            board.unplug()
            awaitBelief("port(\"fussy:robot\",off)")
            FussyProvider.refusal = { port, _ -> PortPermissionException(port, "not you") }
            board.replug()
            repeat(30) { time.step() }
            told.filter { "not you" in it }.single() shouldContain "port \"fussy:robot\" is still off"
            FussyProvider.refusal = { _, _ -> null }
            passUntil("port(\"fussy:robot\",on)")
        }
    }

    test("a device that takes its time to be opened keeps no other one from coming back, and is asked for at once when the agent asks") {
        bench("left", "right") { boards ->
            choose("fussy:left") shouldBe null
            choose("sim:right") shouldBe null
            boards.forEach(FakeBoard::unplug)
            awaitBelief("port(\"fussy:left\",off)")
            awaitBelief("port(\"sim:right\",off)")
            val isOpened = CountDownLatch(1)
            FussyProvider.refusal = { _, _ -> null.also { isOpened.countDown(); CountDownLatch(1).await() } } // is interrupted
            boards[0].replug()
            eventually(LIMIT) {
                time.stepIfDue()
                isOpened.count shouldBe 0 // a thread is opening fussy:left
            }
            boards[1].replug()
            passUntil("port(\"sim:right\",on)")
            beliefs() shouldContain "port(\"fussy:left\",off)"
            FussyProvider.refusal = { _, _ -> null }
            choose("fussy:left") shouldBe null
            beliefs() shouldContain "port(\"fussy:left\",on)"
        }
    }

    test("a port that cannot be opened with other options stays open as it was, in use or not") {
        bench("left", "right") { _ ->
            FussyProvider.refusal = { port, line -> if (line.baud() == 7) PortFaultException(port, "no such rate", null) else null }
            choose("fussy:left", "[baud(115200)]") shouldBe null
            choose("sim:left") shouldBe null
            choose("fussy:left", "[baud(7)]")?.error shouldBe "port_failed"
            ports.current!!.options.link.baud() shouldBe 115200
            ports.current!!.link.isOpen shouldBe true
            ports.all() shouldContainExactly listOf(ports.current)
            beliefs() shouldBe setOf("port(\"fussy:left\",on)", "port(\"sim:left\",on)")
            choose("sim:right") shouldBe null
            val right = ports.current
            choose("fussy:left", "[baud(7)]")?.error shouldBe "port_failed"
            ports.current shouldBeSameInstanceAs right
            ports.all().size shouldBe 2
            told.filter { it.endsWith("off") }.shouldBeEmpty()
        }
    }

    test("a port that is opened with other options keeps all its names") {
        bench("robot") { (board) ->
            choose("fussy:robot") shouldBe null
            choose("sim:robot", "[timeout(77)]") shouldBe null
            board.unplug()
            awaitBelief("port(\"fussy:robot\",off)")
            awaitBelief("port(\"sim:robot\",off)")
        }
    }

    test("a hundred disconnections are a hundred times off and on, and leave no thread").config(tags = thorough) {
        bench("robot") { (board) ->
            choose("sim:robot", "[baud(1000000)]") shouldBe null
            repeat(100) {
                board.unplug()
                awaitBelief("port(\"sim:robot\",off)")
                board.replug()
                passUntil("port(\"sim:robot\",on)")
            }
            told.count { it.endsWith(" off") } shouldBe 100
            told.size shouldBe 201
            Thread.getAllStackTraces().keys.count { it.name.startsWith("argo-bob-") } shouldBeLessThan 5
        }
    }

    test("the rate that a port usually has need not be said to be the same") {
        bench("robot") { _ ->
            choose("sim:robot") shouldBe null
            val port = ports.current
            choose("sim:robot", "[baud(9600)]") shouldBe null
            ports.current shouldBeSameInstanceAs port
        }
    }

    test("who finds a port lost does not close it: the thread that looks for it does") {
        bench("robot") { _ ->
            choose("sim:robot") shouldBe null
            val port = checkNotNull(ports.current)
            ports.lost(port, PortGoneException("sim:robot", "a command found it gone"))
            awaitBelief("port(\"sim:robot\",off)")
            passUntil("port(\"sim:robot\",on)")
            closers.toSet() shouldBe setOf("argo-bob-looking-for-sim:robot")
        }
    }

    test("a lost port whose line is still being closed is opened by who asks for it, once it is free") {
        bench("robot") { _ ->
            repeat(20) {
                choose("sim:robot") shouldBe null
                ports.lost(checkNotNull(ports.current), PortGoneException("sim:robot", "a command found it gone"))
            }
            choose("sim:robot") shouldBe null
        }
    }

    test("a port that was given up while its line is still being closed is opened by who asks for it, once it is free") {
        bench("robot") { _ ->
            choose("sim:robot") shouldBe null
            val isClosing = CountDownLatch(1)
            val mayClose = CountDownLatch(2)
            beforeClosing = {
                isClosing.countDown()
                mayClose.countDown()
                mayClose.await() // until another thread also closes it
            }
            ports.lost(checkNotNull(ports.current), PortGoneException("sim:robot", "a command found it gone"))
            isClosing.await()
            ports.closeAll { }
            val outcome = CompletableFuture<Failure?>()
            ports.choose(ASSyntax.createString("sim:robot"), "sim:robot", null) {
                outcome.complete(it)
                mayClose.countDown()
            }
            outcome.get(20, TimeUnit.SECONDS) shouldBe null
        }
    }

    test("an ended agent's port that is still being closed is opened by another agent, once it is free") {
        bench("robot") { _ ->
            choose("sim:robot") shouldBe null
            PortsBench("alice").use { alice -> alice.choose("sim:robot")?.error shouldBe "port_busy" }
            val mayClose = CountDownLatch(1)
            beforeClosing = mayClose::await
            ports.stop()
            PortsBench("carol").use { carol ->
                val outcome = CompletableFuture<Failure?>()
                carol.ports.choose(ASSyntax.createString("sim:robot"), "sim:robot", null, outcome::complete)
                mayClose.countDown()
                outcome.get(20, TimeUnit.SECONDS) shouldBe null
            }
        }
    }

    test("of two names of one device in a list the first is used, which the log tells") {
        bench("robot") { _ ->
            val ports = listOf("sim:robot", "fussy:robot").map { WantedPort(ASSyntax.createString(it), it, null) }
            CompletableFuture<Failure?>().also { this.ports.chooseAll(ports, it::complete) }.get(20, TimeUnit.SECONDS) shouldBe null
            beliefs() shouldBe setOf("port(\"sim:robot\",on)")
            told.single { "one device" in it } shouldContain "\"sim:robot\" and \"fussy:robot\" are one device"
        }
    }

    test("lost ports that are too many are given up, which the log tells") {
        bench("robot") { _ ->
            choose("sim:robot") shouldBe null
            val lost = LostPorts("bob", time, { }, told::add)
            val ports = listOf("a", "b", "c").map { LostPort(checkNotNull(this.ports.current), ASSyntax.createAtom(it), it, 0) }
            lost.add(ports)
            lost.keep(1)
            ports.map { it in lost } shouldBe listOf(false, false, true)
            told.filter { "no more" in it }.map { it.substringBefore(" is") } shouldBe listOf("port a", "port b")
        }
    }

    test("a port is looked for as soon as the machine has a thread for it") {
        bench("robot") { (board) ->
            choose("sim:robot") shouldBe null
            missingThreads = 3
            board.unplug()
            awaitBelief("port(\"sim:robot\",off)")
            board.replug()
            passUntil("port(\"sim:robot\",on)")
            missingThreads shouldBe 0
        }
    }
})

private val thorough = setOf(NamedTag("Thorough"))
