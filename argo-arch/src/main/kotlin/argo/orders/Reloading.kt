package argo.orders

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
import java.util.concurrent.ConcurrentHashMap

/**
 * Reads the program and the filters of the agent of [ts] again while the agent runs. Construct this object after Jason has read the
 * program, before the agent's first cycle. The calling thread reads files. The agent exchanges the changed parts between two cycles.
 *
 * @param orders gives orders to the agent
 * @param perceiveThrough sets the filter for all the agent's boards and its environment
 */
internal class Reloading(
    private val ts: TransitionSystem,
    private val boards: AgentBoards,
    private val orders: Orders,
    private val perceiveThrough: (PerceptionFilter?) -> Unit,
) {
    /** The addresses, beliefs and goals of the agent's current program, for comparison with a newer text. */
    private class Known(val addresses: Set<String>, val stated: Map<Offer, Set<String>>)

    private val agent get() = ts.ag

    @Volatile
    private var known: Known = atBeginning()

    @Volatile
    private var paths: List<Path>? = null

    /** The paths of the files that the last reading has read or missed, even if the program was refused. */
    @Volatile
    private var looked: List<Path> = emptyList()

    /** The files in which each filter was found, by its name. A file that is gone stays watched, so its return is noticed. */
    private val filterFiles = ConcurrentHashMap<String, Set<Path>>()

    private fun atBeginning(): Known {
        agent.aslSrc?.let { Plans.of(agent).all.fileless(ProgramSource.nameOf(it), it) }
        val (rules, beliefs) = agent.bb.inMemory.partition { it.isRule }
        return Known(
            Plans.of(agent).all.mapTo(HashSet()) { it.sourceFile } + rules.mapNotNull { it.srcInfo?.srcFile } -
                KQML_FILE - File(Config.get().kqmlPlansFile).name,
            mapOf(
                Offer.BELIEFS to shownOf(beliefs),
                Offer.GOALS to shownOf(ts.c.events.map { it.trigger.literal }),
            ),
        )
    }

    /**
     * Returns the files on disk that [reload] reads. After a refusal, also returns the files that the refused reading has read or missed.
     * Also returns the files in which an active filter was found earlier.
     */
    fun sources(): List<Path> {
        val program = paths ?: try {
            read().paths.also { paths = it }
        } catch (_: OrderRefusedException) {
            emptyList()
        }
        return (program + looked + filters().flatMap { filesOf(it.name) }).distinct()
    }

    private fun filesOf(filter: String): Set<Path> =
        filterFiles.merge(filter, setOfNotNull(filterPath(agent, filter)), Set<Path>::plus).orEmpty()

    /**
     * Reads the program and the active filters. The agent then exchanges the changed parts. [done] is called once at the end. If anything
     * cannot be read, the calling thread calls it, else the agent's thread.
     *
     * @param takes the kinds of literals, beliefs or goals, that the agent also adds if they are new in the program
     */
    fun reload(takes: Set<Offer>, done: (Outcome) -> Unit) {
        val lost = ArrayList<String>()
        val (program, filters) = try {
            read() to filters().associateWith { filter -> anew(filter) ?: filter.also { lost += it.name } }
        } catch (refused: OrderRefusedException) {
            return done(Outcome(refused.message))
        }
        val order = Order.Reload(program.files, known.addresses - program.addresses)
        orders.give(order, program) { outcome ->
            if (outcome.refusal != null) return@give done(outcome)
            done(orders.attempt(order) { outcome.copy(told = outcome.told + exchanged(program, filters, takes) + lost.map(::gone)) })
        }
    }

    fun start(takes: Set<Offer>, done: (Outcome) -> Unit) {
        boards.platform.start("argo-${boards.owner}-reloading") { reload(takes, done) }
    }

    private fun read(): ProgramText {
        val address = agent.aslSrc?.takeIf { it.isNotEmpty() } ?: throw OrderRefusedException("the agent has no file with a program")
        val looking = ArrayList<Path>()
        try {
            return ProgramText.read(address, looking::add)
        } finally {
            looked = looking
        }
    }

    private fun filters(): List<PerceptionFilter> =
        (listOf(boards.filter) + boards.current.map { it.filter }).filterNotNull().distinctBy { it.name }

    private fun gone(filter: String) = "the filter $filter is not found any more; the agent keeps it as it was"

    /** Reads the filter that has the name of [filter] again; null if it is no longer found. */
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

    /** Completes an exchange, on the agent's thread. Exchanges filters, and adds or reports new literals. Returns the report. */
    private fun exchanged(program: ProgramText, filters: Map<PerceptionFilter, PerceptionFilter>, takes: Set<Offer>): List<String> {
        paths = program.paths
        val new = Offer.entries.associateWith { offer -> offer.of(program).filter { isNew(offer, it) } }
        val left = new - takes
        known = Known(program.addresses, Offer.entries.associateWith { shownOf(it.of(program)) - shownOf(left[it].orEmpty()) })
        val lines = new.filterValues { it.isNotEmpty() }.map { (offer, literals) ->
            if (offer in takes) take(offer, literals) else offered(offer, literals)
        }
        return exchangeFilters(filters.filter { (one, other) -> one != other }) + lines
    }

    private fun isNew(offer: Offer, literal: Literal) = shown(literal) !in known.stated.getValue(offer) &&
        !(offer == Offer.BELIEFS && agent.bb.contains(literal)?.let(literal::hasSubsetAnnot) ?: false)

    private fun exchangeFilters(filters: Map<PerceptionFilter, PerceptionFilter>): List<String> {
        if (filters.isEmpty()) return emptyList()
        val own = boards.current.filter { it.hasOwnFilter }.map { it to it.filter }
        filters[boards.filter]?.let(perceiveThrough) // also sets the filter of each board
        own.forEach { (board, filter) -> boards.perceiveThrough(filters[filter] ?: filter, board) }
        return listOf("filters read anew: ${filters.values.joinToString { it.name }}")
    }

    /** Returns the report on [literals], which are new in the program. They stay new in later reports until the agent adds them. */
    private fun offered(offer: Offer, literals: List<Literal>) =
        "new initial ${offer.word}, not ${offer.taken}: ${literals.joinToString(transform = ::shown)} " +
            "(argo.reload([${offer.word}]) takes them)"

    /** Makes the agent believe or begin [literals] in its next cycle. Literals that the agent refuses stay new. */
    private fun take(offer: Offer, literals: List<Literal>): String {
        literals.forEach { literal ->
            orders.give(offer.order("$literal")) { outcome -> outcome.refusal?.let { refused(offer, literal, it) } }
        }
        return "new initial ${offer.word}, taken: ${literals.joinToString(transform = ::shown)}"
    }

    private fun refused(offer: Offer, literal: Literal, why: String) {
        boards.log.warning("of the new initial ${offer.word}, ${shown(literal)} is not ${offer.taken}: $why")
        known = Known(known.addresses, known.stated + (offer to known.stated.getValue(offer) - shown(literal)))
    }

    private fun shownOf(literals: Iterable<Literal>) = literals.mapTo(HashSet(), ::shown)

    private fun shown(literal: Literal): String = "${literal.copy().apply { delSources() }}"

    private companion object {
        const val KQML_FILE = "kqmlPlans.asl" // PlanLibrary.KQML_PLANS_FILE; Jason 3.3.0 has this class in another package
    }
}

/**
 * The kinds of literals that an agent normally gets from its program only when it starts. A reload can add new literals of these kinds.
 *
 * @property word the word for this kind in the argument of `argo.reload`
 * @property taken a participle for messages: what the agent has done with a literal of this kind
 * @property of returns the literals of this kind in a program
 * @property order makes the order by which an agent adds a literal of this kind
 */
internal enum class Offer(val word: String, val taken: String, val of: (ProgramText) -> List<Literal>, val order: (String) -> Order) {
    BELIEFS("beliefs", "believed", ProgramText::beliefs, Order::Believe),
    GOALS("goals", "begun", ProgramText::goals, Order::Begin),
}
