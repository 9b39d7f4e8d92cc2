package argo.testkit

import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.asSyntax.ASSyntax
import java.nio.file.Path
import kotlin.time.Duration
import kotlin.time.Duration.Companion.days
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
class TestAgent internal constructor(
    /** The agents that run in its test, itself among them: those that were started with it, and those that they have created. */
    val mas: TestMas,
    file: Path?,
    called: String,
    internal val setUp: AgentSetUp,
) : AutoCloseable {
    private val time get() = mas.time
    internal val bench = setUp.bench
    private val witness = PerceptionWitness()
    internal val infra = InfraArch(setUp.name, mas, setUp.environment)
    internal val ts: TransitionSystem

    init {
        setUp.environment?.environmentInfraTier = EnvironmentTier(mas)
        ts = create(file, called, setUp, infra, witness)
        wakeEachSecond()
    }

    private val mind = Mind(ts)
    private var cycles = 0
    private var cyclesAt = -1L

    /** Where the programs of agents that it creates are looked for first. */
    internal val sourceDirectories: List<String> = listOfNotNull(file?.parent?.toString()) + setUp.sourcePaths

    /** What it is called. */
    val name: String get() = setUp.name

    /** Whether it has neither been stopped, as by `.stopMAS` or `.kill_agent`, nor closed. */
    val isRunning: Boolean get() = infra.isRunning

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
    val printed: List<String> get() = mas.journal.printedBy(name)

    /** What was logged so far, each line with its level; not what is about other agents of the test. */
    val log: List<String> get() = entries.map { "$it" }

    internal val entries: List<AgentLog.Entry> get() = mas.entriesOf(name)

    /** What it has said to other agents: `tell(bob,ready)`. */
    val said: List<String> get() = infra.said.map(::described)

    /** Lets [duration] pass. */
    fun after(duration: Duration): TestAgent = apply { mas.pass(duration) { false } }

    /**
     * The sensors of its first [board] show [percepts] from now on; then lets time pass until the agent has perceived that, at most a
     * second, as when it does not look at its sensors.
     */
    fun perceives(vararg percepts: String): TestAgent = apply {
        val board = mas.open { board.shows(*percepts) }
        val end = now + PATIENCE
        mas.pass(PATIENCE) { board.answers >= ANSWERS_UNTIL_KNOWN }
        val before = witness.perceptions
        mas.pass((end - now).coerceAtLeast(Duration.ZERO)) { witness.perceptions > before }
    }

    /** Agent [sender] says [content] to it: `hears("boss", "achieve", "patrol")`; [performative] is one of `.send`'s. */
    fun hears(sender: String, performative: String, content: String): TestAgent = apply {
        require(performative in Message.knownPerformatives) {
            "$performative is not a performative; there are ${Message.knownPerformatives.joinToString()}"
        }
        val term = parsed(content, "a term") { ASSyntax.parseTerm(content) }
        mas.open {
            infra.receive(Message(performative, sender, name, term))
            time.settle()
        }
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
        expect(within, "prints $text") { printed.any { text in it } }

    /** It has said that to another agent, or does within that time: `shouldSay("tell(bob,ready)")`; to all: `tell(everybody,ready)`. */
    fun shouldSay(message: String, within: Duration = PATIENCE): TestAgent =
        expect(within, "says $message") { infra.said.any { described(it) == message.filterNot(Char::isWhitespace) } }

    /** It is stopped within that time, as by `.stopMAS` or `.kill_agent`. */
    fun shouldStop(within: Duration = PATIENCE): TestAgent = expect(within, "stops") { !isRunning }

    /** It is stopped, as by `.kill_agent`; its boards stay, and nobody uses them. */
    fun stops(): TestAgent = apply {
        mas.open {
            mas.stop(listOf(this), 0)
            time.settle()
        }
    }

    private fun expect(within: Duration, what: String, holds: () -> Boolean): TestAgent = apply {
        if (!mas.pass(within, holds)) throw AssertionError("expected that agent $name $what within $within\n${report()}")
    }

    private fun refuse(during: Duration, what: String, holds: () -> Boolean): TestAgent = apply {
        if (mas.pass(during, holds)) throw AssertionError("expected that agent $name never $what in $during\n${report()}")
    }

    /** One reasoning cycle. An agent that never sleeps would stop the time. */
    internal fun step(): Boolean {
        if (!cycle()) return false
        if (cyclesAt != time.nanos()) cycles = 0
        cyclesAt = time.nanos()
        if (++cycles < MOST_CYCLES) return true
        cycles = 0
        throw AssertionError(
            "agent $name is still busy after $MOST_CYCLES cycles at one instant: a plan that repeats itself has to wait for something, " +
                "time (.wait) or a command (argo.act)\n${report()}",
        )
    }

    private fun cycle(): Boolean = try {
        infra.step()
    } catch (endless: StackOverflowError) {
        throw AssertionError("agent $name calls itself without end, in a rule or an internal action; what it called last is in the cause\n${report()}", endless)
    }

    /** An agent is woken once a second at least. */
    private fun wakeEachSecond() {
        infra.wake()
        if (isRunning) time.later(nanos(1.seconds), ::wakeEachSecond)
    }

    internal fun end() {
        if (!isRunning) return
        infra.end()
        setUp.environment?.takeIf { mas.running().none { other -> other.setUp.environment === it } }?.stop()
    }

    internal fun takeBoardsAway() = bench.all().forEach(Board::end)

    /**
     * Stops it and all other agents of its test, and takes their boards away.
     * @throws IllegalStateException if an architecture leaves a thread behind
     */
    override fun close() = mas.close()

    internal companion object {
        private const val MOST_CYCLES = 10_000

        /** The first answer has been read when the board is asked again. */
        private const val ANSWERS_UNTIL_KNOWN = 2
    }
}

/** How long the test waits for something, unless told otherwise. */
internal val PATIENCE = 1.seconds

/** @throws IllegalArgumentException if a test cannot last so long */
internal fun nanos(duration: Duration): Long {
    require(!duration.isNegative()) { "time does not go back: $duration" }
    require(duration <= LONGEST) { "a test lasts $LONGEST at most, not $duration" }
    return duration.inWholeNanoseconds
}

private val LONGEST = 3650.days

private fun described(message: Message) = "${message.ilForce}(${message.receiver},${message.propCont})".filterNot(Char::isWhitespace)
