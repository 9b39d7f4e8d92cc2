package argo.check.rules

import argo.check.project.Mention
import argo.check.project.Project
import argo.check.project.Role
import argo.check.syntax.Token

/** Facts about all programs of [project] together, shared by the checks of all programs. Not safe for use by several threads at once. */
internal class Facts(val project: Project) {
    private val byRole: Map<Role, List<Mention>> = project.programs.values.flatMap { it.mentions.all }.groupBy { it.role }
    private val counts = HashMap<Set<Role>, Map<String, Int>>()

    /** The names of all arguments: programs may make beliefs and goals of arguments. */
    val data: Set<String> = mentions(Role.DATA).map { it.functor }.toSet()

    /** The goals and beliefs that others may send, according to comments. */
    val sentByOthers: Set<String> = project.programs.values.flatMap { it.sentByOthers }.toSet()

    /** The names of goals that the project posts more than once. */
    val postedOften: Set<String> by lazy { often(Role.POSTED).filterValues { it > 1 }.keys }

    /** True if agents of the project get plans from other agents, from strings, or from files that they choose at run time. */
    val hasMadePlans: Boolean = mentions(Role.INTERNAL).any { it.functor in PLAN_MAKERS || it.isTellHow() }

    val isOfJaCaMo: Boolean = project.projectFiles.any { "${it.path}".endsWith(".jcm") }

    /** The names of the agents that run; null: there may be others. */
    val agentNames: Set<String>? by lazy {
        val mayBeMore = isOfJaCaMo || project.masFiles.isEmpty() || project.masFiles.any { it.isDistributed } ||
            mentions(Role.INTERNAL).any { it.functor in AGENT_MAKERS } || project.foreignNames.any(AGENT_MAKERS_IN_JAVA::contains)
        if (mayBeMore) null else project.masFiles.flatMap { mas -> mas.agents.flatMap { it.names } }.toSet()
    }

    /** True if all agents that run are in the project, and the source of their environment too. */
    val isWhole: Boolean by lazy {
        agentNames != null && project.leftOut.isEmpty() && project.masFiles.all { mas -> mas.environment?.let(::isInProject) ?: true }
    }

    /** The arguments of goals and rules that need a value. */
    val inputs: Inputs by lazy {
        val believed = mentions(Role.BELIEVED, Role.TOLD).groupingBy { it.literal.indicator }.eachCount()
        Inputs(project.programs.values.flatMap { it.program.components.flatMap(::clauses) }, believed)
    }

    val arguments: Arguments by lazy { Arguments(project.programs.values) }

    /** Returns the mentions in [roles] by all agents of the project. */
    fun mentions(vararg roles: Role): List<Mention> = roles.flatMap { byRole[it].orEmpty() }

    /** Returns true if a program has a variable in [role]: not all names in this role are known. */
    fun isOpen(role: Role): Boolean = project.programs.values.any { role in it.mentions.open }

    /** Returns how often each name is mentioned in [roles]. */
    fun often(vararg roles: Role): Map<String, Int> =
        counts.getOrPut(roles.toSet()) { mentions(*roles).groupingBy { it.functor }.eachCount() }

    private val times: Map<String, Int> by lazy { byRole.values.flatten().groupingBy { it.functor }.eachCount() }

    /** All names that programs mention, and the names of JaCaMo. */
    val names: Names by lazy { Names(times.keys + Scene.OF_JACAMO) }

    /** Returns how often programs mention [name]. */
    fun times(name: String): Int = times.getOrDefault(name, 0)

    /** Returns true if the source of the class [name] is in the project. */
    private fun isInProject(name: Token): Boolean {
        val short = name.text.substringAfterLast('.')
        return project.javaActions.any { it.substringAfterLast('.') == short }
    }

    private fun Mention.isTellHow() = (functor == ".send" || functor == ".broadcast") &&
        literal.arguments.any { it.toString() == "tellHow/0" || it.toString() == "askHow/0" }

    private companion object {
        val AGENT_MAKERS = setOf(".create_agent", ".clone")
        val PLAN_MAKERS = AGENT_MAKERS + setOf(".add_plan", ".include")

        /** Words of Java and Kotlin sources that make agents. */
        val AGENT_MAKERS_IN_JAVA = setOf("createAgent", "createAg")
    }
}
