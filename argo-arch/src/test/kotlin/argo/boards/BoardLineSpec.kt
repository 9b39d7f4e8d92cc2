package argo.boards

import argo.connecting.PortOptions
import argo.connecting.PortStatus
import argo.filters.CriticalRule
import argo.filters.Rule
import argo.filters.dropFilter
import argo.links.BoardLink
import argo.links.BoardMessage
import argo.links.SentCommand
import argo.observing.Observers
import argo.perception.ReasoningQueues
import argo.platform.Platform
import argo.platform.Waker
import argo.sensing.SensingPolicy
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import jason.architecture.AgArch
import jason.asSyntax.ASSyntax
import javino.link.BoardListener
import javino.link.LinkSettings
import javino.link.SendOptions
import javino.wire.CommandItem
import javino.wire.ReflexOutcome
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.TimeUnit
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger

/** The link to a board that holds rules and only reports to its [listener]. */
internal class RuleLink(override val port: String) : BoardLink {
    lateinit var listener: BoardListener
    override val isOpen get() = true
    override val isPaced get() = false // so nobody senses it
    override fun listen(timeoutMs: Int): BoardMessage? = null
    override fun check() = Unit
    override fun send(text: String, options: SendOptions) = SentCommand(CompletableFuture.completedFuture(null))
    override fun sendRule(rule: CommandItem.Rule, options: SendOptions) = send("", options)
    override fun sendAndAwait(text: String, options: SendOptions) = null
    override fun onBoardEvents(listener: BoardListener) {
        this.listener = listener
    }

    override fun close() = Unit
}

class BoardLineSpec : FunSpec({
    val near = CriticalRule(Rule("near"), "stop")
    val far = CriticalRule(Rule("far"))
    val lines = CopyOnWriteArrayList<String>()
    val order = CopyOnWriteArrayList<String>()
    val log = Logger.getAnonymousLogger().apply {
        useParentHandlers = false
        addHandler(object : Handler() {
            override fun publish(record: LogRecord) {
                if ("reports" in record.message) lines += record.message
                if ("is timeout" in record.message) order += "line"
            }

            override fun flush() = Unit
            override fun close() = Unit
        })
    }
    val link = RuleLink("robot")
    val platform = object : Platform by Platform.system {
        override fun open(port: String, settings: LinkSettings, owner: String): BoardLink = link
    }
    val arch = object : AgArch() {
        override fun wakeUpSense() { order += "wake" }
    }
    val boards = AgentBoards("bob", SensingPolicy.FRESH, 4096, platform, Waker(arch), log, ReasoningQueues()) {
        Observers(emptyList(), log) { 0 }
    }
    val filter = dropFilter("careful") {
        critical("near") { reflex("stop") }
        critical("far")
    }

    beforeSpec {
        val isOpen = CompletableFuture<Unit>()
        boards.ports.choose(ASSyntax.createAtom("robot"), "robot", PortOptions()) { isOpen.complete(Unit) }
        isOpen.get(20, TimeUnit.SECONDS)
        boards.perceiveThrough(filter)
        boards.perceive(true)
        link.listener.sessionBegan(2)
    }
    afterSpec { boards.ports.stop() }
    beforeTest { lines.clear() }

    test("a report by a rule that is held is perceived") {
        link.listener.critical(1, ReflexOutcome.CARRIED_OUT, "near(9);", 0)
        boards.ready.take().flatMap { it.texts } shouldBe listOf("near(9)")
        lines.shouldBeEmpty()
    }

    test("a report by a rule that is watched no more is told once, with its reflex, and so is one while perceiving is blocked") {
        boards.perceiveThrough(null)
        repeat(3) { link.listener.critical(1, ReflexOutcome.CARRIED_OUT, "near(9);", 0) }
        lines.single() shouldContain "near(9)"
        lines.single() shouldContain "$near"
        lines.single() shouldContain "It has carried the reflex out"
        boards.perceiveThrough(filter)
        boards.perceive(false)
        link.listener.critical(2, ReflexOutcome.NONE, "far(99);", 0)
        lines.last() shouldContain "$far"
        lines.last() shouldNotContain "It has carried"
        boards.ready.take().shouldBeEmpty()
    }

    test("a report by a rule that the board was never sent is told") {
        link.listener.critical(200, ReflexOutcome.NONE, "odd;", 0)
        lines.single() shouldContain "unknown percepts"
    }

    test("a port that does not answer wakes the agent before its line is logged") {
        boards.states.beliefs() // so that nothing else is left to wake it for
        order.clear()
        boards.ports.report(boards.ports.all().single(), PortStatus.TIMEOUT, "no answer")
        order.distinct() shouldBe listOf("wake", "line")
    }
})
