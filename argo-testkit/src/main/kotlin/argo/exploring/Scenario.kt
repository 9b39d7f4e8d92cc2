package argo.exploring

import argo.testkit.AgentSetUp
import argo.testkit.TestObserverProvider
import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension
import kotlin.time.Duration

/** The subject of an exploration: [program] with the boards and rules of [exploration]. */
internal class Scenario(private val program: ExploredProgram, private val source: String, val exploration: Exploration) {
    fun play(events: List<WorldEvent>): Run = Player(exploration, events.sortedBy { it.at }).play(program)

    /**
     * Runs the agents with [events] of a user.
     *
     * @throws IllegalArgumentException if an event names an unknown board, sensor or agent. Events with unknown names would have no effect
     */
    fun playWritten(events: List<WorldEvent>): Run {
        events.map { it.form }.forEach { form ->
            val board = form.field("board")
            requireThere(form, board, exploration.boards.keys)
            requireThere(form, form.field("sensor"), exploration.boards[board]?.sensors.orEmpty().map { it.name })
        }
        return play(events).also { run -> events.map { it.form }.forEach { requireThere(it, it.field("agent"), run.agents) } }
    }

    private fun requireThere(event: EventForm, wanted: Any?, there: Collection<String>) =
        require(wanted == null || wanted in there) { "${event.kotlin} is about $wanted, and there are only ${there.joinToString()}" }

    fun breachIn(run: Run): Pair<Rule, Breach>? =
        exploration.kept.mapNotNull { rule -> rule.breachIn(run)?.let { rule to it } }.minByOrNull { (_, breach) -> breach.at }

    val name: String get() = Path.of(source).nameWithoutExtension

    val file: String get() = source
}

internal fun AgentSetUp.describedBy(exploration: Exploration, state: WorldState) {
    exploration.setUps.forEach { it() }
    if (arch == null) return
    options(TestObserverProvider.OPTION to "explored")
    exploration.boards.forEach { (port, described) ->
        val board = board(port)
        if (described.isVersion2) board.version2()
        described.known?.let { board.knows(*it.toTypedArray()) }
        if (described.sensors.isNotEmpty()) board.shows { at -> state.percepts(port, at) }
        described.scripts.forEach { board.it() }
    }
}

internal fun Exploration.lengthOf(events: List<WorldEvent>): Duration = (events.maxOfOrNull { it.ends } ?: Duration.ZERO) + settling
