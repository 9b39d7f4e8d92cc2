package samples.documents

import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readText

/** The page on the internal actions, generated from the KDoc below [root]. */
class InternalActionsPage(root: Path) {
    private val actions = root.resolve("argo-arch/src/main/kotlin/argo").listDirectoryEntries()
        .filter { it.extension == "kt" && it.name.first().isLowerCase() }.sortedBy { it.name }

    val text: String by lazy {
        """
        # Internal actions

        The reference of the internal actions that plans can call. It is generated from KDoc; a test fails when it is out of date.

        Each action has three forms: `argo.port(P)`, `.port(P)` and `.argo.port(P)`. A failed action fails its plan with a message and an
        annotation `error(…)`: [all errors](errors.md).

        """.trimIndent() + "\n" + actions.joinToString("\n") {
            section(it)
        }
    }

    private fun section(source: Path): String {
        val comment = checkNotNull(COMMENT.find(source.readText())) { "$source: the class of the action has no KDoc" }.groupValues[1]
        val lines = comment.lines().map { it.trim().removePrefix("*").removePrefix(" ") }
        return "## argo.${source.nameWithoutExtension}\n\n" + lines.joinToString("\n").trim()
            .replace(LINK) { "`${it.groupValues[1]}`" } + "\n"
    }

    private companion object {
        /** Matches the comment in front of the action's class. */
        val COMMENT = Regex("""/\*\*((?:(?!\*/).)*)\*/\s*(?:@\S+\s+)*open class""", RegexOption.DOT_MATCHES_ALL)

        /** Matches a link to a declaration, which becomes code on the page. A list in code is no link. */
        val LINK = Regex("""(?<![`\w])\[([A-Z]\w*(?:\.\w+)?)](?!`)""")
    }
}
