package argo.check.project

import argo.check.syntax.Belief
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.SyntaxError
import argo.check.syntax.Token
import argo.check.syntax.TokenKind
import argo.check.syntax.programOf
import java.nio.file.Path

class AgentOption(val name: Token, val value: Token?)

/**
 * An agent in a Jason project file.
 *
 * @property source the path of the program as written, with its extension
 * @property architectures the names behind `agentArchClass`
 * @property hasOwnClass true if the agent has an agent class or a belief base class of its own. The agent may then select events, options
 * and intentions differently, or hold other beliefs
 * @property computers the string behind `at` with the names of computers, or null if there is none
 */
class MasAgent(
    val name: Token,
    val source: String,
    val options: List<AgentOption>,
    val architectures: List<Token>,
    val hasOwnClass: Boolean,
    val number: Int,
    val computers: Token? = null,
) {
    /** The initial beliefs and goals in the agent's options: `[beliefs="limit(20)", goals="drive"]`. */
    val initial: List<Mention> by lazy {
        options.flatMap { option -> INITIAL[option.name.text]?.let { role -> literalsIn(option).map { Mention(role, it) } }.orEmpty() }
    }

    val isArgo: Boolean get() = architectures.any { it.text == ARCHITECTURE }

    /** The names of all agents that Jason starts for this entry. */
    val names: List<String> get() = if (number == 1) listOf(name.text) else (1..number).map { "${name.text}$it" }

    companion object {
        const val ARCHITECTURE = "argo.Arch"
        private val INITIAL = mapOf("beliefs" to Role.BELIEVED, "goals" to Role.POSTED)

        private fun literalsIn(option: AgentOption): List<Literal> {
            val text = option.value?.text.orEmpty().removeSurrounding("\"").replace("\\\"", "\"")
            val holder = programOf("initial([$text]).").components.singleOrNull() as? Belief
            return ((holder?.head as? Literal)?.arguments?.singleOrNull() as? ListTerm)?.items.orEmpty().filterIsInstance<Literal>()
        }
    }
}

/** A Jason project file (`.mas2j`). Parts with errors are skipped. */
class MasFile(path: Path, text: String) : ProjectFile(path, text) {
    val environment: Token? = after("environment").firstOrNull()

    private val infrastructure: Token? = after("infrastructure").firstOrNull()

    /** True if the agents may meet agents of other projects. */
    val isDistributed: Boolean = infrastructure?.let { it.text !in LOCAL } == true

    /** The fleet of computers that runs this project, or null if there is none. */
    val fleet: MasFleet? = infrastructure?.takeIf { it.text == "Fleet" }?.let { MasFleet(after("infrastructure"), lines) }

    val sourcePaths: List<String> = after("aslSourcePath").takeWhile { it.kind == TokenKind.STRING || it.isSymbol(";") }
        .filter { it.kind == TokenKind.STRING }.map { it.text.trim('"') }

    val agents: List<MasAgent> = entries().mapNotNull(::agent)

    private fun after(section: String): List<Token> {
        val start = tokens.indices.firstOrNull { tokens[it].text == section && tokens.getOrNull(it + 1)?.isSymbol(":") == true }
        return if (start == null) emptyList() else tokens.drop(start + 2)
    }

    private fun entries(): List<List<Token>> {
        val entries = arrayListOf(ArrayList<Token>())
        val all = after(MasSyntax.AGENTS)
        for ((index, token) in all.withIndex()) {
            if (token.isSymbol("}") || all.getOrNull(index + 1)?.isSymbol(":") == true && token.text in MasSyntax.SECTIONS) break
            if (token.isSymbol(";")) entries += ArrayList<Token>() else entries.last() += token
        }
        return entries.filter { it.isNotEmpty() }
    }

    private fun agent(entry: List<Token>): MasAgent? {
        val name = entry.first().takeIf { it.kind == TokenKind.ATOM || it.kind == TokenKind.VARIABLE } ?: return null
        val file = entry.drop(1).takeWhile { !it.isSymbol("[") && it.text != "#" && it.text !in MasSyntax.WORDS }
        val written = if (file.isEmpty()) name.text else text.substring(file.first().span.start, file.last().span.end)
        val behind = entry.zipWithNext()
        return MasAgent(
            name, if (written.endsWith(".asl")) written else "$written.asl", options(entry),
            behind.filter { it.first.text == "agentArchClass" }.map { it.second },
            entry.any { it.text == "agentClass" || it.text == "beliefBaseClass" },
            behind.firstOrNull { it.first.text == "#" }?.second?.text?.toIntOrNull() ?: 1,
            behind.firstOrNull { it.first.text == "at" && it.second.kind == TokenKind.STRING }?.second,
        )
    }

    private fun options(entry: List<Token>): List<AgentOption> {
        val start = entry.indexOfFirst { it.isSymbol("[") }
        if (start < 0) return emptyList()
        val list = entry.drop(start + 1).takeWhile { !it.isSymbol("]") }
        return list.indices.filter { list.getOrNull(it + 1)?.isSymbol("=") == true }.map { AgentOption(list[it], list.getOrNull(it + 2)) }
    }

    /** The first token that Jason refuses in the head, the sections and the agents' ends; null: Jason accepts these parts. */
    internal val error: SyntaxError? by lazy { MasSyntax(tokens, Token(TokenKind.UNKNOWN, "", lines.end)).error() }

    private companion object {
        /** The infrastructures that use one computer. */
        val LOCAL = setOf("Centralised", "Local")
    }
}
