package argo.fleet.agents

import argo.fleet.node.Directory
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term

/**
 * The percepts about a fleet that an agent asks for by the option `argo_fleet="computers,agents"`: `computer(scout1,on)` and
 * `agent(a,scout1)`. Only the agent's thread uses this class.
 */
internal class FleetPercepts private constructor(private val kinds: Set<Kind>) {
    private enum class Kind { COMPUTERS, AGENTS }

    private var seen: Directory? = null
    private var environment: Collection<Literal> = emptyList()

    /**
     * Returns all percepts of the agent, those of its environment and those about the fleet. Returns null if nothing has changed.
     *
     * @param news the current percepts of the environment, or null if they are unchanged
     */
    fun perceive(news: Collection<Literal>?, now: Directory): MutableCollection<Literal>? {
        if (news == null && now === seen) return null
        if (news != null) environment = news
        seen = now
        return (environment + of(now)).toMutableList()
    }

    private fun of(directory: Directory): List<Literal> = kinds.flatMap { kind ->
        when (kind) {
            Kind.COMPUTERS -> directory.computers.map { literal("computer", it, if (directory.isMet(it)) "on" else "off") }
            Kind.AGENTS -> directory.agents.map { (agent, computer) -> literal("agent", agent, computer) }
        }
    }

    private fun literal(functor: String, vararg names: String): Literal = ASSyntax.createLiteral(functor, *names.map(::term).toTypedArray())

    private fun term(name: String): Term = if (ATOM.matches(name)) ASSyntax.createAtom(name) else ASSyntax.createString(name)

    companion object {
        const val OPTION = "argo_fleet"

        /** Matches a name that needs no quotes in a program. Host names may contain hyphens, and then need quotes. */
        private val ATOM = Regex("[a-z][A-Za-z0-9_]*")

        /** The allowed values of the option, in words for the user. */
        const val USAGE = "computers and agents, or one of them, as \"computers,agents\""

        /** Returns the percepts for the option value [option], or null for none. If the value is wrong, calls [refuse] with the reason. */
        fun of(option: String?, refuse: (String) -> Unit): FleetPercepts? {
            val words = option?.split(',')?.map { it.trim().trim('"') } ?: return null
            val kinds = words.map { word -> Kind.entries.find { it.name.equals(word, ignoreCase = true) } }
            if (null !in kinds) return FleetPercepts(kinds.filterNotNull().toSet())
            refuse("$OPTION=$option: the value is $USAGE; the agent perceives nothing about the fleet")
            return null
        }
    }
}
