package argo.check.project

import java.io.IOException
import java.nio.file.FileSystemLoopException
import java.nio.file.FileVisitOption
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes
import kotlin.io.path.extension
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes

/**
 * Reads the projects below a folder. A folder with a project file (`.mas2j` or `.jcm`) and all its subfolders form one project. All
 * programs outside such folders form one more project.
 *
 * @param maxFiles the greatest number of files in a folder that are read
 */
class ProjectReader(private val maxFiles: Int = 20_000) {
    private val leftOut = LinkedHashMap<Path, String>()

    /** Returns the projects in [place]: a folder, a project file or a program. Each file belongs to one project. */
    fun projectsIn(place: Path): List<Project> {
        val start = place.toAbsolutePath().normalize()
        if (!Files.isDirectory(start)) return listOf(projectOf(start))
        val files = filesBelow(start)
        val roots = files.filter { it.extension in PROJECT_FILES }.map { it.parent }.toSet()
        return files.groupBy { file -> generateSequence(file.parent) { it.parent }.firstOrNull { it in roots } ?: start }
            .filter { (_, inside) -> inside.any { it.extension == "asl" || it.extension in PROJECT_FILES } }
            .map { (root, inside) -> read(root, inside) }.sortedBy { it.root }
            .ifEmpty { if (leftOut.isEmpty()) emptyList() else listOf(read(start, emptyList())) }
            .let { all -> all.map { project -> project.copy(leftOut = leftOut.filterKeys { ownerOf(it, all) === project }) } }
    }

    private fun ownerOf(file: Path, projects: List<Project>): Project =
        projects.filter { file in it.programs || file.startsWith(it.root) }.maxByOrNull { it.root.nameCount } ?: projects.first()

    /** Returns the project of [file]. The project's root is the nearest parent folder with a project file, or else the folder of [file]. */
    fun projectOf(file: Path): Project {
        val folder = file.toAbsolutePath().normalize().parent
        val all = projectsIn(rootOf(file) ?: folder)
        return all.find { file.toAbsolutePath().normalize() in it.programs } ?: all.firstOrNull()
            ?: read(folder, listOf(file)).copy(leftOut = leftOut)
    }

    /** Returns the programs directly in [folder] as a project. Skips subfolders, since [folder] may be the root of a disk. */
    fun programsIn(folder: Path): Project =
        read(folder, if (Files.isDirectory(folder)) folder.listDirectoryEntries("*.asl").filter { it.isRegularFile() } else emptyList())

    private fun filesBelow(folder: Path): List<Path> {
        val found = ArrayList<Path>()
        Files.walkFileTree(folder, setOf(FileVisitOption.FOLLOW_LINKS), Int.MAX_VALUE, object : SimpleFileVisitor<Path>() {
            override fun preVisitDirectory(dir: Path, attrs: BasicFileAttributes): FileVisitResult =
                if (isOutput(dir)) FileVisitResult.SKIP_SUBTREE else FileVisitResult.CONTINUE

            override fun visitFile(file: Path, attrs: BasicFileAttributes): FileVisitResult {
                if (file.extension in READ || isPercepts(file)) {
                    if (attrs.isRegularFile) found.add(file) else if (!file.name.startsWith(EDITORS_LOCK)) leaveOut(file, NO_FILE)
                }
                return if (found.size <= maxFiles) FileVisitResult.CONTINUE else FileVisitResult.TERMINATE
            }

            /** Skips a link to a parent folder without a finding, since the walk reads that folder anyway. */
            override fun visitFileFailed(file: Path, refused: IOException): FileVisitResult {
                if (refused !is FileSystemLoopException && !isOutput(file)) leaveOut(file, "it cannot be read: $refused")
                return FileVisitResult.CONTINUE
            }

            private fun isOutput(dir: Path) = dir != folder && (dir.name in OUTPUTS || dir.name.startsWith("."))
        })
        if (found.size > maxFiles) leftOut[folder] = "it has more than $maxFiles files, and the others are left out"
        return found.take(maxFiles).sorted().groupBy(::originalOf)
            .map { (original, same) -> if (original in same) original else same.first() }
    }

    /** Returns the real path of [file]. Links to one file then count once. */
    private fun originalOf(file: Path): Path = try {
        file.toRealPath()
    } catch (_: IOException) {
        file // the file is gone; reading it reports the problem
    }

    private fun read(root: Path, files: List<Path>): Project {
        val byKind = files.groupBy { it.extension }
        val masFiles = byKind["mas2j"].orEmpty().map { MasFile(it, textOf(it)) }
        val sources = byKind["asl"].orEmpty() + masFiles.flatMap { mas -> mas.agents.mapNotNull { outside(mas, it, files) } }
        val programs = sources.distinct().associateWith { AgentProgram(it, textOf(it)) }
        val called = programs.values.flatMap { it.filtersCalled }.toSet()
        val documents = files.filter { it.extension in DOCUMENTS }.associateWith { textOf(it) }
        val foreign = files.filter { it.extension in FOREIGN }.associateWith { textOf(it) } + documents.filterValues { ORGANISATION in it }
        val perceptFiles = files.filter { isPercepts(it) }.map { ProjectFile(it, textOf(it)) }
        return Project(
            root, programs,
            masFiles + files.filter { it.extension in OTHER_PROJECT_FILES }.map { ProjectFile(it, textOf(it)) },
            foreign.values.flatMap { text -> WORD.findAll(text).map { it.value } }.toSet(),
            foreign.values.flatMap(::operationsIn).toSet(),
            javaActions(files), files.any { it.extension == "java" || it.extension == "kt" },
            documents.filter { (path, text) -> FilterFile.isMeant(path, text, called) }.map { (path, text) -> FilterFile.of(path, text) },
            robotIn(foreign, perceptFiles, files.filter { it.extension == RECORDING }), perceptFiles,
            leftOut = emptyMap(),
        )
    }

    /** Returns the program of [agent] if it is outside the project's folder. Returns null if it is inside or missing. */
    private fun outside(mas: MasFile, agent: MasAgent, inside: List<Path>): Path? =
        (listOf("") + mas.sourcePaths).map { mas.path.parent.resolve(it).resolve(agent.source).normalize() }
            .firstOrNull { it !in inside && Files.isRegularFile(it) }

    private fun textOf(file: Path): String = try {
        when {
            Files.exists(file) && !Files.isRegularFile(file) -> leaveOut(file, NO_FILE)
            Files.size(file) > MAX_BYTES -> leaveOut(file, "it has more than $MAX_BYTES bytes")
            else -> file.readBytes().toString(Charsets.UTF_8).let { if (isPercepts(file)) it.removePrefix("\uFEFF") else it }
        }
    } catch (unreadable: IOException) {
        leaveOut(file, "it cannot be read: $unreadable")
    }

    private fun leaveOut(file: Path, why: String): String {
        leftOut[file] = why
        return ""
    }

    private fun operationsIn(text: String): List<String> =
        STRING.findAll(text).flatMap { string -> WORD.findAll(string.value).map { it.value } }.toList() +
            OPERATION.findAll(text).map { it.groupValues[1] }

    /** Returns the internal actions of the project's own classes, as programs name them: `package.name`, or `.name` in Jason's package. */
    private fun javaActions(files: List<Path>): Set<String> = files.filter { it.extension == "java" || it.extension == "kt" }.map {
        "${it.parent.name.takeUnless(STDLIB::equals).orEmpty()}.${it.name.substringBeforeLast('.')}"
    }.toSet()

    private fun robotIn(foreign: Map<Path, String>, perceptFiles: List<ProjectFile>, recordings: List<Path>): Robot {
        val boards = foreign.filterKeys { it.extension in BOARDS }.map { (path, text) -> BoardProgram(ProjectFile(path, text)) }
        val mappings = foreign.filterKeys { it.name.endsWith(".ros.yaml") }.values.map(::RosMapping)
        val descriptions = perceptFiles.map(::perceptsFile) + boards.map { it.descriptions }
        val described = descriptions.flatMap { it.percepts }
        val mapped = mappings.flatMap { it.percepts }
        val functors = (described.map { it.meaning } + mapped).map { it.functor() }.toSet()
        val recorded = recordings.flatMap { recordedKinds(textOf(it)) }.filter { it.functor() !in functors }
        return Robot(
            described, boards.flatMap { it.actions }, descriptions.flatMap { it.unreadable },
            mapped + recorded, mappings.flatMap { it.actions }, isComplete = mappings.all { it.isComplete } && recorded.isEmpty(),
        )
    }

    companion object {
        private const val PERCEPTS = "percepts"
        private const val RECORDING = "rec"
        private const val STDLIB = "stdlib"
        private const val NO_FILE = "it is no regular file"

        /** The prefix of Emacs's lock links, which have no target. */
        private const val EDITORS_LOCK = ".#"
        private const val MAX_BYTES = 2_000_000L
        private const val MAX_HEIGHT = 5
        private val PROJECT_FILES = setOf("mas2j", "jcm")
        private val OTHER_PROJECT_FILES = setOf("jcm", "gradle", "kts")
        private val BOARDS = setOf("ino", "cpp", "py")
        private val FOREIGN = setOf("java", "kt", "py", "jcm", "ino", "cpp", "c", "h", "yaml", "yml", "properties")
        private val DOCUMENTS = setOf("xml", "json")
        private val READ = PROJECT_FILES + FOREIGN + DOCUMENTS + setOf("asl", "gradle", "kts", RECORDING)

        /** The beginning of a Moise file. Moise files name goals of agents. */
        private const val ORGANISATION = "<organisational-specification"
        private val OUTPUTS = setOf("build", "target", "bin", "node_modules")
        private val WORD = Regex("[a-z]\\w*")
        private val STRING = Regex("\"[^\"\n]*\"")
        private val OPERATION = Regex("@(?:OPERATION|INTERNAL_OPERATION|LINK)[^(]*?\\bvoid\\s+(\\w+)")

        private fun isPercepts(file: Path): Boolean = file.name == PERCEPTS || file.extension == PERCEPTS

        /** Returns the nearest parent folder of [file] with a project file, or null if no near folder has one. */
        fun rootOf(file: Path): Path? =
            generateSequence(file.toAbsolutePath().normalize().parent) { it.parent }.take(MAX_HEIGHT).firstOrNull(::hasProjectFile)

        private fun hasProjectFile(folder: Path): Boolean = try {
            Files.newDirectoryStream(folder, "*.{mas2j,jcm}").use { it.any() }
        } catch (_: IOException) {
            false
        }
    }
}
