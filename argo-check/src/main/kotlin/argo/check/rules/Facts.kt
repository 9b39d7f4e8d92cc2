package argo.check.rules

import argo.check.project.Mention
import argo.check.project.Project
import argo.check.project.Role
import argo.check.syntax.Token
import argo.check.syntax.clauses

/** Facts about all programs of [project], computed once for all checks. Not safe for use by several threads at once. */
internal class Facts(val project: Project) {
    private val byRole: Map<Role, List<Mention>> = project.programs.values.flatMap { it.mentions.all }.groupBy { it.role }
    private val counts = HashMap<Set<Role>, Map<String, Int>>()

    /** The functors of all data arguments. Programs may turn arguments into beliefs and goals. */
    val data: Set<String> = mentions(Role.DATA).map { it.functor }.toSet()

    /** The goals and beliefs that others may send, as comments declare. */
    val sentByOthers: Set<String> = project.programs.values.flatMap { it.sentByOthers }.toSet()

    val postedOften: Set<String> by lazy { often(Role.POSTED).filterValues { it > 1 }.keys }

    /** True if agents receive plans from other agents, from strings, or from files chosen at run time. */
    val hasMadePlans: Boolean = mentions(Role.INTERNAL).any { it.functor in PLAN_MAKERS || it.isTellHow() }

    val isOfJaCaMo: Boolean = project.projectFiles.any { "${it.path}".endsWith(".jcm") }

    /** The names of all agents that run, or null if others may run. */
    val agentNames: Set<String>? by lazy {
        val mayBeMore = isOfJaCaMo || project.masFiles.isEmpty() || project.masFiles.any { it.isDistributed } ||
            mentions(Role.INTERNAL).any { it.functor in AGENT_MAKERS } || project.foreignNames.any(AGENT_MAKERS_IN_JAVA::contains)
        if (mayBeMore) null else project.masFiles.flatMap { mas -> mas.agents.flatMap { it.names } }.toSet()
    }

    /** True if the project contains all agents that run, and the source of their environment. */
    val isWhole: Boolean by lazy {
        agentNames != null && project.leftOut.isEmpty() && project.masFiles.all { mas -> mas.environment?.let(::isInProject) ?: true }
    }

    /** The arguments of goals and rules that need a value. */
    val requiredArguments: RequiredArguments by lazy {
        val believed = mentions(Role.BELIEVED, Role.TOLD).groupingBy { it.literal.indicator }.eachCount()
        RequiredArguments(project.programs.values.flatMap { it.program.components.flatMap(::clauses) }, believed)
    }

    val arguments: Arguments by lazy { Arguments(project.programs.values) }

    fun mentions(vararg roles: Role): List<Mention> = roles.flatMap { byRole[it].orEmpty() }

    /** Returns true if a program has a variable in [role]. The names in this role are then not all known. */
    fun isOpen(role: Role): Boolean = project.programs.values.any { role in it.mentions.open }

    fun often(vararg roles: Role): Map<String, Int> =
        counts.getOrPut(roles.toSet()) { mentions(*roles).groupingBy { it.functor }.eachCount() }

    private val times: Map<String, Int> by lazy { byRole.values.flatten().groupingBy { it.functor }.eachCount() }

    /** All names that programs mention, and the names of JaCaMo. */
    val names: SimilarNames by lazy { SimilarNames(times.keys + Scene.OF_JACAMO) }

    fun times(name: String): Int = times.getOrDefault(name, 0)

    /** Returns true if the project contains the source of the class [name]. */
    private fun isInProject(name: Token): Boolean {
        val short = name.text.substringAfterLast('.')
        return project.javaActions.any { it.substringAfterLast('.') == short }
    }

    private fun Mention.isTellHow() = (functor == ".send" || functor == ".broadcast") &&
        literal.arguments.any { it.toString() == "tellHow/0" || it.toString() == "askHow/0" }

    private companion object {
        val AGENT_MAKERS = setOf(".create_agent", ".clone")
        val PLAN_MAKERS = AGENT_MAKERS + setOf(".add_plan", ".include")

        /** Words by which Java and Kotlin sources create agents. */
        val AGENT_MAKERS_IN_JAVA = setOf("createAgent", "createAg")
    }
}
