package argo.exploring

import argo.testkit.AgentSetUp
import argo.testkit.MasSetUp
import argo.testkit.TestObserverProvider
import argo.testkit.archOf
import argo.testkit.existing
import argo.testkit.found
import jason.asSemantics.Agent
import jason.environment.Environment
import jason.mas2j.AgentParameters
import jason.mas2j.MAS2JProject
import jason.mas2j.parser.ParseException
import jason.mas2j.parser.TokenMgrError
import jason.mas2j.parser.mas2j
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.reader
import kotlin.time.Duration

/** Makes the explored agents, anew for each run. */
internal fun interface Program {
    fun MasSetUp.make(setUp: AgentSetUp.() -> Unit)
}

/**
 * Returns the agents in the file [source]: the agent of an `.asl`, or all agents of a `.mas2j`. The file is searched for where the test
 * kit's `agent` searches.
 *
 * @throws IllegalArgumentException if there is no such file, or it cannot be read
 */
internal fun programIn(source: String): Program {
    val file = if (Path.of(source).isAbsolute) existing(Path.of(source)) else found(source)
    return if (file.extension == "mas2j") system(file) else Program { setUp -> agent(file, setUp) }
}

private fun system(file: Path): Program {
    val project = try {
        mas2j(file.reader()).mas()
    } catch (unreadable: ParseException) {
        throw IllegalArgumentException("Jason cannot read $file: ${unreadable.message.orEmpty().lines().first()}", unreadable)
    } catch (unreadable: TokenMgrError) {
        throw IllegalArgumentException("Jason cannot read $file: ${unreadable.message}", unreadable)
    }
    val folder = file.toAbsolutePath().parent
    val folders = project.sourcePaths.paths.map { folder.resolve(it).normalize().toString() } + "$folder"
    return Program { setUp ->
        val environment = environmentOf(project)
        project.agents.forEach { parameters ->
            val source = found(parameters.sourceAsFile?.path ?: "${parameters.name}.asl", folders)
            for (i in 1..parameters.nbInstances) agent(source) {
                name = if (parameters.nbInstances == 1) parameters.name else "${parameters.name}$i"
                take(parameters)
                this.environment = environment
                sourcePath(*folders.toTypedArray())
                setUp()
            }
        }
    }
}

private fun AgentSetUp.take(parameters: AgentParameters) {
    parameters.agClass?.className?.let { agentClass = classOf(it, Agent::class.java) }
    val classes = parameters.agArchClasses
    arch = if (classes.isEmpty()) null else archOf(classes, null)
    parameters.options.orEmpty().forEach { (name, value) -> options(name to textIn(value)) }
}

/** Returns the text of an option's [value], without the quotes around it and the backslashes before quotes within. */
private fun textIn(value: String) = if (value.startsWith('"')) value.removeSurrounding("\"").replace("\\\"", "\"") else value

private fun environmentOf(project: MAS2JProject): Environment? = project.envClass?.let { wanted ->
    classOf(wanted.className, Environment::class.java).getDeclaredConstructor().newInstance()
        .also { it.init(wanted.parametersArray.orEmpty()) }
}

private fun <T> classOf(name: String, type: Class<T>): Class<out T> = try {
    Class.forName(name).asSubclass(type)
} catch (unusable: ReflectiveOperationException) {
    throw IllegalArgumentException("the class $name cannot be used: ${unusable.message}", unusable)
} catch (other: ClassCastException) {
    throw IllegalArgumentException("the class $name is no ${type.name}", other)
}

/** The subject of an exploration: [program] with the boards and rules of [exploration]. */
internal class Scenario(private val program: Program, private val source: String, val exploration: Exploration) {
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
