package argo.check.rules

import argo.check.project.AgentProgram
import argo.check.project.MasAgent
import argo.check.project.Mention
import argo.check.project.Parts
import argo.check.project.Project
import argo.check.project.Role
import argo.filters.matching.OWN_BELIEFS

/** A program in its project: the names that exist for its agents, with their roles. */
internal class Scene(val facts: Facts, val program: AgentProgram) {
    val project: Project = facts.project
    private val path = program.path.toAbsolutePath().normalize()
    private val parts: Parts = project.partsOf(path)

    val agents: List<MasAgent> = project.agentsOf(path)

    private val byRole: Map<Role, List<Mention>> =
        (parts.programs.flatMap { it.mentions.all } + agents.flatMap { it.initial }).groupBy { it.role }
    private val openRoles: Set<Role> = parts.programs.flatMap { it.mentions.open }.toSet()
    private val unread: Set<String> = parts.programs.flatMap { it.unread }.toSet()

    /** Returns the mentions in [roles] by this agent, and those in messages of the project's agents. */
    fun mentions(vararg roles: Role): List<Mention> = roles.flatMap { if (it in SENT) facts.mentions(it) else byRole[it].orEmpty() }

    /** The beliefs that JaCaMo adds; empty in other projects. */
    val namesOfJaCaMo: Set<String> get() = if (facts.isOfJaCaMo) OF_JACAMO else emptySet()

    /** True if a project file runs this program, so that all parts of its agents are known. */
    val isAgent: Boolean get() = agents.isNotEmpty()

    fun isOpen(vararg roles: Role): Boolean = roles.any(openRoles::contains)

    /** True if plans may come from missing files, messages or strings. */
    val hasUnknownPlans: Boolean = parts.isOpen || facts.hasMadePlans || parts.programs.any { it.hasPatterns }

    /** True if the project's texts contain everything that posts goals, adds beliefs or reads beliefs for this agent. */
    val isClosed: Boolean by lazy {
        isAgent && !hasUnknownPlans && facts.isWhole && parts.programs.all { it.program.errors.isEmpty() } &&
            agents.none { agent -> agent.hasOwnClass || agent.architectures.any { it.text != MasAgent.ARCHITECTURE } }
    }

    /** True if a name may have a meaning outside of the programs: data may become formulas, and other languages may add beliefs. */
    fun isKnownElsewhere(mention: Mention): Boolean =
        mention.functor in facts.data || mention.functor in OF_JACAMO || isNamedOutside(mention)

    /** Returns true if the name is mentioned once in all texts of the project together. */
    fun isSingle(mention: Mention): Boolean = facts.times(mention.functor) == 1 && !isNamedOutside(mention)

    /** Returns true if the name stands in unread text or in another language, others send it, or it has a meaning to Jason or ARGO. */
    private fun isNamedOutside(mention: Mention): Boolean = mention.functor in unread || mention.functor in project.foreignNames ||
        isSentByOthers(mention) || mention.functor in OF_JASON || mention.functor in OF_ARGO

    fun isSentByOthers(mention: Mention): Boolean =
        mention.functor in facts.sentByOthers || mention.literal.indicator in facts.sentByOthers

    companion object {
        private val SENT = setOf(Role.SENT_GOAL, Role.TOLD, Role.ASKED)

        /**
         * The beliefs that ARGO itself adds: beliefs about boards, and the belief that the agent goes on from its last run. No filter drops
         * them.
         */
        val OF_ARGO = OWN_BELIEFS.keys.map { it.substringBefore('/') }.toSet() + "resumed"

        /** Events, goals and beliefs that Jason makes. */
        private val OF_JASON =
            setOf("kqml_received", "provider", "jag_sleeping", "jag_awaking", "jag_shutting_down", "source", "true", "false")

        /** Beliefs of the organisations and workspaces of JaCaMo. */
        val OF_JACAMO = setOf(
            "play", "responsible", "commitment", "group", "scheme", "schemes", "goalState", "goalArgument", "specification", "obligation",
            "permission", "focused", "focusing", "joined", "joinedWsp", "artifact", "workspace", "formationStatus", "destroyed",
            "parentGroup", "subgroup",
        )
    }
}
