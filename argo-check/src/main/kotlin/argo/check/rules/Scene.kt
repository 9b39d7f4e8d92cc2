package argo.check.rules

import argo.check.project.AgentProgram
import argo.check.project.MasAgent
import argo.check.project.Mention
import argo.check.project.Parts
import argo.check.project.Project
import argo.check.project.Role
import argo.filters.matching.OWN_BELIEFS

/** A program in its project, with the names that its agents may know and their roles. */
internal class Scene(val facts: Facts, val program: AgentProgram) {
    val project: Project = facts.project
    private val path = program.path.toAbsolutePath().normalize()
    private val parts: Parts = project.partsOf(path)

    val agents: List<MasAgent> = project.agentsOf(path)

    private val byRole: Map<Role, List<Mention>> =
        (parts.programs.flatMap { it.mentions.all } + agents.flatMap { it.initial }).groupBy { it.role }
    private val openRoles: Set<Role> = parts.programs.flatMap { it.mentions.open }.toSet()
    private val unread: Set<String> = parts.programs.flatMap { it.unread }.toSet()

    /** Returns the mentions in [roles] in the programs of this agent, and in messages of all agents. */
    fun mentions(vararg roles: Role): List<Mention> = roles.flatMap { if (it in SENT) facts.mentions(it) else byRole[it].orEmpty() }

    /** The beliefs that JaCaMo adds, or an empty set outside JaCaMo. */
    val namesOfJaCaMo: Set<String> get() = if (facts.isOfJaCaMo) OF_JACAMO else emptySet()

    /** True if a project file starts agents with this program. All their programs are then known. */
    val isAgent: Boolean get() = agents.isNotEmpty()

    fun isOpen(vararg roles: Role): Boolean = roles.any(openRoles::contains)

    /** True if the agent may get plans from missing files, messages, strings or directives. */
    val hasUnknownPlans: Boolean = parts.isOpen || facts.hasMadePlans || parts.programs.any { it.hasPatterns }

    /** True if the project's texts contain everything that posts goals, adds beliefs or reads beliefs of this agent. */
    val isClosed: Boolean by lazy {
        isAgent && !hasUnknownPlans && facts.isWhole && parts.programs.all { it.program.errors.isEmpty() } &&
            agents.none { agent -> agent.hasOwnClass || agent.architectures.any { it.text != MasAgent.ARCHITECTURE } }
    }

    /** Returns true if the name may occur outside known roles: as data that becomes a formula, or in another language. */
    fun isKnownElsewhere(mention: Mention): Boolean =
        mention.functor in facts.data || mention.functor in OF_JACAMO || isNamedOutside(mention)

    fun isSingle(mention: Mention): Boolean = facts.times(mention.functor) == 1 && !isNamedOutside(mention)

    /** Returns true if the name occurs in unread text or another language, if others send it, or if Jason or ARGO uses it. */
    private fun isNamedOutside(mention: Mention): Boolean = mention.functor in unread || mention.functor in project.foreignNames ||
        isSentByOthers(mention) || mention.functor in OF_JASON || mention.functor in OF_ARGO

    fun isSentByOthers(mention: Mention): Boolean =
        mention.functor in facts.sentByOthers || mention.literal.indicator in facts.sentByOthers

    companion object {
        private val SENT = setOf(Role.SENT_GOAL, Role.TOLD, Role.ASKED)

        /**
         * The beliefs that ARGO adds: beliefs about boards, and the belief of an agent that continues its last run. Filters do not drop
         * these beliefs.
         */
        val OF_ARGO = OWN_BELIEFS.keys.map { it.substringBefore('/') }.toSet() + "resumed"

        /** Events, goals and beliefs of Jason itself. */
        private val OF_JASON =
            setOf("kqml_received", "provider", "jag_sleeping", "jag_awaking", "jag_shutting_down", "source", "true", "false")

        /** Beliefs of JaCaMo's organisations and workspaces. */
        val OF_JACAMO = setOf(
            "play", "responsible", "commitment", "group", "scheme", "schemes", "goalState", "goalArgument", "specification", "obligation",
            "permission", "focused", "focusing", "joined", "joinedWsp", "artifact", "workspace", "formationStatus", "destroyed",
            "parentGroup", "subgroup",
        )
    }
}
