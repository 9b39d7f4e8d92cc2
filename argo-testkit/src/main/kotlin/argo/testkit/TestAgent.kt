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
 * An agent under test, in virtual time. Virtual time advances only in [after], [perceives] and functions whose names begin with `should`.
 * The agent reasons until it sleeps. If all threads wait, time jumps to the end of the shortest wait of the agent, its boards and their
 * lines.
 *
 * An expectation waits until it is met. The limit is one second of virtual time, or the given time. An expectation that something does not
 * happen waits for the whole time. A failed expectation throws an [AssertionError] with the commands, beliefs, intentions, messages and the
 * log.
 *
 * Not safe for use by several threads at once.
 */
class TestAgent internal constructor(
    /** All agents of this test, including those that agents have created. */
    val mas: TestMas,
    file: Path?,
    called: String,
    internal val setUp: AgentSetUp,
) : AutoCloseable {
    private val time get() = mas.time
    internal val platform = setUp.platform
    private val counter = PerceptionCounter()
    internal val infra = InfraArch(setUp.name, mas, setUp.environment)
    internal val ts: TransitionSystem

    init {
        setUp.environment?.environmentInfraTier = EnvironmentTier(mas)
        ts = create(file, called, setUp, infra, counter)
        wakeEachSecond()
    }

    private val inspector = AgentInspector(ts)
    internal val cycles = CycleLimit(this)

    /** The directories that are searched first for the programs of created agents. */
    internal val sourceDirectories: List<String> = listOfNotNull(file?.parent?.toString()) + setUp.sourcePaths

    val name: String get() = setUp.name

    /** False if the agent was stopped, for example by `.stopMAS` or `.kill_agent`, or closed. */
    val isRunning: Boolean get() = infra.isRunning

    /** The board on the agent's first port. */
    val board: Board get() = platform.first()

    /** Returns the board on [port]. The port is written as in agents. */
    fun board(port: String): Board = platform.at(port)

    /** The virtual time since the start of the test. */
    val now: Duration get() = time.nanos().nanoseconds

    /** The commands that have arrived at the agent's boards. The commands are grouped by board, each group in order of arrival. */
    val sent: List<String> get() = platform.all().flatMap { it.commands }

    /** The commands that have arrived at the agent's boards, with their times, in order of time. */
    val arrivals: List<Arrival> get() = platform.all().flatMap { it.arrivals }.sortedBy { it.at }

    /** The agent's beliefs, without annotations and rules, in alphabetical order. */
    val beliefs: List<String> get() = inspector.beliefs

    /** The agent's intentions, such as `!patrol at .wait(500)`. If an intention has several goals, the latest one is first. */
    val intentions: List<String> get() = inspector.intentions

    /** The lines that the agent has printed by `.print` and similar actions. */
    val printed: List<String> get() = mas.log.printedBy(name)

    /** The log up to now, without records of other agents. Each record has its level. */
    val log: List<String> get() = entries.map { "$it" }

    internal val entries: List<AgentLog.Entry> get() = mas.entriesOf(name)

    /** The messages that the agent has sent to other agents, such as `tell(bob,ready)`. */
    val said: List<String> get() = infra.said.map(::described)

    /** Advances time by [duration]. */
    fun after(duration: Duration): TestAgent = apply { mas.pass(duration) { false } }

    /**
     * The sensors of the agent's first [board] show [percepts] from now on. Advances time until the agent has perceived these percepts.
     * Fails if the agent does not perceive them within the time [within], for example because it blocks percepts.
     * @throws IllegalArgumentException if an agent would ignore a malformed percept, such as `dist(front`. Use [perceivesRaw] for it
     */
    fun perceives(vararg percepts: String, within: Duration = PATIENCE): TestAgent =
        perceives(percepts.joinToString().ifEmpty { "no percepts" }, within) { shows(*percepts) }

    /** Works like [perceives], but the board sends exactly [message]. [message] may be malformed: `dist(front;)(;`. */
    fun perceivesRaw(message: String, within: Duration = PATIENCE): TestAgent = perceives(message, within) { showsRaw(message) }

    private fun perceives(what: String, within: Duration, shows: Board.() -> Unit): TestAgent = apply {
        val board = mas.open { board.apply(shows) }
        val end = now + within
        val earlier = counter.perceptions
        mas.pass(within) { board.answers >= ANSWERS_UNTIL_KNOWN }
        if (board.answers == 0 || counter.perceptions == earlier && !isPerceiving) {
            throw AssertionError("expected that agent $name perceives $what within $within, but ${whyBlind()}\n${report()}")
        }
        val before = counter.perceptions
        mas.pass((end - now).coerceAtLeast(Duration.ZERO)) { counter.perceptions > before }
    }

    /** Sends the agent [content] from [sender], as in `hears("boss", "achieve", "patrol")`. [performative] is a performative of `.send`. */
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

    /** Expects [command] at one of the agent's boards. Each arrival fulfils one expectation. */
    fun shouldSend(command: String, within: Duration = PATIENCE): TestAgent =
        expect(within, "sends $command") { platform.all().any { it.take(command) } }

    /**
     * Expects [command] at one of the agent's boards between [since] and [since] + [within]. [since] is a past value of [now]. A test can
     * thus check how fast the agent reacts to something at [since]. Each arrival fulfils one expectation.
     * @throws IllegalArgumentException if [since] is in the future
     */
    fun shouldSend(command: String, within: Duration, since: Duration): TestAgent = apply {
        require(since <= now) { "since is a past time, such as an earlier value of robot.now; $since is later than the present time, $now" }
        val end = since + within
        val left = (end - now).coerceAtLeast(Duration.ZERO)
        if (!mas.pass(left) { platform.all().any { board -> board.take(command) { it in since..end } } }) {
            throw AssertionError("expected that agent $name sends $command from $since until $end\n${report()}")
        }
    }

    /**
     * Expects that [command] has not arrived at the agent's boards, and does not arrive. Arrivals that fulfilled a [shouldSend] do not
     * count.
     */
    fun shouldNotSend(command: String, during: Duration = PATIENCE): TestAgent =
        refuse(during, "sends $command") { platform.all().any { command in it.unexpected } }

    /** Expects that no command has arrived at the agent's boards, and none arrives. Arrivals that fulfilled a [shouldSend] do not count. */
    fun shouldSendNothingElse(during: Duration = PATIENCE): TestAgent =
        refuse(during, "sends anything else") { platform.all().any { it.unexpected.isNotEmpty() } }

    /**
     * Expects that the agent believes [formula] at some time. [formula] is a belief such as `dist(front,_)`, or a condition as in a plan's
     * context.
     */
    fun shouldBelieve(formula: String, within: Duration = PATIENCE): TestAgent =
        formula(formula).let { expect(within, "believes $formula") { inspector.believes(it) } }

    /** Expects that the agent does not believe [formula] at any time. */
    fun shouldNotBelieve(formula: String, during: Duration = PATIENCE): TestAgent =
        formula(formula).let { refuse(during, "believes $formula") { inspector.believes(it) } }

    /** Expects that [goal] is among the agent's intentions at some time, such as `patrol` or `goto(3,_)`. */
    fun shouldIntend(goal: String, within: Duration = PATIENCE): TestAgent =
        goal(goal).let { expect(within, "intends $goal") { inspector.intends(it) } }

    /** Expects that [goal] is not among the agent's intentions at any time. */
    fun shouldNotIntend(goal: String, during: Duration = PATIENCE): TestAgent =
        goal(goal).let { refuse(during, "intends $goal") { inspector.intends(it) } }

    /** Expects that the agent has printed or prints a line that contains [text]. */
    fun shouldPrint(text: String, within: Duration = PATIENCE): TestAgent =
        expect(within, "prints $text") { printed.any { text in it } }

    /**
     * Expects that the agent has sent or sends [message], such as `tell(bob,ready)`. A message to all agents is `tell(everybody,ready)`.
     */
    fun shouldSay(message: String, within: Duration = PATIENCE): TestAgent =
        expect(within, "says $message") { infra.said.any { described(it) == message.filterNot(Char::isWhitespace) } }

    /** Expects that the agent has stopped, for example by `.stopMAS` or `.kill_agent`. */
    fun shouldStop(within: Duration = PATIENCE): TestAgent = expect(within, "stops") { !isRunning }

    /** Stops the agent, as `.kill_agent` does. The agent's boards remain, and their ports are closed. */
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

    /** Wakes the agent each second, as Jason does. */
    private fun wakeEachSecond() {
        infra.wake()
        if (isRunning) time.later(nanos(1.seconds), ::wakeEachSecond)
    }

    internal fun end() {
        if (!isRunning) return
        infra.end()
        setUp.environment?.takeIf { mas.running().none { other -> other.setUp.environment === it } }?.stop()
    }

    internal fun takeBoardsAway() = platform.all().forEach(Board::end)

    /**
     * Stops the agent and all other agents of its test, and removes their boards.
     * @throws IllegalStateException if an architecture leaves a thread behind
     */
    override fun close() = mas.close()

    internal companion object {
        /** The second request shows that the agent has read the first answer. */
        private const val ANSWERS_UNTIL_KNOWN = 2
    }
}

/** The default time limit of an expectation. */
internal val PATIENCE = 1.seconds

/** @throws IllegalArgumentException if [duration] is negative or too long */
internal fun nanos(duration: Duration): Long {
    require(!duration.isNegative()) { "time does not go back: $duration" }
    require(duration <= LONGEST) { "a test lasts $LONGEST at most, not $duration" }
    return duration.inWholeNanoseconds
}

private val LONGEST = 3650.days

internal fun described(message: Message) = "${message.ilForce}(${message.receiver},${message.propCont})".filterNot(Char::isWhitespace)
