package argo.orders

import argo.observing.Order
import argo.observing.Outcome
import argo.observing.ProgramFile
import argo.platform.Plans
import jason.JasonException
import jason.asSemantics.GoalListenerForMetaEvents
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal
import jason.asSyntax.Plan
import jason.asSyntax.PredicateIndicator
import jason.asSyntax.Rule
import jason.bb.BeliefBase
import jason.bb.ChainBBAdapter
import java.util.IdentityHashMap

/**
 * Exchanges the agent's program for [program], which was read from the files of [order], see [Order.Reload]. The agent itself reads only
 * the parts that have changed. If this function throws [OrderRefusedException], the agent is unchanged.
 */
internal fun TransitionSystem.reload(order: Order.Reload, program: ProgramText): Outcome {
    val files = order.files.mapTo(HashSet(order.gone)) { it.address }
    val library = Plans.of(ag)
    val before = library.all.toList()
    program.plans.fileless(order.files.first().address, ag.aslSrc)
    val plans = ExchangedPlans(before, program.plans) { it.sourceFile in files }
    val shortened = program.without(plans.kept)
    val (read, beliefs) = readParts(shortened.files)
    check(read.size == program.plans.size - shortened.without.size) { "Jason reads other plans from parts than from the whole; restart it" }
    read.fileless(order.files.first().address, ag.aslSrc)
    val now = plans.now(shortened.without, read)
    try {
        if (now != before) library.replaceBy(now)
    } catch (refused: JasonException) { // for example, a plan added at run time already has the label
        library.replaceBy(before)
        throw OrderRefusedException(refused.message.orEmpty())
    }
    if (library.hasMetaEvents) addGoalListener(GoalListenerForMetaEvents(this)) // Jason keeps only one of these listeners
    val rules = ExchangedRules(ag.bb.inMemory, beliefs.mapNotNull(::ruleOf)) { it.srcInfo?.srcFile in files }
    return Outcome(null, listOf(plans.told()) + rules.exchange())
}

/**
 * The part of this belief base that is in memory and holds all rules. A database, as in `JDBCPersistentBB`, is left out. A database
 * contains beliefs of earlier runs, may be large or unreachable, and allows no removals during an iteration.
 */
internal val BeliefBase.inMemory: BeliefBase get() = (this as? ChainBBAdapter)?.lastBB ?: this

/** Lets the agent read the program in [files]. Returns the program's plans, and its initial beliefs and rules. */
private fun TransitionSystem.readParts(files: List<ProgramFile>): Pair<List<Plan>, List<Literal>> {
    val beliefs = ArrayList<Literal>()
    val plans = Plans.readInto(ag) {
        try {
            ProgramReading(ag, { within, name -> files.first { it.within == within && it.name == name } }).read(files.first())
        } finally {
            beliefs += ag.initialBels
            ag.initialBels.clear()
            ag.initialGoals.clear()
        }
    }
    return plans to beliefs
}

/**
 * Makes [address] the source file of plans from Jason's patterns. For these plans Jason notes no file, or the agent's `aslSrc`, which is
 * [source].
 */
internal fun List<Plan>.fileless(address: String, source: String) =
    filter { it.sourceFile.isEmpty() || it.sourceFile == source }.forEach { it.sourceFile = address }

/** Returns the rule that Jason makes of [belief]; null if Jason keeps it as a belief. */
private fun ruleOf(belief: Literal): Rule? = when {
    belief is Rule -> belief
    belief.isGround -> null
    else -> Rule(belief, Literal.LTrue)
}?.apply { if (!hasSource()) addAnnot(BeliefBase.TSelf) }

/**
 * The plans of an agent before and after its program is exchanged. A plan that is alike in both programs stays, with its label.
 *
 * @param before all plans of the agent
 * @param drafted the plans of the new program
 * @param isOfProgram returns true for a plan in [before] that came from the program
 */
private class ExchangedPlans(private val before: List<Plan>, private val drafted: List<Plan>, private val isOfProgram: (Plan) -> Boolean) {
    private val left = before.filter(isOfProgram).groupByTo(HashMap(), ::keyOf)
    private val old = before.count(isOfProgram)
    private val like = IdentityHashMap<Plan, Plan>()

    init {
        drafted.forEach { plan -> takeLike(plan)?.let { like[plan] = it } }
    }

    private val isNew = drafted.size - like.size

    /** The plans in [drafted] that the agent already has. */
    val kept: Set<Plan> get() = like.keys

    /**
     * Returns all plans of the agent in their order. The new program's plans take the position of the old program's first plan. [read] are
     * all plans in [drafted] except those in [without].
     */
    fun now(without: Set<Plan>, read: List<Plan>): List<Plan> {
        val others = read.iterator()
        val program = drafted.map { plan -> (if (plan in without) null else others.next()).let { like[plan] ?: checkNotNull(it) } }
        val first = before.takeWhile { !isOfProgram(it) }
        return first + program + before.drop(first.size).filterNot(isOfProgram)
    }

    /** Returns the agent's plan that is like [plan], with the line numbers of [plan]; null if there is none. */
    private fun takeLike(plan: Plan): Plan? {
        val candidates = left[keyOf(plan)] ?: return null
        val found = candidates.indexOfFirst { it.sourceFile == plan.sourceFile && isLike(it, plan) }
        return if (found < 0) null else candidates.removeAt(found)
    }

    private fun isLike(one: Plan, other: Plan): Boolean {
        val comparison = ProgramComparison()
        if (!comparison.isAlike(one, other)) return false
        if (comparison.move()) one.srcInfo = other.srcInfo
        return true
    }

    private fun keyOf(plan: Plan): Any = plan.trigger.let { if (it.literal.isVar) it.type else it.predicateIndicator }

    fun told(): String {
        val gone = left.values.sumOf { it.size }
        val changed = minOf(gone, isNew)
        val parts = listOf(changed to "changed", isNew - changed to "added", gone - changed to "removed").filter { (count, _) -> count > 0 }
        return if (parts.isEmpty()) "none of the $old plans has changed" else
            parts.joinToString { (count, what) -> "${plans(count)} $what" } + "; ${old - gone} are as before"
    }

    private fun plans(count: Int) = if (count == 1) "1 plan" else "$count plans"
}

/** The rules of a program in [beliefs], and the rules [read] from its new text. All rules of a predicate are exchanged together. */
private class ExchangedRules(private val beliefs: BeliefBase, private val read: List<Rule>, private val isOfProgram: (Rule) -> Boolean) {
    /** Exchanges the rules that differ. If any differ, returns a line for a person. */
    fun exchange(): List<String> {
        val before = beliefs.asSequence().filterIsInstance<Rule>().filter(isOfProgram).groupBy { it.predicateIndicator }
        val now = read.groupBy { it.predicateIndicator }
        val different = (before.keys + now.keys).filterNot { isAllAlike(before[it].orEmpty(), now[it].orEmpty()) }
        if (different.isEmpty()) return emptyList()
        remove(different.flatMap { before[it].orEmpty() })
        different.flatMap { now[it].orEmpty() }.forEach { beliefs.add(1, it) }
        return listOf("rules exchanged: ${different.joinToString(transform = PredicateIndicator::toString)}")
    }

    private fun isAllAlike(one: List<Rule>, other: List<Rule>): Boolean {
        val pairs = one.zip(other) { rule, newer -> ProgramComparison().takeIf { it.isAlike(rule, newer) } }
        if (one.size != other.size || null in pairs) return false
        pairs.forEach { it?.move() }
        return true
    }

    private fun remove(rules: List<Rule>) {
        val all = beliefs.iterator()
        while (all.hasNext()) all.next().let { belief -> if (rules.any { it === belief }) all.remove() }
    }
}
