package argo.check.rules

import argo.check.project.AgentProgram
import argo.check.project.MasAgent
import argo.check.project.Mention
import argo.check.project.Parts
import argo.check.project.Project
import argo.check.project.Role

/** A program in its project: the names that exist for its agents, with their roles. */
internal class Scene(val project: Project, val program: AgentProgram) {
    private val parts: Parts = project.partsOf(program.path.toAbsolutePath().normalize())

    val agents: List<MasAgent> = project.agentsOf(program.path.toAbsolutePath().normalize())

    private val ownMentions: List<Mention> = parts.programs.flatMap { it.mentions.all } + agents.flatMap { it.initial }
    private val sentMentions: List<Mention> = project.programs.values.flatMap { it.mentions.all }.filter { it.role in SENT }
    private val byRole: Map<Role, List<Mention>> = ownMentions.groupBy { it.role }
    private val sent: Map<Role, List<Mention>> = sentMentions.groupBy { it.role }
    private val openRoles: Set<Role> = parts.programs.flatMap { it.mentions.open }.toSet()
    private val everywhere: Set<String> by lazy { project.programs.values.flatMap { it.mentions[Role.DATA] }.map { it.functor }.toSet() }
    private val unread: Set<String> = parts.programs.flatMap { it.unread }.toSet()
    private val sentByOthers: Set<String> = project.programs.values.flatMap { it.sentByOthers }.toSet()

    /** Returns the mentions in [roles] by this agent, and those in messages of the project's agents. */
    fun mentions(vararg roles: Role): List<Mention> =
        roles.flatMap { byRole[it].orEmpty() + if (it in SENT) sent[it].orEmpty() else emptyList() }

    fun everyMention(vararg roles: Role): List<Mention> =
        project.programs.values.flatMap { program -> roles.flatMap { program.mentions[it] } }

    val postedOften: Set<String> by lazy { everyMention(Role.POSTED).groupingBy { it.functor }.eachCount().filter { it.value > 1 }.keys }

    /** The beliefs that JaCaMo adds; empty in other projects. */
    val namesOfJaCaMo: Set<String> = if (project.projectFiles.any { "${it.path}".endsWith(".jcm") }) OF_JACAMO else emptySet()

    /** True if a project file runs this program, so that all parts of its agents are known. */
    val isAgent: Boolean get() = agents.isNotEmpty()

    fun isOpen(vararg roles: Role): Boolean = roles.any(openRoles::contains)

    /** True if plans may come from missing files, messages or strings. */
    val hasUnknownPlans: Boolean = parts.isOpen || parts.programs.any { it.hasPatterns } ||
        project.programs.values.any { all -> all.mentions[Role.INTERNAL].any { it.functor in PLAN_MAKERS || it.isTellHow() } }

    /** True if a name may have a meaning outside of the programs: data may become formulas, and other languages may add beliefs. */
    fun isKnownElsewhere(mention: Mention): Boolean =
        mention.functor in everywhere || mention.functor in unread || mention.functor in project.foreignNames || isSentByOthers(mention) ||
            mention.functor in OF_JASON || mention.functor in OF_ARGO || mention.functor in OF_JACAMO

    fun isSentByOthers(mention: Mention): Boolean = mention.functor in sentByOthers || mention.literal.indicator in sentByOthers

    private fun Mention.isTellHow() = (functor == ".send" || functor == ".broadcast") &&
        literal.arguments.any { it.toString() == "tellHow/0" || it.toString() == "askHow/0" }

    companion object {
        private val SENT = setOf(Role.SENT_GOAL, Role.TOLD, Role.ASKED)
        private val PLAN_MAKERS = setOf(".add_plan", ".include", ".create_agent", ".clone")

        /** The beliefs that ARGO itself adds. No filter drops them. */
        val OF_ARGO = setOf("port", "stale", "reflex")
        private val OF_JASON = setOf("kqml_received", "jag_sleeping", "jag_awaking", "jag_shutting_down", "source", "true", "false")
        private val OF_JACAMO = setOf(
            "play", "responsible", "commitment", "group", "scheme", "schemes", "goalState", "goalArgument", "specification", "obligation",
            "permission", "focused", "focusing", "joined", "joinedWsp", "artifact", "workspace", "formationStatus", "destroyed",
            "parentGroup", "subgroup",
        )
    }
}
