package samples.documents

import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readText

/** The page on the internal actions, made of what the sources below [root] say of each, so that it cannot say anything else. */
class InternalActionsPage(root: Path) {
    private val actions = root.resolve("argo-arch/src/main/kotlin/argo").listDirectoryEntries()
        .filter { it.extension == "kt" && it.name.first().isLowerCase() }.sortedBy { it.name }

    val text: String by lazy {
        """
        # Internal actions

        What plans can call. This page is made from the sources, and every test compares them.

        Each action has three forms: `argo.port(P)`, `.port(P)` and `.argo.port(P)`. One that cannot do what it was asked fails its plan with a message and
        an annotation `error(…)`: [all of them](errors.md).

        """.trimIndent() + "\n" + actions.joinToString("\n") { section(it) }
    }

    private fun section(source: Path): String {
        val comment = checkNotNull(COMMENT.find(source.readText())) { "$source does not say what it does" }.groupValues[1]
        val lines = comment.lines().map { it.trim().removePrefix("*").removePrefix(" ") }
        return "## argo.${source.nameWithoutExtension}\n\n" + lines.joinToString("\n").trim().replace(LINK) { "`${it.groupValues[1]}`" } + "\n"
    }

    private companion object {
        /** The comment right before the class of the action. */
        val COMMENT = Regex("""/\*\*((?:(?!\*/).)*)\*/\s*(?:@\S+\s+)*open class""", RegexOption.DOT_MATCHES_ALL)

        /** A link to a declaration, which is code outside the sources; not what a list in code looks like. */
        val LINK = Regex("""(?<![`\w])\[([A-Z]\w*(?:\.\w+)?)](?!`)""")
    }
}
