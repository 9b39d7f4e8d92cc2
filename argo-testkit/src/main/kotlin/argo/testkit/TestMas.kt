package argo.testkit

import argo.observing.AgentObserver
import argo.observing.ObservedAgent
import jason.asSemantics.Message
import jason.asSyntax.ASSyntax
import jason.asSyntax.Trigger
import jason.asSyntax.Trigger.TEOperator
import jason.asSyntax.Trigger.TEType
import java.nio.file.Path
import java.util.logging.Logger
import kotlin.time.Duration

/**
 * Agents under test that exchange messages in one virtual time. [mas] starts them. Each agent has its own ports, as if on a computer of its
 * own.
 *
 * Not safe for use by several threads at once.
 */
class TestMas internal constructor() : AutoCloseable {
    internal val time = VirtualTime().also { it.mas = this }
    internal val log = AgentLog(time)
    private val agents = LinkedHashMap<String, TestAgent>() // the last agent of each name
    private val made = ArrayList<TestAgent>()
    private val strangers = HashSet<Pair<String, String>>() // pairs of sender and receiver whose receiver is no agent of this test
    private var closed = false

    /** Returns the delivery time of a message between agents of the test. Called when the message is sent. */
    internal var delayOf: (Message) -> Duration = { Duration.ZERO }

    internal var mostCycles = CycleLimit.MOST

    /** Makes the observer of a new agent, or null for no observers. */
    internal var observing: ((ObservedAgent) -> AgentObserver)? = null

    /** The names of the running agents, in order of creation. */
    val names: List<String> get() = agents.values.filter { it.isRunning }.map { it.name }

    /**
     * Returns the agent [name], even if it has stopped.
     * @throws IllegalArgumentException if there is no such agent
     */
    operator fun get(name: String): TestAgent =
        agents[name] ?: throw IllegalArgumentException("there is no agent $name; there are ${agents.keys.joinToString()}")

    internal val all: List<TestAgent> get() = made

    internal val first: TestAgent get() = made.first()

    /** Advances time by [duration]. */
    fun after(duration: Duration): TestMas = apply { pass(duration) { false } }

    /**
     * Advances time until [reached] returns true, by at most [duration]. Returns the last result of [reached].
     * @throws IllegalStateException if the agents are closed
     */
    internal fun pass(duration: Duration, reached: () -> Boolean): Boolean = open { time.advanceUntil(nanos(duration), reached) }

    /** Calls [work] and returns its result. Fails if the agents are closed. */
    internal fun <T> open(work: () -> T): T {
        check(!closed) { "the test agents ${agents.keys.joinToString()} are closed; expectations of them belong before that" }
        return work()
    }

    /** Calls [making], which makes agents, and then runs all agents. If [making] fails, all agents stop. */
    internal fun begin(making: () -> Unit): TestMas = apply {
        try {
            JasonTime.install()
            TestServices.install()
            time.driving {
                making()
                time.work = ::step
                time.settle()
            }
        } catch (failed: Throwable) {
            runCatching(::close).onFailure(failed::addSuppressed)
            throw failed
        }
    }

    internal fun make(file: Path?, called: String, wanted: AgentSetUp): TestAgent {
        require(wanted.name !in names) {
            "there is an agent ${wanted.name} already; give the other one another name, by \"name = …\" in its braces"
        }
        require(wanted.name !in RESERVED) { "an agent cannot be called ${wanted.name}" }
        return TestAgent(this, file, called, wanted).also {
            agents[it.name] = it
            made += it
        }
    }

    /** Returns an unused name for a new agent: [base], possibly with a number. */
    internal fun newName(base: String): String =
        (sequenceOf(base) + generateSequence(1) { it + 1 }.map { "${base}_$it" }).first { it !in names }

    internal fun running(): List<TestAgent> = agents.values.filter { it.isRunning }

    internal fun find(name: String): TestAgent? = agents[name]?.takeIf { it.isRunning }

    /** Delivers [message] to its receiver. If the receiver is no agent of the test, reports this once in the sender's log. */
    internal fun deliver(message: Message) {
        val passed = message.clone()
        val delay = delayOf(message)
        if (delay == Duration.ZERO) receive(passed) else time.later(nanos(delay)) { receive(passed) }
    }

    private fun receive(message: Message) {
        val receiver = find(message.receiver)
        if (receiver != null) return receiver.infra.receive(message)
        if (!strangers.add(message.sender to message.receiver)) return
        Logger.getLogger("${javaClass.name}.${message.sender}").warning(
            "no agent ${message.receiver} runs in this test, so messages to it are only kept in said, as this one: " +
                "${described(message)}. In a real system, Jason fails the plan that sends to an agent that does not exist",
        )
    }

    internal fun broadcast(message: Message) = running().filter { it.name != message.sender }.forEach { other ->
        deliver(message.clone().apply { receiver = other.name })
    }

    /** Announces the end to [agents], and stops them after [deadlineMs] ms of virtual time. */
    internal fun stop(agents: List<TestAgent>, deadlineMs: Int) {
        if (deadlineMs > 0) agents.forEach { it.ts.c.addExternalEv(shuttingDown(deadlineMs)) }
        time.later(deadlineMs * NANOS_PER_MS) { agents.forEach(TestAgent::end) } // timers do not run within a reasoning cycle
    }

    private fun shuttingDown(deadlineMs: Int) =
        Trigger(TEOperator.add, TEType.belief, ASSyntax.createLiteral("jag_shutting_down", ASSyntax.createNumber(deadlineMs.toDouble())))

    /** Returns the log entries of the agent [name] and the entries of no agent. */
    internal fun entriesOf(name: String): List<AgentLog.Entry> = log.entries.filter { it.isOf(name) || agents.keys.none(it::isOf) }

    private fun step(): Boolean {
        TestServices.install() // another multi-agent system may have installed its own services
        var isBusy = false
        for (agent in running()) if (agent.cycles.step()) isBusy = true
        return isBusy
    }

    /**
     * Stops all agents and removes their boards. A second call has no effect.
     * @throws IllegalStateException if an agent's architecture leaves a thread behind
     */
    override fun close() {
        if (closed) return
        closed = true
        try {
            time.driving {
                time.work = { false }
                running().forEach(TestAgent::end)
                time.settle()
                made.forEach(TestAgent::takeBoardsAway)
                time.advance(nanos(PATIENCE))
                val left = time.living()
                time.interruptAll()
                time.settle()
                check(left.isEmpty()) { "agents ${agents.keys.joinToString()} have left threads behind: ${left.joinToString()}" }
            }
        } finally {
            log.close()
        }
    }

    private companion object {
        const val NANOS_PER_MS = 1_000_000L

        /** Names with another meaning in Jason. */
        val RESERVED = listOf("self", "percept")
    }
}
