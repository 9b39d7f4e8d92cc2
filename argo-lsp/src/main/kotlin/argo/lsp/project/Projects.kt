package argo.lsp.project

import argo.check.project.AgentProgram
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
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readBytes

/**
 * Finds and reads the projects of open texts. What an editor has open goes before the file. Only the server's worker uses it.
 *
 * @param tell gets what is left out of a project, in words, once
 */
internal class Projects(private val texts: OpenTexts, private val tell: (String) -> Unit) {
    private class Read(var checked: argo.check.project.Project, val robot: Robot)

    private val read = HashMap<Path, Read>()
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
        val known = read[rootOf(file) ?: file.parent] ?: read(file)
        val open = texts.all().mapNotNull { each -> fileOf(each.uri)?.let { it to each } }.toMap()
        open.filterKeys { it.startsWith(known.checked.root) }.forEach { (path, each) -> known.checked = known.checked.with(path, each) }
        return Project(known.checked, known.robot, open)
    }

    /** Returns this project with what the editor has in the file [path], if it has another text there. */
    private fun argo.check.project.Project.with(path: Path, text: Text): argo.check.project.Project = when (path.extension) {
        "asl" -> if (programs[path]?.program?.text == text.content) this else with(path, text.content)
        "mas2j" -> if (projectFiles.any { it.path == path && it.text == text.content }) this
        else copy(projectFiles = projectFiles.filter { it.path != path } + MasFile(path, text.content))
        else -> this
    }

    private fun read(file: Path): Read {
        val root = rootOf(file)
        val found = if (root == null) Read(alone(file.parent), Robot(emptyMap()))
        else Read(ProjectReader().projectOf(file), Robot(descriptionsBelow(root)))
        found.robot.problems.filter(told::add).forEach(tell)
        return found.also { read[root ?: file.parent] = it }
    }

    /** Returns the folder of the project file next above [file]; null: there is none near. */
    private fun rootOf(file: Path): Path? = roots.getOrPut(file.parent) {
        val above = generateSequence(file.parent) { it.parent }.take(MAX_HEIGHT)
        Optional.ofNullable(above.find { it.isDirectory() && it.listDirectoryEntries("*.{mas2j,jcm}").isNotEmpty() })
    }.orElse(null)

    /** The programs of a [folder] without a project file. What is below it may be a whole disk. */
    private fun alone(folder: Path): argo.check.project.Project {
        val files = if (folder.isDirectory()) folder.listDirectoryEntries("*.asl").filter { it.isRegularFile() } else emptyList()
        val programs = files.associateWith { AgentProgram(it, it.readBytes().decodeToString()) }
        return argo.check.project.Project(
            folder, programs, projectFiles = emptyList(), perceptFiles = emptyList(), foreignNames = emptySet(), operations = emptySet(),
            javaActions = emptySet(), hasOwnJava = false, filters = emptyList(), leftOut = emptyMap(),
            robot = argo.check.project.Robot(emptyList(), emptyList()),
        )
    }

    private companion object {
        const val MAX_HEIGHT = 5
    }
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
