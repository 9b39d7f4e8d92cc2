package argo.exploring

import kotlin.time.Duration
import kotlin.time.TimeMark
import kotlin.time.TimeSource

/** The outcome of an exploration. */
sealed interface Outcome {
    /** The number of runs, including runs for shrinking. */
    val runs: Int

    /** The total length of all runs, in virtual time. */
    val played: Duration
}

/** No run broke a rule. */
data class NothingFound(override val runs: Int, override val played: Duration) : Outcome

/** Two runs with equal [events] differ. No run can therefore be repeated. [difference] describes the first difference. */
data class NotDeterministic(override val runs: Int, override val played: Duration, val events: List<WorldEvent>, val difference: String) :
    Outcome

/**
 * A run breaks a rule.
 *
 * @property seed the seed of the run, or null if the run has no events
 * @property events the events after shrinking
 * @property drawn the number of events before shrinking
 */
class Found internal constructor(
    override val runs: Int,
    override val played: Duration,
    val seed: Long?,
    val rule: String,
    val breach: Breach,
    val events: List<WorldEvent>,
    val drawn: Int,
    val run: Run,
    internal val scenario: Scenario,
) : Outcome

internal class Search(private val scenario: Scenario, private val clock: TimeSource) {
    private val exploration = scenario.exploration
    private var runs = 0
    private var played = Duration.ZERO
    private val opened = HashSet<String>()

    fun look(): Outcome {
        val end = clock.markNow() + exploration.time
        val calm = play(emptyList())
        requireAgents(calm)
        calm.differenceFrom(play(emptyList()))?.let { return NotDeterministic(runs, played, emptyList(), it) }
        scenario.breachIn(calm)?.let { (rule, _) -> return found(null, rule, emptyList()) }
        return among(RandomEvents(exploration, calm.agents), end)
    }

    private fun among(random: RandomEvents, end: TimeMark): Outcome {
        var left = exploration.runs
        for (seed in exploration.seed until exploration.seed + exploration.runs) {
            if (left-- <= 0 || end.hasPassedNow()) break
            val events = random.events(seed)
            val run = play(events)
            outcome(seed, events, run)?.let { return it }
            val hit = if (isHit(seed) && left > 0) random.atCommand(run, events, seed) else null
            if (hit == null) continue
            left--
            outcome(seed, hit, play(hit))?.let { return it }
        }
        requireOpened()
        return NothingFound(runs, played)
    }

    /**
     * Returns true if the events of [seed] are played a second time with an additional fault that hits a command. Most errors need no
     * additional fault and then show in fewer events, so this is not done for each seed.
     */
    private fun isHit(seed: Long) = seed - exploration.seed >= HIT_FROM && seed % HIT_EACH == 0L

    private fun outcome(seed: Long, events: List<WorldEvent>, run: Run): Outcome? {
        val (rule, _) = scenario.breachIn(run) ?: return null
        run.differenceFrom(play(events))?.let { return NotDeterministic(runs, played, events, it) }
        return found(seed, rule, events)
    }

    private fun found(seed: Long?, rule: Rule, drawn: List<WorldEvent>): Found {
        val events = Shrinker(MOST_SHRINKING) { rule.breachIn(play(it)) != null }.shrink(drawn)
        val run = play(events)
        val breach = checkNotNull(rule.breachIn(run)) { "\"${rule.name}\" is broken by one run and not by the next: ${jsonOf(events)}" }
        return Found(runs, played, seed, rule.name, breach, events, drawn.size, run, scenario)
    }

    private fun play(events: List<WorldEvent>): Run = scenario.play(events).also {
        runs++
        played += it.ended
        opened += it.opened
    }

    private fun requireAgents(run: Run) = exploration.messages.forEach {
        require(it.agent in run.agents) { "a message is for the agent ${it.agent}; there are ${run.agents.joinToString()}" }
    }

    private fun requireOpened() {
        val missed = exploration.boards.keys - opened
        require(missed.isEmpty()) {
            val found = opened.joinToString().ifEmpty { "none" }
            "no agent has opened the port ${missed.first()} of a board that is described; opened were: $found"
        }
    }

    private companion object {
        /** After this many runs, one run in [HIT_EACH] is repeated with a fault at a command. */
        const val HIT_FROM = 20L
        const val HIT_EACH = 3L

        const val MOST_SHRINKING = 400
    }
}
