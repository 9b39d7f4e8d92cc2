package argo.recording.recorder

import argo.insides.IncludeDirective
import argo.insides.Insides
import argo.orders.ProgramSource
import argo.recording.agent.ProgramNames
import argo.recording.includeMetadata
import argo.recording.programName
import argo.recording.storage.RecordSink
import java.io.IOException
import java.nio.file.Path

/**
 * Stores the program of [agent] in its recording: the file [main], and the files that it includes. Finds included files where Jason finds
 * them. For the agent's thread.
 *
 * @throws IOException if the project's code reads the program
 */
internal class StoredProgram(private val agent: String, main: ProgramSource, private val sink: RecordSink) {
    private class Inclusion(val within: String, val name: String, val file: ProgramSource?)

    private val names = HashMap<String, ProgramSource>() // stored files, by attachment name
    private var inclusions = 0
    private val root: Path

    val main: String

    init {
        val all = ArrayList<Inclusion>()
        findIncluded(main, null, all, HashSet())
        val paths = (listOf(main) + all.mapNotNull { it.file }).mapNotNull { it.path?.parent }
        root = commonDirectory(paths)
        this.main = attached(main)
        all.forEach(::store)
    }

    private fun findIncluded(source: ProgramSource, outer: String?, all: MutableList<Inclusion>, seen: MutableSet<String>) {
        val names = ProgramNames(source.text)
        foreignDirective(names)?.let { throw IOException(it) }
        for (included in names.includes) {
            val within = outer.takeUnless { included.isInBlock }
            val file = ProgramSource.included(included.name, within, IncludeDirective.sourcePath)
            all += Inclusion(within.orEmpty(), included.name, file)
            if (file != null && seen.add(file.address)) findIncluded(file, file.address, all, seen)
        }
    }

    /**
     * Stores the file called [name] that the agent includes at run time. Finds it where Jason will find it. [within] is the name of the
     * including file [outer] by [IncludeDirective.placeOf].
     */
    fun include(name: String, outer: String?, within: String) =
        store(Inclusion(within, name, ProgramSource.included(name, outer, IncludeDirective.sourcePath)))

    private fun store(inclusion: Inclusion) {
        val values = mapOf("within" to inclusion.within, "name" to inclusion.name)
        val file = inclusion.file?.let { mapOf("address" to it.address, "file" to attached(it)) }.orEmpty()
        sink.metadata(includeMetadata(agent, ++inclusions), values + file)
    }

    /** Stores [source] if it is new, and returns the name of its attachment. A file that has changed counts as new. */
    private fun attached(source: ProgramSource): String {
        val wanted = source.path?.takeIf(root::isParentOf)?.let { programName(agent, root.relativize(it)) }
            ?: "${programName(agent, Path.of("included"))}/${source.address.substringAfterLast('/')}"
        val name = generateSequence(1) { it + 1 }.map { if (it == 1) wanted else numbered(wanted, it) }
            .first { names[it]?.bytes?.contentEquals(source.bytes) ?: true }
        if (names.put(name, source) == null) sink.attach(name, "text/plain", source.bytes)
        return name
    }

    private fun numbered(name: String, number: Int) = "${name.substringBeforeLast('/')}/$number/${name.substringAfterLast('/')}"
}

private val JASONS_DIRECTIVES =
    setOf("include", "register_function", "namespace", "dg", "bdg", "ebdg", "bc", "smc", "rc", "omc", "mg", "sga")

/** If the project's code reads a directive in [names], returns the reason why no replay can read the program. Else returns null. */
internal fun foreignDirective(names: ProgramNames): String? =
    (names.directives - JASONS_DIRECTIVES).firstNotNullOfOrNull { directive ->
        val type = Insides.directiveClasses[null][directive] // null if the term only looks like a directive
        type?.let { "the project's class ${it.name} reads its directive $directive" }
    }

private fun Path.isParentOf(file: Path) = file.startsWith(this)

private fun commonDirectory(directories: List<Path>): Path =
    directories.reduceOrNull { one, other -> generateSequence(one) { it.parent }.firstOrNull(other::startsWith) ?: one }
        ?: Path.of("").toAbsolutePath()
