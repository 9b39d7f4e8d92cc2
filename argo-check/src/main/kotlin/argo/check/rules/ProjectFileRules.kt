package argo.check.rules

import argo.check.findings.Finding
import argo.check.findings.Level
import argo.check.findings.Place
import argo.check.project.AgentOption
import argo.check.project.MasAgent
import argo.check.project.MasFile
import argo.check.project.Project
import argo.check.project.ProjectFile
import argo.check.project.Role
import argo.check.syntax.Position
import argo.check.syntax.Token
import argo.check.syntax.TokenKind

internal object ProjectFileRules {
    private const val ARCHITECTURE = MasAgent.ARCHITECTURE
    private val INFRASTRUCTURES = setOf("Local", "Jade", "Fleet")
    private val OTHER_ARGO = Regex("chon-group[:/](argo)\\b", RegexOption.IGNORE_CASE)

    fun check(project: Project): List<Finding> = project.projectFiles.flatMap { check(project, it) }

    /** Returns the lines of percept files, and the files of the project, that are left out. */
    fun left(project: Project): List<Finding> = project.robot.unreadable.filter { it.file in project.perceptFiles }.map {
        Finding("percepts-file", Level.ERROR, it.file.place(it.span), it.reason, "this line is left out", "correct it")
    } + project.leftOut.map { (file, why) ->
        Finding("left-out", Level.WARNING, Place(file, Position(1, 1), Position(1, 1)), "this is not checked: $why",
            "its names are not known", "make it a readable file, or smaller")
    }

    private fun check(project: Project, file: ProjectFile): List<Finding> {
        val report = Report(file::place)
        file.tokens.indices.forEach { at ->
            architecture(file.tokens, at, report)
            otherArgo(file.tokens[at], report)
            infrastructure(file.tokens, at, report)
        }
        if (file is MasFile) {
            file.error?.let { report.error("syntax", it.span, it.message, "Jason does not start the project", "correct it") }
            file.agents.forEach { agent(project, file, it, report) }
            FleetRules.check(file, report)
        } else {
            options(file.tokens, report)
        }
        return report.findings
    }

    private fun architecture(tokens: List<Token>, at: Int, report: Report) {
        val isNamed = tokens[at].text == "agentArchClass" || words(tokens, at - 3, "ag", "-", "arch", ":")
        val token = tokens.getOrNull(at + 1)?.takeIf { isNamed } ?: return
        val rest = tokens.getOrNull(at + 2)?.takeIf { it.span.start == token.span.end && it.text.startsWith('.') }?.text
        val name = token.text + rest.orEmpty() // the lexer reads an upper-case name as a variable that ends at the dot
        val why = "the agent does not start"
        when {
            name == ARCHITECTURE -> {}
            name.equals(ARCHITECTURE, ignoreCase = true) ->
                report.error("architecture", token.span, "there is no class $name: Java distinguishes upper and lower case", why,
                    ARCHITECTURE)
            name.substringAfterLast('.').equals("Argo", ignoreCase = true) ->
                report.error("architecture", token.span, "the architecture $name belongs to another version of ARGO", why, ARCHITECTURE)
            name.startsWith("argo.") ->
                report.hint("architecture", token.span, "ARGO has no class $name; the project may have one",
                    "else the agent does not start", ARCHITECTURE)
        }
    }

    /** Reports a jar of another ARGO version. Java uses the first jar on the class path, and both have classes of equal names. */
    private fun otherArgo(token: Token, report: Report) {
        if (token.kind != TokenKind.STRING && !token.text.startsWith('\'') || !OTHER_ARGO.containsMatchIn(token.text)) return
        report.error(
            "other-argo", token.span, "${token.text} brings another version of ARGO",
            "it has classes of the same names, and the first on the class path is used",
            "remove it, and put argo.jar into lib/",
        )
    }

    private fun infrastructure(tokens: List<Token>, at: Int, report: Report) {
        val name = tokens.getOrNull(at + 2)?.takeIf { words(tokens, at, "infrastructure", ":") } ?: return
        when (name.text) {
            in INFRASTRUCTURES -> {}
            "Centralised" -> report.hint("infrastructure", tokens[at].span, "the name of this infrastructure is Local now",
                "Jason reads the old one with a message", "infrastructure: Local")
            else -> report.warning("infrastructure", name.span, "neither Jason nor ARGO has an infrastructure ${name.text}",
                "unless the project has a launcher for it, Jason runs all agents on one computer",
                SimilarNames.near(name.text, INFRASTRUCTURES)?.let { "did you mean $it?" } ?: "there are ${INFRASTRUCTURES.joinToString()}")
        }
    }

    private fun agent(project: Project, file: MasFile, agent: MasAgent, report: Report) {
        agent.options.filter { it.value?.kind != TokenKind.SYMBOL }.forEach { option(it, report) } // Jason refuses a symbol, as of -3
        agent.options.groupBy { it.name.text }.values.mapNotNull { it.getOrNull(1) }.forEach {
            report.warning("arch-option", it.name.span, "${it.name} is given twice", "only the last one counts", "keep one of them")
        }
        val options = agent.options.filter { it.name.text.startsWith("argo_") && it.name.text != KnownOption.OF_FLEET }
        if (!agent.isArgo && agent.architectures.isEmpty()) options.firstOrNull()?.let {
            report.error("no-architecture", it.name.span, "${it.name} has no effect", "only the architecture $ARCHITECTURE reads it",
                "${agent.name} … agentArchClass $ARCHITECTURE;")
        }
        val source = project.sourceOf(file, agent)
        if (source == null) {
            report.warning("no-program", agent.name.span, "there is no program ${agent.source} of agent ${agent.name}",
                "the agent does not start", "correct the name, or the aslSourcePath")
            return
        }
        val calls = project.partsOf(source).programs.flatMap { it.mentions[Role.INTERNAL] }
        val needsBoard = calls.any { ArgoActions.exists(it.functor) && ArgoActions.actionIn(it.functor) in ArgoActions.OF_BOARDS }
        if (needsBoard) FleetRules.board(file, agent, report)
        if (needsBoard && agent.architectures.isEmpty()) {
            report.error(
                "no-architecture", agent.name.span, "agent ${agent.name} calls internal actions of ARGO, and has no architecture for them",
                "the actions fail with error(not_argo)", "${agent.name} agentArchClass $ARCHITECTURE;",
            )
        }
    }

    /** Checks agent options in a JaCaMo file. The options of JaCaMo have another syntax. */
    private fun options(tokens: List<Token>, report: Report) = tokens.indices
        .filter { tokens.getOrNull(it + 1)?.let { next -> next.isSymbol("=") || next.isSymbol(":") } == true }
        .forEach { option(AgentOption(tokens[it], tokens.getOrNull(it + 2)), report) }

    private fun option(option: AgentOption, report: Report) {
        val name = option.name.text
        if (!name.startsWith("argo_")) return
        val known = KnownOption.OF_ARCH[name]
        val meant = SimilarNames.near(name, KnownOption.OF_ARCH.keys)
        val value = option.value?.text?.trim('"')
        when {
            known == null && meant == null -> report.hint(
                "arch-option", option.name.span, "$name is no option of $ARCHITECTURE", "an observer of the project may read it",
                "there are ${KnownOption.OF_ARCH.keys.joinToString()}",
            )
            known == null -> report.error("arch-option", option.name.span, "$name is no option of $ARCHITECTURE", "it has no effect",
                "did you mean $meant?")
            value == null || !known.accepts(value) -> report.error(
                "arch-option", (option.value ?: option.name).span, "$name of $ARCHITECTURE is ${known.expected}, not ${value ?: "nothing"}",
                "the agent runs without it", "correct the value",
            )
        }
    }

    private fun words(tokens: List<Token>, at: Int, vararg expected: String) =
        expected.indices.all { tokens.getOrNull(at + it)?.text == expected[it] }
}
