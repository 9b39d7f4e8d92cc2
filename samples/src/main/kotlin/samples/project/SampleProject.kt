package samples.project

import jason.asSyntax.Literal
import jason.mas2j.AgentParameters
import jason.mas2j.MAS2JProject
import jason.mas2j.parser.mas2j
import java.net.URL
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.toPath

/**
 * A Jason project on the class path. The project `collision` is the file `collision/collision.mas2j`, with its agents in the folder. The
 * functions of this class change the project after it is read.
 */
class SampleProject(private val name: String) {
    private val source: URL = checkNotNull(SampleProject::class.java.getResource("/$name/$name.mas2j")) {
        "the project $name is not on the class path: $name/$name.mas2j is missing beside the samples' classes"
    }

    /** The project, ready to run from any working directory. */
    val mas: MAS2JProject = source.openStream().use { mas2j(it).mas() }.apply {
        setupDefault()
        if (source.protocol == "file") addSourcePath("${source.toURI().toPath().parent}") // for the includes of agents
        agents.forEach { it.setSource(URL(source, it.source.schemeSpecificPart).toString()) }
    }

    private val given = HashMap<String, List<Literal>>()

    /** The initial beliefs that replace those of the project, by agent name. */
    val beliefs: Map<String, List<Literal>> get() = given

    private fun agent(name: String): AgentParameters = checkNotNull(mas.getAg(name)) { "$source has no agent $name" }

    fun believe(agent: String, vararg beliefs: Literal) {
        agent(agent).addOption("beliefs", "") // [beliefs] contains them, since not every string can be the text of an option
        given[agent] = beliefs.asList()
    }

    fun run(agent: String, file: Path) = agent(agent).setSource("${file.toUri().toURL()}")

    /** Copies [files] of the project, such as `filters/front.xml`, into the new folder [target]. */
    fun copy(files: List<String>, target: Path) = files.forEach { file ->
        val copied = checkNotNull(SampleProject::class.java.getResourceAsStream("/$name/$file")) { "$file is missing in the project $name" }
        copied.use { Files.copy(it, target.resolve(file).apply { parent.createDirectories() }) }
    }

    /** Sets an option of [agent], as `[key=value]` does in the project. */
    fun set(agent: String, key: String, value: String) = agent(agent).addOption(key, value)
}
