package argo.hand

import argo.boards.AgentBoards
import argo.filters.FilterException
import argo.filters.FilterNotFoundException
import argo.filters.PerceptionFilter
import argo.observing.Order
import argo.observing.Outcome
import argo.perception.filterOf
import argo.perception.filterPath
import argo.platform.Plans
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal
import jason.util.Config
import java.io.File
import java.io.IOException
import java.nio.file.Path
import java.util.ServiceConfigurationError

/**
 * Reads the program of the agent of [ts] and its filters anew while it runs. Make it when Jason has read the program, before the agent's
 * first cycle. Files are read, and programs tried, on the calling thread; the agent exchanges what has changed between two of its cycles.
 *
 * @param hand takes the orders to the agent
 * @param perceiveThrough has the agent perceive all its boards and its environment through a filter
 */
internal class Reloading(
    private val ts: TransitionSystem,
    private val boards: AgentBoards,
    private val hand: Hand,
    private val perceiveThrough: (PerceptionFilter?) -> Unit,
) {
    /** The program that the agent has: what a newer text is compared with. */
    private class Known(val addresses: Set<String>, val beliefs: Set<String>, val goals: Set<String>)

    private val agent get() = ts.ag

    @Volatile
    private var known: Known = atBeginning()

    @Volatile
    private var paths: List<Path>? = null

    private fun atBeginning(): Known {
        agent.aslSrc?.let { Plans.of(agent).all.fileless(ProgramText.nameOf(it), it) }
        return Known(
            Plans.of(agent).all.mapTo(HashSet()) { it.sourceFile } - KQML_FILE - File(Config.get().kqmlPlansFile).name,
            agent.bb.filterNot { it.isRule }.mapTo(HashSet(), ::shown),
            ts.c.events.mapTo(HashSet()) { shown(it.trigger.literal) },
        )
    }

    /** Returns the files on disk that [reload] reads; empty: the program and its filters are somewhere else, or cannot be read. */
    fun sources(): List<Path> {
        val program = paths ?: try {
            read().paths.also { paths = it }
        } catch (_: OrderRefusedException) {
            emptyList()
        }
        return (program + filters().mapNotNull { filterPath(agent, it.name) }).distinct()
    }

    /**
     * Reads the program and the active filters, and has the agent exchange what has changed. Then calls [done] once: on the calling thread
     * if the program cannot be read, else on the agent's thread.
     *
     * @param takes the parts of the program that the agent also believes or begins if they are new
     */
    fun reload(takes: Set<Offer>, done: (Outcome) -> Unit) {
        val lost = ArrayList<String>()
        val (program, filters) = try {
            read() to filters().associateWith { filter -> anew(filter) ?: filter.also { lost += it.name } }
        } catch (refused: OrderRefusedException) {
            return done(Outcome(refused.message))
        }
        hand.give(Order.Reload(program.files, known.addresses - program.addresses), program) { outcome ->
            if (outcome.refusal != null) done(outcome)
            else done(outcome.copy(told = outcome.told + exchanged(program, filters, takes) + lost.map(::gone)))
        }
    }

    /** Does [reload] on a thread of its own. */
    fun start(takes: Set<Offer>, done: (Outcome) -> Unit) {
        boards.platform.start("argo-${boards.owner}-reloading") { reload(takes, done) }
    }

    private fun read(): ProgramText =
        ProgramText.read(agent.aslSrc?.takeIf { it.isNotEmpty() } ?: throw OrderRefusedException("the agent has no file with a program"))

    private fun filters(): List<PerceptionFilter> =
        (listOf(boards.filter) + boards.current.map { it.filter }).filterNotNull().distinctBy { it.name }

    private fun gone(filter: String) = "the filter $filter is not found any more; the agent keeps it as it was"

    /** Reads the filter that has the name of [filter]; null: it is not found any more. */
    private fun anew(filter: PerceptionFilter): PerceptionFilter? = try {
        filterOf(agent, filter.name)
    } catch (_: FilterNotFoundException) {
        null
    } catch (refused: FilterException) {
        throw OrderRefusedException(refused.message.orEmpty())
    } catch (broken: ServiceConfigurationError) {
        throw OrderRefusedException("a filter provider on the class path cannot be used: ${broken.message}")
    } catch (unreadable: IOException) {
        throw OrderRefusedException("the filter ${filter.name} cannot be read: $unreadable")
    }

    /** Does what belongs to an exchange of the program, on the agent's thread. Returns lines for a person. */
    private fun exchanged(program: ProgramText, filters: Map<PerceptionFilter, PerceptionFilter>, takes: Set<Offer>): List<String> {
        val before = known
        paths = program.paths
        val beliefs = program.beliefs.filter { shown(it) !in before.beliefs && agent.bb.contains(it) == null }
        val goals = program.goals.filter { shown(it) !in before.goals }
        val left = (beliefs.takeUnless { Offer.BELIEFS in takes }.orEmpty() + goals.takeUnless { Offer.GOALS in takes }.orEmpty()).toSet()
        known = Known(program.addresses, shownOf(program.beliefs - left), shownOf(program.goals - left)) // what is left is offered again
        return exchangeFilters(filters.filter { (one, other) -> one != other }) +
            offer(Offer.BELIEFS, beliefs, takes, Order::Believe) + offer(Offer.GOALS, goals, takes, Order::Begin)
    }

    private fun exchangeFilters(filters: Map<PerceptionFilter, PerceptionFilter>): List<String> {
        if (filters.isEmpty()) return emptyList()
        val own = boards.current.mapNotNull { board -> board.chosenFilter?.let { board to it } }
        filters[boards.filter]?.let(perceiveThrough) // and each board, too
        own.forEach { (board, filter) -> boards.perceiveThrough(filters[filter] ?: filter, board) }
        return listOf("filters read anew: ${filters.values.joinToString { it.name }}")
    }

    /** Offers [literals], which are new in the program: tells them, or gives the agent an [order] for each. */
    private fun offer(offer: Offer, literals: List<Literal>, takes: Set<Offer>, order: (String) -> Order): List<String> {
        if (literals.isEmpty()) return emptyList()
        val shown = literals.joinToString(transform = ::shown)
        if (offer !in takes) {
            return listOf("new initial ${offer.word}, not ${offer.taken}: $shown (argo.reload([${offer.word}]) takes them)")
        }
        literals.forEach { hand.give(order(shown(it)), done = {}) }
        return listOf("new initial ${offer.word}, ${offer.taken}: $shown")
    }

    private fun shownOf(literals: List<Literal>) = literals.mapTo(HashSet(), ::shown)

    private fun shown(literal: Literal): String = "${literal.copy().apply { clearAnnots() }}"

    private companion object {
        const val KQML_FILE = "kqmlPlans.asl" // PlanLibrary.KQML_PLANS_FILE, a class that Jason 3.3.0 has elsewhere
    }
}

/**
 * A part of a program that Jason gives an agent only at its beginning. A reload offers new ones.
 *
 * @property word the option of `argo.reload`
 * @property taken what the agent has done with it
 */
internal enum class Offer(val word: String, val taken: String) {
    BELIEFS("beliefs", "believed"),
    GOALS("goals", "begun"),
}
