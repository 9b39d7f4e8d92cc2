package argo.lsp.project

import argo.check.project.ProjectReader
import argo.lsp.text.OpenTexts
import argo.lsp.text.Text
import java.net.URI
import java.net.URISyntaxException
import java.nio.file.FileSystemNotFoundException
import java.nio.file.Path
import java.util.Optional

/**
 * Finds and reads the projects of open texts. A text in the editor replaces its file. Only the server's worker uses this class. [tell] is
 * called once for each description in a project's files that cannot be read.
 */
internal class Projects(private val texts: OpenTexts, private val tell: (String) -> Unit) {
    /** The projects, by their folders. If there is no project file near a file, the file's folder is the project folder. */
    private val read = HashMap<Path, Project>()
    private val told = HashSet<String>()

    /** Maps folders of files to the project folders that contain them. */
    private val roots = HashMap<Path, Optional<Path>>()

    /** Forgets all projects, so that they are read again. Called after files have changed on the disk, or a text was closed. */
    fun forget() {
        read.clear()
        roots.clear()
    }

    fun of(text: Text): Project {
        val file = fileOf(text.uri) ?: Path.of("nowhere", nameOf(text.uri)).toAbsolutePath()
        val folder = rootOf(file) ?: file.parent
        val last = read[folder] ?: Project(read(file), emptyMap())
        val known = last.checked
        val open = texts.all().mapNotNull { each -> fileOf(each.uri)?.let { it to each } }.toMap()
        val current = open.filterKeys { it.startsWith(known.root) }.entries.fold(known) { it, (path, each) -> it.with(path, each.content) }
        return (if (current === known) Project(current, open, last.check) else Project(current, open)).also { read[folder] = it }
    }

    private fun read(file: Path): argo.check.project.Project {
        val found = if (rootOf(file) == null) ProjectReader().programsIn(file.parent) else ProjectReader().projectOf(file)
        found.robot.unreadable.map { "$it" }.filter(told::add).forEach(tell)
        return found
    }

    /** Returns the folder of the nearest project file above [file]; null if none is near. */
    private fun rootOf(file: Path): Path? =
        roots.getOrPut(file.parent) { Optional.ofNullable(ProjectReader.rootOf(file)) }.orElse(null)
}

/** Returns a name for the text of [uri] that every system accepts as a file's name, unlike `untitled:robot.asl`. */
internal fun nameOf(uri: String): String = uri.substringAfterLast('/').replace(Regex("""[^\p{L}\p{N}._-]"""), "_")

/** Returns the absolute path of the file of [uri]; null if [uri] names no file on this computer. */
internal fun fileOf(uri: String): Path? = try {
    URI(uri).takeIf { it.scheme == "file" }?.let { Path.of(it).toAbsolutePath().normalize() }
} catch (_: IllegalArgumentException) {
    null
} catch (_: URISyntaxException) {
    null
} catch (_: FileSystemNotFoundException) {
    null
}
