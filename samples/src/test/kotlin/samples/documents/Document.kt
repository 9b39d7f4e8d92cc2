package samples.documents

import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readLines
import kotlin.io.path.readText

/** A page of the documentation at [path] below the repository's [root]. */
class Document(private val root: Path, val path: Path) {
    val name: String = root.relativize(path).joinToString("/")

    val text: String by lazy { path.readText() }

    val snippets: List<Snippet> by lazy { snippetsOf(path.readLines()) }

    /** The texts in single backquotes outside blocks. A text may continue on the next line. */
    val spans: List<Snippet> by lazy {
        val sentences = FENCED.replace(text) { block -> "\n".repeat(block.value.count { it == '\n' }) }
        SPAN.findAll(sentences).map { span ->
            val line = sentences.substring(0, span.range.first).count { it == '\n' } + 1
            Snippet(name, line, "", span.groupValues[1].replace('\n', ' '))
        }.toList()
    }

    /** The targets of links within the repository, without the part behind `#`. */
    val links: List<String>
        get() = LINK.findAll(FENCED.replace(text, "")).map { it.groupValues[1] }
            .filterNot { "://" in it || it.startsWith("mailto:") }.toList()

    fun leadsTo(link: String): Boolean {
        val (file, anchor) = link.split('#', limit = 2).let { it[0] to it.getOrNull(1) }
        val target = if (file.isEmpty()) path else path.resolveSibling(file).normalize()
        return target.exists() && target.startsWith(root) && (anchor == null || anchor in Document(root, target).anchors)
    }

    private val anchors: Set<String> get() = HEADING.findAll(FENCED.replace(text, "")).map { anchor(it.groupValues[1]) }.toSet()

    private fun snippetsOf(lines: List<String>): List<Snippet> {
        val snippets = mutableListOf<Snippet>()
        var fence: Pair<Int, String>? = null
        lines.forEachIndexed { index, line ->
            val open = fence
            when {
                !line.trimStart().startsWith("```") -> Unit
                open == null -> fence = index to line.trim().removePrefix("```")
                else -> {
                    snippets += Snippet(
                        name, open.first + 1, open.second, lines.subList(open.first + 1, index).joinToString("\n").trimIndent(),
                    )
                    fence = null
                }
            }
        }
        check(fence == null) { "$name: the fence in line ${fence!!.first + 1} is not closed" }
        return snippets
    }

    override fun toString() = name

    companion object {
        private val LINK = Regex("""\[[^\]]*]\(([^) ]+)\)""")
        private val SPAN = Regex("""`([^`]+)`""")
        private val HEADING = Regex("""(?m)^#+ +(.+?) *$""")
        private val FENCED = Regex("""(?ms)^ *```.*?^ *```""")

        /** Returns all pages of the repository at [root]. Leaves out projects that `./argo new` has made there. */
        fun all(root: Path): List<Document> = root.toFile().walk()
            .onEnter { it == root.toFile() || it.name !in NOT_OURS && !it.resolve("lib/argo.jar").exists() }
            .filter { it.isFile && it.extension == "md" }.map { Document(root, it.toPath()) }.sortedBy { it.name }.toList()

        private val NOT_OURS = setOf("target", "build", "dist", ".argo", ".git", ".gradle")

        /** Returns the anchor that GitHub and other forges give a heading. */
        private fun anchor(heading: String) = heading.lowercase().replace(Regex("""[^\p{L}\p{N} _-]"""), "").replace(' ', '-')
    }
}

/** A fenced block of [language] that starts in [line] of [document]. */
class Snippet(val document: String, val line: Int, val language: String, val text: String) {
    override fun toString() = "$document:$line"
}
