package argo.tools.migration

import java.nio.file.Path
import kotlin.io.path.name

/** Checks a project file: `.mas2j`, `.jcm`, or one of Gradle. */
internal class ProjectCheck(private val file: Path, text: String) {
    private val advices = Advices("$file")
    private val tokens = tokensOf(text)

    /** Returns all advices. [needArch] are the names of the `.asl` files whose agents need `argo.Arch`. */
    fun advices(needArch: Set<String>): List<Advice> {
        tokens.indices.forEach(::architecture)
        tokens.indices.forEach(::otherArgo)
        tokens.indices.forEach(::infrastructure)
        tokens.indices.forEach { advices.archOption(tokens, it) }
        // only the project file of Jason names the architecture of each agent reliably
        if (file.name.endsWith(".mas2j")) agents().forEach { withoutArch(it, needArch) }
        return advices.all
    }

    private fun architecture(at: Int) {
        val start = when {
            tokens[at].text == "agentArchClass" -> at + 1
            words(at, "ag", "-", "arch", ":") -> at + 4
            else -> return
        }
        val name = dottedName(start)
        val what = when {
            name == ARCHITECTURE -> return
            name.equals(ARCHITECTURE, ignoreCase = true) -> "there is no class $name: Java distinguishes upper and lower case"
            name.substringAfterLast('.').equals("Argo", ignoreCase = true) -> "the architecture $name belongs to another version of ARGO"
            name.startsWith("argo.") ->
                return advices.note(tokens[at].line, "ARGO has no class $name; the project may have one", ARCHITECTURE)
            else -> return
        }
        advices.change(tokens[at].line, what, ARCHITECTURE)
    }

    /** Warns of another version's jar: it holds classes of the same names, and the first on the class path wins. */
    private fun otherArgo(at: Int) {
        val text = tokens[at].text
        if (tokens[at].kind != Token.Kind.STRING || !OTHER_ARGO.containsMatchIn(text)) return
        val what = "$text brings another version of ARGO, with classes of the same names"
        advices.change(tokens[at].line, what, "remove it, and put argo.jar into lib/")
    }

    private fun infrastructure(at: Int) {
        if (words(at, "infrastructure", ":", "Centralised")) {
            val what = "the name of this infrastructure is Local now; Jason reads the old one with a message"
            advices.note(tokens[at].line, what, "infrastructure: Local")
        }
    }

    private class Agent(val name: String, val line: Int, val asl: String, val hasArch: Boolean)

    /** Returns the entries behind `agents:`, each up to its `;`. */
    private fun agents(): List<Agent> {
        val start = tokens.indices.firstOrNull { words(it, "agents", ":") }?.plus(2) ?: return emptyList()
        val agents = ArrayList<Agent>()
        var entry = ArrayList<Token>()
        for (token in tokens.drop(start)) {
            if (token.isSymbol('}') || token.isSymbol(':')) break
            if (token.isSymbol(';')) {
                agent(entry)?.let(agents::add)
                entry = ArrayList()
            } else {
                entry += token
            }
        }
        return agents
    }

    private fun agent(entry: List<Token>): Agent? {
        val name = entry.firstOrNull()?.takeIf { it.kind == Token.Kind.WORD } ?: return null
        val extension = entry.indices.firstOrNull { entry[it].text == "asl" && it >= 2 && entry[it - 1].isSymbol('.') }
        val asl = extension?.let { entry[it - 2].text + ".asl" }
            ?: entry.filter { it.kind == Token.Kind.STRING }.map { it.text.trim('"') }.find { it.endsWith(".asl") }?.substringAfterLast('/')
            ?: "${name.text}.asl"
        return Agent(name.text, name.line, asl, entry.any { it.text == "agentArchClass" })
    }

    private fun withoutArch(agent: Agent, needArch: Set<String>) {
        if (agent.hasArch || agent.asl !in needArch) return
        val what = "agent ${agent.name} calls internal actions of ARGO, and has no architecture for them"
        advices.change(agent.line, what, "${agent.name} agentArchClass $ARCHITECTURE;")
    }

    private fun words(at: Int, vararg expected: String) = expected.indices.all { tokens.getOrNull(at + it)?.text == expected[it] }

    private fun dottedName(start: Int): String {
        val name = StringBuilder()
        for (token in tokens.drop(start)) {
            if (token.kind != Token.Kind.WORD && !token.isSymbol('.')) break
            if (token.kind == Token.Kind.WORD && name.isNotEmpty() && !name.endsWith(".")) break
            name.append(token.text)
        }
        return "$name"
    }

    private companion object {
        const val ARCHITECTURE = "argo.Arch"
        val OTHER_ARGO = Regex("chon-group[:/](argo)\\b", RegexOption.IGNORE_CASE)
    }
}
