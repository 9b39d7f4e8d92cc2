package argo.lsp.project

import argo.check.project.MasFile
import argo.check.project.ProjectReader
import argo.lsp.text.OpenTexts
import argo.lsp.text.Text
import java.net.URI
import java.net.URISyntaxException
import java.nio.file.FileSystemNotFoundException
import java.nio.file.Path
import java.util.Optional
import kotlin.io.path.extension

/**
 * Finds and reads the projects of open texts. What an editor has open goes before the file. Only the server's worker uses it.
 *
 * @param tell gets what is left out of a project, in words, once
 */
internal class Projects(private val texts: OpenTexts, private val tell: (String) -> Unit) {
    /** The projects, by their folders, or by folders without a project file. */
    private val read = HashMap<Path, argo.check.project.Project>()
    private val told = HashSet<String>()

    /** The folders of projects, by the folders of files in them. */
    private val roots = HashMap<Path, Optional<Path>>()

    /** Files have changed on the disk, or are read from there again: the projects are read anew. */
    fun forget() {
        read.clear()
        roots.clear()
    }

    /** Returns the project that [text] belongs to. */
    fun of(text: Text): Project {
        val file = fileOf(text.uri) ?: Path.of("nowhere", text.uri.substringAfterLast('/')).toAbsolutePath()
        val folder = rootOf(file) ?: file.parent
        val known = read[folder] ?: read(file)
        val open = texts.all().mapNotNull { each -> fileOf(each.uri)?.let { it to each } }.toMap()
        val current = open.filterKeys { it.startsWith(known.root) }.entries.fold(known) { it, (path, each) -> it.with(path, each) }
        read[folder] = current
        return Project(current, open)
    }

    /** Returns this project with what the editor has in the file [path], if it has another text there. */
    private fun argo.check.project.Project.with(path: Path, text: Text): argo.check.project.Project = when (path.extension) {
        "asl" -> if (programs[path]?.program?.text == text.content) this else with(path, text.content)
        "mas2j" -> if (projectFiles.any { it.path == path && it.text == text.content }) this
        else copy(projectFiles = projectFiles.filter { it.path != path } + MasFile(path, text.content))
        else -> this
    }

    private fun read(file: Path): argo.check.project.Project {
        val found = if (rootOf(file) == null) ProjectReader().programsIn(file.parent) else ProjectReader().projectOf(file)
        found.robot.unreadable.filter(told::add).forEach(tell)
        return found
    }

    /** Returns the folder of the project file next above [file]; null: there is none near. */
    private fun rootOf(file: Path): Path? =
        roots.getOrPut(file.parent) { Optional.ofNullable(ProjectReader.rootOf(file)) }.orElse(null)
}

/** Returns the file of [uri], an absolute path; null: it is no file here. */
internal fun fileOf(uri: String): Path? = try {
    URI(uri).takeIf { it.scheme == "file" }?.let { Path.of(it).toAbsolutePath().normalize() }
} catch (_: IllegalArgumentException) {
    null
} catch (_: URISyntaxException) {
    null
} catch (_: FileSystemNotFoundException) {
    null
}
