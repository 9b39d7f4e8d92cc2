package argo.recording.why

import argo.boundary.Boundary
import argo.boundary.Perception
import argo.observing.Order
import argo.recording.Cycle
import argo.recording.KeyFrame
import argo.recording.Place
import argo.recording.agent.fileName
import argo.recording.agent.given
import argo.recording.agent.literalOf
import argo.recording.agent.placeIn
import argo.recording.replay.RecordedAnswers
import argo.recording.replay.ReplayedInputs
import argo.recording.replay.normal
import jason.asSemantics.Event
import jason.asSemantics.IntendedMeans
import jason.asSemantics.Intention
import jason.asSemantics.Option
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.Literal
import jason.asSyntax.LogicalFormula
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.PlanBody.BodyType
import java.util.IdentityHashMap
import java.util.WeakHashMap

/**
 * Follows an agent in its replay. Finds the causes of events, the chosen plans with their conditions, and the beliefs and commands of
 * steps. Passes the agent's [inputs] on unchanged. [taken] is called when the agent has taken an event from the queue, before the agent
 * searches for a plan.
 */
internal class Trace(
    private val inputs: ReplayedInputs,
    private val answers: RecordedAnswers,
    private val clock: RecordingClock,
    private val filters: RecordedFilters = RecordedFilters(emptyMap()),
    private val taken: (Trace, Event) -> Unit = { _, _ -> },
) : Boundary by inputs {
    /** A chosen plan, with the tests that its body has made since the choice. */
    private class Adopted(val plan: PlanCause) {
        val tests = LinkedHashMap<String, Condition>()
    }

    /** A command to a board or to the environment, and the step that issued it. */
    class Issued(val cycle: Cycle, val port: String?, val text: String, val cause: StepCause?)

    val percepts = PerceptOrigins(clock::seconds) { port, text -> filters.explain(port, text)?.toString() }

    val issued = ArrayList<Issued>()

    /** The steps that sent the messages of the last cycle, by the messages' names. */
    var sent: Map<String, StepCause> = emptyMap()
        private set

    /** The plan that the agent chose for the last event of [taken]; null if it has chosen none. */
    var chosen: PlanCause? = null
        private set

    /** The agent's transition system. The agent's first cycle sets it. */
    lateinit var ts: TransitionSystem
        private set

    private val origins = IdentityHashMap<Event, Cause>()
    private val adopted = WeakHashMap<IntendedMeans, Adopted>()
    private var hasForgottenNotes = false
    private val notes = object : LinkedHashMap<String, Cause>() {
        override fun removeEldestEntry(eldest: Map.Entry<String, Cause>) =
            (size > MAX_NOTES).also { hasForgottenNotes = hasForgottenNotes || it }
    }
    private val mail = ArrayList<MessageCause>()
    private var pending: Pair<Option, Adopted>? = null
    private var event: Event? = null
    private var option: Option? = null
    private var selected: Intention? = null
    private var step: StepCause? = null
    private var splitting: Pair<IntendedMeans, Adopted>? = null
    private var isFirst = true
    private var start: KeyFrame? = null
    private var isWatching = false
    private lateinit var conditions: Conditions

    private val cycle get() = inputs.cycle

    /** Begins at the key frame [start]. Earlier causes are not known. */
    fun beginAt(start: KeyFrame) {
        this.start = start
        percepts.beginWith(start.perceived.map(::literalOf))
    }

    override fun cycleStarting(ts: TransitionSystem) {
        this.ts = ts
        if (isFirst) conditions = Conditions(ts.ag, ::originOf, ::goneOf)
        notice { if (isFirst) atStart(it) else UnknownCause(shown(it), "another thread of the project put it there") }
        inputs.cycleStarting(ts)
        notice { UnknownCause(shown(it), "a timer of the agent ended") }
        isFirst = false
        event = ts.c.selectedEvent
        option = ts.c.selectedOption
        selected = ts.c.selectedIntention
        step = null
        cycle.input.mail.mapTo(mail) { MessageCause(it.sender.orEmpty(), it.performative, it.content, clock.seconds(cycle.ns), it.id) }
    }

    override fun orders(live: () -> List<Order>, carryOut: (Order) -> Unit) = inputs.orders(live) { order ->
        carryOut(order)
        val cause = given(order).run { OrderCause(kind, text, clock.seconds(cycle.ns)) }
        notice { cause }
        when (order) {
            is Order.Believe -> believed(order)?.let { note(it, cause) }
            is Order.Resume -> order.beliefs.forEach { note(literalOf(it.removePrefix("+")), cause) }
            else -> Unit
        }
    }

    /** Returns the belief that a person set; null if the agent has refused the order. */
    private fun believed(order: Order.Believe): Literal? = try {
        literalOf(order.literal.trim().removePrefix("-+").removePrefix("+")).capply(Unifier()) as Literal
    } catch (_: IllegalArgumentException) {
        null
    }

    override fun perceive(live: () -> Perception): Perception = inputs.perceive(live).also { perception ->
        perception.percepts?.let { percepts.perceived(it, cycle.input.snapshots, cycle.number, cycle.ns) }
    }

    override fun takeMail(live: () -> Unit) {
        notice { perceptOrigin(it) }
        inputs.takeMail(live)
    }

    override fun ruleApplied() {
        if (isWatching) return // Jason also calls this function when it evaluates a formula for this class
        isWatching = true
        try {
            inputs.ruleApplied()
            watch()
        } finally {
            isWatching = false
        }
    }

    private fun watch() {
        bindPending()
        val c = ts.c
        if (c.selectedEvent !== event) {
            event?.let(origins::remove)
            event = c.selectedEvent
            c.selectedEvent?.let { taken(this, it) }
            chosen = null
        }
        if (c.selectedOption !== option) {
            option = c.selectedOption
            val event = event
            option?.let { chosen -> if (event != null) pending = chosen to inputs.asking { adopt(event, chosen) } }
        }
        if (c.selectedIntention !== selected) {
            selected = c.selectedIntention
            selected?.takeUnless { it.isFinished }?.let { inputs.asking { carryingOut(it.peek()) } }
        }
    }

    /** If an intention has split into the branches of `|&|` or `|||`, assigns the branches to the plan with the operator. */
    private fun adoptSplit() {
        val (means, adopted) = splitting ?: return
        splitting = null
        val split = ts.c.runningIntentionsPlusAtomic.asSequence().filterNot { it.isFinished }.map { it.peek() }
        for (one in split) if (one !in this.adopted && one.plan === means.plan && one.trigger == means.trigger) this.adopted[one] = adopted
    }

    override fun cycleFinished() {
        bindPending()
        adoptSplit()
        notice { event -> step ?: UnknownCause(shown(event), "what added it was not seen") }
        event?.let(origins::remove)
        sent = step?.let { by -> cycle.course.mail.associate { it.id to by } }.orEmpty()
        answers.repeated.flatMap { it.commands }.forEach { issue(it.port, it.text) }
        ts.c.action?.let { issue(null, normal("${it.actionTerm}")) }
        filters.changed(cycle.input.filters)
        inputs.cycleFinished()
    }

    private fun issue(port: String?, text: String) {
        issued += Issued(cycle, port, text, step)
    }

    /**
     * Returns why [plan] is not applicable now, although it is relevant under [un]. The result is the parts of the context up to the first
     * part that fails.
     */
    fun failing(plan: Plan, un: Unifier): List<Condition> =
        plan.context?.let { context -> inputs.asking { conditions.failing(context, un) } }.orEmpty()

    fun isApplicable(plan: Plan, un: Unifier): Boolean =
        plan.context.let { context -> context == null || inputs.asking { conditions.solution(context, un) != null } }

    private fun notice(cause: (Event) -> Cause) {
        for (event in ts.c.eventsPlusAtomic) if (event !in origins) origins[event] = cause(event)
    }

    private fun adopt(event: Event, option: Option): Adopted {
        val intention = event.intention?.takeUnless { it === Intention.EmptyInt || it.isFinished }
        val parent = intention?.peek()?.let(adopted::get)
        val context = option.plan.context?.let { conditions.holding(it, option.unifier) }.orEmpty()
        val above = parent?.let { stepOf(intention.peek(), it) } ?: origins[event] ?: mailOrigin(event)
        val place = placeOf(option.plan)
        val again = (above as? StepCause)?.plan?.takeIf { it.place == place && (intention == null || isTail(intention, option.plan)) }
        val cause = PlanCause(
            place, shown(event), clock.seconds(cycle.ns), cycle.number, context.map { it.within(MAX_CAUSES_OF_CONDITION) },
            (again?.event ?: above).within(MAX_CAUSES), again?.let { it.again + 1 } ?: 0,
        )
        chosen = cause
        return Adopted(cause)
    }

    /** Returns true if [plan] calls itself as its last step. Jason then forgets the earlier call. */
    private fun isTail(intention: Intention, plan: Plan): Boolean =
        intention.peek().let { it.plan === plan && it.currentStep?.bodyNext == null }

    private fun bindPending() {
        val (option, chosen) = pending ?: return
        val c = ts.c
        val candidates = c.runningIntentionsPlusAtomic.asSequence() + listOfNotNull(event?.intention, c.selectedIntention)
        val means = candidates.filterNot { it === Intention.EmptyInt || it.isFinished }.map { it.peek() }
            .find { it.plan === option.plan && it.unif === option.unifier } ?: return
        adopted[means] = chosen
        pending = null
    }

    private fun carryingOut(means: IntendedMeans) {
        val body = means.currentStep?.takeUnless { it.isEmptyBody } ?: return
        val adopted = adopted[means] ?: earlier(means) ?: return
        test(means, body, adopted)
        if ((body.bodyTerm as? InternalActionLiteral)?.functor == FORK) splitting = means to adopted
        step = stepOf(means, adopted)?.also { note(means, body, it) }
    }

    /** Returns the plan of [means]. The agent chose the plan before the replay began, so its cause is not known. */
    private fun earlier(means: IntendedMeans): Adopted? = start?.let { begin ->
        val trigger = means.trigger.let { normal("${it.operator}${it.type}${keyOf(it.literal)}") }
        val cause = UnknownCause(trigger, BEFORE)
        val plan = PlanCause(placeOf(means.plan), trigger, clock.seconds(begin.ns), begin.number, emptyList(), cause, 0)
        Adopted(plan).also { adopted[means] = it }
    }

    private fun stepOf(means: IntendedMeans, adopted: Adopted): StepCause? {
        val body = means.currentStep ?: return null
        val tests = adopted.tests.values.map { it.within(MAX_CAUSES_OF_CONDITION) }
        return StepCause(textOf(body), body.srcInfo?.srcLine, clock.seconds(cycle.ns), adopted.plan, tests)
    }

    private fun test(means: IntendedMeans, body: PlanBody, adopted: Adopted) {
        val term = body.bodyTerm
        val formula = when {
            body.bodyType == BodyType.test || body.bodyType == BodyType.constraint -> term as? LogicalFormula
            term is InternalActionLiteral && term.functor in BRANCHES -> term.getTerm(0) as? LogicalFormula
            else -> null
        } ?: return
        val un = conditions.solution(formula, means.unif)
        val parts = if (un == null) conditions.failing(formula, means.unif) else conditions.holding(formula, un)
        parts.forEach { adopted.tests["${body.srcInfo?.srcLine} ${it.text}"] = it }
    }

    private fun note(means: IntendedMeans, body: PlanBody, step: StepCause) {
        if (body.bodyType !in NOTING) return
        note(body.bodyTerm.capply(means.unif) as? Literal ?: return, step)
    }

    private fun note(belief: Literal, cause: Cause) {
        val key = normal(keyOf(belief))
        notes.remove(key) // keeps the newest note last
        notes[key] = cause
    }

    private fun originOf(belief: Literal): Cause = when {
        belief.hasSource(jason.bb.BeliefBase.APercept) -> percepts.of(belief) ?: UnknownCause(keyOf(belief), "it was perceived before")
        else -> notes[normal(keyOf(belief))] ?: tellOrigin(belief)
            ?: if (hasForgottenNotes) UnknownCause(keyOf(belief), FORGOTTEN) else beginning(belief)
    }

    private fun tellOrigin(belief: Literal): Cause? =
        mail.lastOrNull { it.content == keyOf(belief) } ?: belief.getSources()?.map { "$it" }?.firstNotNullOfOrNull { from ->
            mail.lastOrNull { it.sender == from }
        }

    private fun goneOf(literal: Literal): List<Cause> = listOfNotNull(percepts.lastGone { Unifier().unifies(literal, it) })

    private fun perceptOrigin(event: Event): Cause {
        val literal = event.trigger.literal
        val found = if (event.trigger.isAddition) percepts.of(literal) else percepts.goneOf(literal)
        return found ?: UnknownCause(shown(event), "it came from outside of the agent, but not with a percept")
    }

    private fun mailOrigin(event: Event): Cause {
        val literal = event.trigger.literal
        val sender = if (literal.functor == "kqml_received") "${literal.getTerm(0)}" else literal.sources?.firstOrNull()?.let { "$it" }
        return mail.lastOrNull { it.sender == sender } ?: UnknownCause(shown(event), "what added it was not seen")
    }

    private fun atStart(event: Event) =
        if (start == null) beginning(event.trigger.literal) else UnknownCause(shown(event), BEFORE)

    private fun beginning(literal: Literal): Cause = if (start != null) UnknownCause(keyOf(literal), BEFORE) else
        BeginningCause(keyOf(literal), literal.srcInfo?.srcFile?.let(::fileName), literal.srcInfo?.srcLine?.takeIf { it > 0 })

    val now: Double get() = clock.seconds(cycle.ns)

    /** Returns the cause of [event], which the agent took in this cycle; null if it is not known. */
    fun causeOf(event: Event): Cause? {
        val intention = event.intention?.takeUnless { it === Intention.EmptyInt || it.isFinished }
        return intention?.peek()?.let { means -> adopted[means]?.let { stepOf(means, it) } } ?: origins[event]
    }

    fun shown(event: Event): String =
        event.trigger.let { normal("${it.operator}${it.type}${keyOf(it.literal)}") }

    companion object {
        private const val BEFORE = "that was before the replay begins, in a part that this recording has lost"
        private const val MAX_NOTES = 10_000
        private const val FORGOTTEN = "it was there from the beginning, or plans have noted more than $MAX_NOTES beliefs since it was"
        private const val FORK = ".fork"
        private val BRANCHES = setOf(".if_then_else", ".loop")
        private val NOTING = setOf(
            BodyType.addBel, BodyType.addBelBegin, BodyType.addBelEnd, BodyType.addBelNewFocus, BodyType.delAddBel,
        )

        fun placeOf(plan: Plan): Place =
            placeIn(plan).let { place -> if (place.label?.startsWith("p__") == true) place.copy(label = null) else place }

        fun textOf(body: PlanBody): String = normal("${body.bodyType}${body.bodyTerm}")
    }
}
