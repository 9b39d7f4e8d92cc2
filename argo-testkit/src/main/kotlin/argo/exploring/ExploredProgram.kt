package argo.exploring

import argo.testkit.AgentSetUp
import argo.testkit.MasSetUp
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
import kotlin.io.path.reader

/** Makes the explored agents, anew for each run. */
internal fun interface ExploredProgram {
    fun MasSetUp.make(setUp: AgentSetUp.() -> Unit)
}

/**
 * Returns the agents in the file [source]: the agent of an `.asl`, or all agents of a `.mas2j`. The file is searched for where the test
 * kit's `agent` searches.
 *
 * @throws IllegalArgumentException if there is no such file, or it cannot be read
 */
internal fun programIn(source: String): ExploredProgram {
    val file = if (Path.of(source).isAbsolute) existing(Path.of(source)) else found(source)
    return if (file.extension == "mas2j") system(file) else ExploredProgram { setUp -> agent(file, setUp) }
}

private fun system(file: Path): ExploredProgram {
    val project = try {
        mas2j(file.reader()).mas()
    } catch (unreadable: ParseException) {
        throw IllegalArgumentException("Jason cannot read $file: ${unreadable.message.orEmpty().lines().first()}", unreadable)
    } catch (unreadable: TokenMgrError) {
        throw IllegalArgumentException("Jason cannot read $file: ${unreadable.message}", unreadable)
    }
    val folder = file.toAbsolutePath().parent
    val folders = project.sourcePaths.paths.map { folder.resolve(it).normalize().toString() } + "$folder"
    return ExploredProgram { setUp ->
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
