package argo.testkit

import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.asSyntax.ASSyntax
import java.nio.file.Path
import kotlin.time.Duration
import kotlin.time.Duration.Companion.nanoseconds
import kotlin.time.Duration.Companion.seconds

/**
 * An agent under test, in a time that goes on only when the test lets it: by [after], and by what waits for something to come. Then the
 * agent reasons until it sleeps, and at once it is as much later as the shortest wait of the agent, its boards and their lines takes.
 *
 * What `should` happen is waited for, a second unless told otherwise, and what should not must not come in that time. An expectation that
 * fails throws an [AssertionError] that tells what was sent, believed, intended and logged.
 *
 * It belongs to one thread at a time.
 */
class TestAgent private constructor(
    private val time: VirtualTime,
    private val bench: Bench,
    private val infra: InfraArch,
    private val witness: PerceptionWitness,
    private val journal: AgentLog,
    ts: TransitionSystem,
) : AutoCloseable {
    private val mind = Mind(ts)
    private var cycles = 0
    private var cyclesAt = -1L

    /** The board on its first port. */
    val board: Board get() = bench.first()

    /** The board on [port], named as the agent names it. */
    fun board(port: String): Board = bench.at(port)

    /** How long it has been running. */
    val now: Duration get() = time.nanos().nanoseconds

    /** The commands that have arrived at its boards, of each board in their order. */
    val sent: List<String> get() = bench.all().flatMap { it.commands }

    /** What it believes, without annotations and rules, in alphabetical order. */
    val beliefs: List<String> get() = mind.beliefs

    /** What it intends: `!patrol at .wait(500)`, where several goals led to it the latest first. */
    val intentions: List<String> get() = mind.intentions

    /** What it has printed, with `.print` and the like. */
    val printed: List<String> get() = journal.printed.toList()

    /** What was logged so far, each line with its level. */
    val log: List<String> get() = journal.lines.toList()

    /** What it has said to other agents: `tell(bob,ready)`. */
    val said: List<String> get() = infra.said.map(::described)

    /** Lets [duration] pass. */
    fun after(duration: Duration): TestAgent = apply { time.advance(nanos(duration)) }

    /**
     * The sensors of its first [board] show [percepts] from now on; then lets time pass until the agent has perceived that, at most a
     * second, as when it does not look at its sensors.
     */
    fun perceives(vararg percepts: String): TestAgent = apply {
        val board = board.shows(*percepts)
        val end = now + PATIENCE
        time.advanceUntil(nanos(PATIENCE)) { board.answers >= ANSWERS_UNTIL_KNOWN }
        val before = witness.perceptions
        time.advanceUntil(nanos((end - now).coerceAtLeast(Duration.ZERO))) { witness.perceptions > before }
    }

    /** Agent [sender] says [content] to it: `hears("boss", "achieve", "patrol")`; [performative] is one of `.send`'s. */
    fun hears(sender: String, performative: String, content: String): TestAgent = apply {
        require(performative in Message.knownPerformatives) {
            "$performative is not a performative; there are ${Message.knownPerformatives.joinToString()}"
        }
        val term = parsed(content, "a term") { ASSyntax.parseTerm(content) }
        infra.receive(Message(performative, sender, infra.agName, term))
        time.settle()
    }

    /** [command] arrives at one of its boards within that time. Each command that arrives fulfils one expectation. */
    fun shouldSend(command: String, within: Duration = PATIENCE): TestAgent =
        expect(within, "sends $command") { bench.all().any { it.take(command) } }

    /** [command] has not arrived at any of its boards, but for those that [shouldSend] has taken, and does not in that time. */
    fun shouldNotSend(command: String, during: Duration = PATIENCE): TestAgent =
        refuse(during, "sends $command") { bench.all().any { command in it.unexpected } }

    /** No command has arrived at its boards, but for those that [shouldSend] has taken, and none does in that time. */
    fun shouldSendNothingElse(during: Duration = PATIENCE): TestAgent =
        refuse(during, "sends anything else") { bench.all().any { it.unexpected.isNotEmpty() } }

    /** It believes [formula] at some time within that: a belief such as `dist(front,_)`, or a condition as in the context of a plan. */
    fun shouldBelieve(formula: String, within: Duration = PATIENCE): TestAgent =
        formula(formula).let { expect(within, "believes $formula") { mind.believes(it) } }

    /** It does not believe [formula] at any time in that. */
    fun shouldNotBelieve(formula: String, during: Duration = PATIENCE): TestAgent =
        formula(formula).let { refuse(during, "believes $formula") { mind.believes(it) } }

    /** It has the goal [goal] among its intentions at some time within that: `patrol`, `goto(3,_)`. */
    fun shouldIntend(goal: String, within: Duration = PATIENCE): TestAgent =
        goal(goal).let { expect(within, "intends $goal") { mind.intends(it) } }

    /** It does not have [goal] among its intentions at any time in that. */
    fun shouldNotIntend(goal: String, during: Duration = PATIENCE): TestAgent =
        goal(goal).let { refuse(during, "intends $goal") { mind.intends(it) } }

    /** It has printed a line with [text] in it, or does within that time. */
    fun shouldPrint(text: String, within: Duration = PATIENCE): TestAgent =
        expect(within, "prints $text") { journal.printed.any { text in it } }

    /** It has said that to another agent, or does within that time: `shouldSay("tell(bob,ready)")`; to all: `tell(everybody,ready)`. */
    fun shouldSay(message: String, within: Duration = PATIENCE): TestAgent =
        expect(within, "says $message") { infra.said.any { described(it) == message.filterNot(Char::isWhitespace) } }

    private fun expect(within: Duration, what: String, holds: () -> Boolean): TestAgent = apply {
        if (!time.advanceUntil(nanos(within), holds)) throw AssertionError("expected that agent ${infra.agName} $what within $within\n$report")
    }

    private fun refuse(during: Duration, what: String, holds: () -> Boolean): TestAgent = apply {
        if (time.advanceUntil(nanos(during), holds)) throw AssertionError("expected that agent ${infra.agName} never $what in $during\n$report")
    }

    private val report: String
        get() = listOf("sent" to sent, "believes" to beliefs, "intends" to intentions, "said" to said, "log" to log.takeLast(LOGGED))
            .joinToString("\n", "after $now\n") { (what, found) -> "$what: " + found.joinToString("\n    ", "\n    ").takeIf { found.isNotEmpty() }.orEmpty().ifEmpty { "nothing" } }

    /** One reasoning cycle. An agent that never sleeps would stop the time. */
    private fun step(): Boolean {
        if (!infra.step()) return false
        if (cyclesAt != time.nanos()) cycles = 0
        cyclesAt = time.nanos()
        if (++cycles < MOST_CYCLES) return true
        cycles = 0
        throw AssertionError(
            "agent ${infra.agName} is still busy after $MOST_CYCLES cycles at one instant: a plan that repeats itself has to wait for something, " +
                "time (.wait) or a command (argo.act)\n$report",
        )
    }

    /** An agent is woken once a second at least. */
    private fun wakeEachSecond() {
        infra.wake()
        time.later(nanos(1.seconds), ::wakeEachSecond)
    }

    /**
     * Stops the agent and takes its boards away.
     * @throws IllegalStateException if the agent's architecture leaves a thread behind
     */
    override fun close() {
        time.driving {
            time.work = { false }
            infra.end()
            time.settle()
            bench.all().forEach(Board::end)
            time.advance(nanos(PATIENCE))
            val left = time.living()
            time.interruptAll()
            time.settle()
            journal.close()
            check(left.isEmpty()) { "agent ${infra.agName} has left threads behind: ${left.joinToString()}" }
        }
    }

    internal companion object {
        private val PATIENCE = 1.seconds
        private const val MOST_CYCLES = 10_000
        private const val LOGGED = 20

        /** The first answer has been read when the board is asked again. */
        private const val ANSWERS_UNTIL_KNOWN = 2

        fun start(file: Path, name: String, setUp: AgentSetUp.() -> Unit): TestAgent {
            JasonTime.install()
            val time = VirtualTime()
            val bench = Bench(time)
            val wanted = AgentSetUp(bench, name).apply(setUp)
            val journal = AgentLog(time)
            return try {
                time.driving { start(file, wanted, time, bench, journal) }
            } catch (failed: Throwable) {
                journal.close()
                throw failed
            }
        }

        private fun start(file: Path, wanted: AgentSetUp, time: VirtualTime, bench: Bench, journal: AgentLog): TestAgent {
            val infra = InfraArch(wanted.name)
            val witness = PerceptionWitness()
            val ts = create(file, wanted, bench, infra, witness)
            val agent = TestAgent(time, bench, infra, witness, journal, ts)
            time.work = agent::step
            agent.wakeEachSecond()
            try {
                time.settle()
            } catch (failed: Throwable) {
                runCatching { agent.close() }.onFailure(failed::addSuppressed)
                throw failed
            }
            return agent
        }
    }
}

private fun nanos(duration: Duration): Long = duration.inWholeNanoseconds.also { require(it >= 0) { "time does not go back: $duration" } }

private fun described(message: Message) = "${message.ilForce}(${message.receiver},${message.propCont})".filterNot(Char::isWhitespace)
