package argo.lsp.project

import argo.check.syntax.Span
import argo.lsp.text.Text
import javino.PerceptKind
import java.io.IOException
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes
import kotlin.io.path.extension
import kotlin.io.path.name
import kotlin.io.path.readBytes

/**
 * A word that a board's program gives a meaning to.
 *
 * @property text the file where it does
 * @property span the place in that
 */
internal class Described<T>(val meaning: T, val text: Text, val span: Span)

/** What the boards of a project say of themselves, in their sketches and in files of percepts. */
internal class Robot(files: Map<Path, Text>) {
    private val unreadable = ArrayList<String>()

    val percepts: List<Described<PerceptKind>> = files.entries.flatMap { (file, text) -> perceptsIn(file, text) }

    /** The commands, as `ledOn`. */
    val actions: List<Described<String>> =
        files.filterKeys { it.extension != "" }.values.flatMap { text -> found(ACTION, text, text.content) { it } }

    private fun perceptsIn(file: Path, text: Text): List<Described<PerceptKind>> =
        if (file.extension == "") found(LINE, text, text.content.replace(COMMENT) { " ".repeat(it.value.length) }) { kindOf(it, text) }
        else found(DESCRIPTION, text, text.content) { kindOf(it, text) } + PERCEIVE.findAll(text.content).flatMap { call ->
            // the same length, so that places stay
            found(STRING, text, " ".repeat(call.range.first) + call.value) { kindOf(it, text) }
        }

    /** The descriptions of percepts that cannot be read, each with its file and the reason. */
    val problems: List<String> get() = unreadable

    private fun kindOf(written: String, text: Text): PerceptKind? = try {
        PerceptKind.parse(written)
    } catch (refused: IllegalArgumentException) {
        unreadable += "${text.uri.substringAfterLast('/')}: ${refused.message}"
        null
    }

    private fun <T : Any> found(pattern: Regex, text: Text, content: String, read: (String) -> T?): List<Described<T>> =
        pattern.findAll(content).mapNotNull { match ->
            val group = match.groups[1] ?: return@mapNotNull null
            read(group.value)?.let { Described(it, text, Span(group.range.first, group.range.last + 1)) }
        }.toList()

    companion object {
        /** In a sketch, and in Python, which also takes descriptions behind the function that perceives. */
        private val DESCRIPTION = Regex("""\bdescribe\s*\(\s*(?:F\s*\(\s*)?"([^"\n]*)"""")
        private val PERCEIVE = Regex("""\bperceive\s*\((?:[^()"]++|"[^"\n]*+")*+""")
        private val STRING = Regex(""""([^"\n]*)"""")
        private val ACTION = Regex("""\b(?:act\s*\[|onAction\s*\(|on_action\s*\()\s*(?:F\s*\(\s*)?["']([A-Za-z_]\w*)["']""")
        private val LINE = Regex("""(?m)^[ \t]*(\S.*?)[ \t]*\r?$""")
        private val COMMENT = Regex("#.*")
    }
}

/** Returns the files below [root] that a robot is described in: sketches, programs in Python, and files of percepts. */
internal fun descriptionsBelow(root: Path): Map<Path, Text> {
    val found = LinkedHashMap<Path, Text>()
    Files.walkFileTree(
        root, emptySet(), MAX_DEPTH,
        object : SimpleFileVisitor<Path>() {
            override fun preVisitDirectory(folder: Path, attributes: BasicFileAttributes): FileVisitResult {
                val isLeftOut = folder != root && (folder.name.startsWith(".") || folder.name in OUTPUTS)
                return if (isLeftOut) FileVisitResult.SKIP_SUBTREE else FileVisitResult.CONTINUE
            }

            override fun visitFile(file: Path, attributes: BasicFileAttributes): FileVisitResult {
                val isOne = file.name == "percepts" || file.extension in SKETCHES
                if (isOne && attributes.isRegularFile) found[file] = Text(file.toUri().toString(), 0, file.readBytes().decodeToString())
                return FileVisitResult.CONTINUE
            }

            override fun visitFileFailed(file: Path, failure: IOException) = FileVisitResult.CONTINUE

            override fun postVisitDirectory(folder: Path, failure: IOException?) = FileVisitResult.CONTINUE
        },
    )
    return found
}

private const val MAX_DEPTH = 8
private val OUTPUTS = setOf("build", "target", "bin", "node_modules")
private val SKETCHES = setOf("ino", "py")
