package argo.fleet.node

/**
 * The agents and services of a computer. Immutable.
 *
 * @property unable the agents that outlive their computers and that this computer cannot start
 */
internal data class Roster(
    val agents: Set<String> = emptySet(), val offers: Set<Offer> = emptySet(), val unable: Set<String> = emptySet(),
) {
    /** A number that is equal on all computers for equal rosters. Texts and sets define their hash codes. */
    val digest: Int get() = hashCode()

    fun with(news: RosterNews): Roster {
        val old = if (news.isWhole) Roster() else this
        return Roster(old.agents - news.gone + news.came, old.offers - news.withdrawn + news.offered, old.unable + news.unable - news.able)
    }
}

/** The place of an agent. */
internal sealed interface Place {
    data object Here : Place

    /** On another computer that is in touch. */
    data class There(val computer: String) : Place

    /** Expected on one of [computers]. Each of these computers is lost, has not reported its agents, or does not run this agent. */
    data class Off(val computers: List<String>) : Place

    data object Unknown : Place
}

/**
 * The agents and services of each computer in a fleet, as known to this computer. Immutable.
 *
 * @property inTouch the computers in touch, including this one
 * @property planned the computers that may run each agent of the project
 * @param rosters the last known roster of each computer, even of a lost one
 */
internal data class Directory(
    val here: String,
    val inTouch: Set<String> = setOf(here),
    private val rosters: Map<String, Roster> = emptyMap(),
    val planned: Map<String, List<String>> = emptyMap(),
    private val hosts: Set<String> = emptySet(),
) {
    private val owners: Map<String, String> by lazy {
        inTouch.sortedDescending().minus(here).plus(here).flatMap { computer -> roster(computer).agents.map { it to computer } }.toMap()
    }

    /** The names of all agents on computers in touch. */
    val names: Set<String> get() = owners.keys

    /** The computers in touch, by the names of their agents. */
    val agents: Map<String, String> get() = owners

    /** The sorted agents of each computer in touch. Computers without agents are left out. */
    val agentsOf: Map<String, List<String>> by lazy {
        owners.entries.groupBy({ it.value }, { it.key }).mapValues { (_, names) -> names.sorted() }
    }

    /** The known computers of the fleet, in touch or lost. */
    val computers: Set<String> get() = (hosts + rosters.keys + inTouch).toSortedSet()

    /** The services of all agents on computers in touch. */
    val offers: Set<Offer> by lazy { inTouch.flatMap { roster(it).offers }.toSet() }

    fun roster(computer: String): Roster = rosters[computer] ?: Roster()

    /** Returns true if [computer] is in touch and has reported its agents. */
    fun isMet(computer: String): Boolean = computer in inTouch && (computer == here || computer in rosters)

    /** The [Roster.digest] of each computer for which [isMet] is true. */
    val digests: Map<String, Int> get() = inTouch.filter(::isMet).associateWith { roster(it).digest }

    fun runs(agent: String, computer: String): Boolean = isMet(computer) && agent in roster(computer).agents

    /** Returns the place of [agent]. If several computers run the agent, this computer comes first, and then the first by name. */
    fun find(agent: String): Place {
        val owner = owners[agent]
        if (owner != null) return if (owner == here) Place.Here else Place.There(owner)
        val lost = rosters.filter { (_, roster) -> agent in roster.agents }.keys
        val computers = (expected(agent) + lost).distinct()
        return if (computers.isEmpty()) Place.Unknown else Place.Off(computers)
    }

    /** Returns the computers that the project names for [agent]. Empty if the only one is known not to run it. */
    private fun expected(agent: String): List<String> {
        val computers = planned[agent].orEmpty()
        val hasEnded = computers.size == 1 && isMet(computers.single())
        return if (hasEnded) emptyList() else computers
    }

    fun with(computer: String, news: RosterNews): Directory = copy(rosters = rosters + (computer to roster(computer).with(news)))

    /** Forgets the rosters of [computers]. Call this function when their programs have restarted. */
    fun without(computers: List<String>): Directory = copy(rosters = rosters - computers.toSet())

    fun with(inTouch: Set<String>): Directory = copy(inTouch = inTouch)
}
