package argo.recording.why

import argo.platform.Plans
import argo.recording.heldBack
import argo.recording.replay.normal
import jason.asSemantics.Event
import jason.asSemantics.Unifier
import jason.asSyntax.BinaryStructure
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.LogExpr
import jason.asSyntax.LogicalFormula
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.StringTerm
import jason.asSyntax.Structure
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import java.util.IdentityHashMap

/**
 * Watches the plans that would issue the command of [question] in an agent's replay. Notes the events for which these plans were relevant,
 * and the reasons why the agent did not choose them. [ruleOf] returns why the filter of a port's board dropped a text.
 */
internal class UnchosenPlans(private val question: Question, private val ruleOf: (port: String, text: String) -> String?) {
    /** The outcome of a plan at the last event for which the plan was relevant. */
    private class Last(
        val event: Event,
        val shown: String,
        val seconds: Double,
        val cause: Cause?,
        val isApplicable: Boolean,
        val conditions: List<Condition>,
        val missed: List<Missed>,
    ) {
        var chosen: PlanCause? = null
    }

    private val last = IdentityHashMap<Plan, Last>()
    private val dropped = LinkedHashMap<String, Missed>()
    private var asked: List<Plan>? = null
    private var open: List<Last> = emptyList()

    fun taken(trace: Trace, event: Event) {
        settle(trace)
        val plans = asked ?: asked(trace).also { asked = it }
        open = plans.mapNotNull { plan ->
            val un = plan.isRelevant(event.trigger, null) ?: return@mapNotNull null
            val isApplicable = trace.isApplicable(plan, un)
            val failing = if (isApplicable) emptyList() else trace.failing(plan, un)
            val missed = failing.lastOrNull()?.let { missedBy(plan.context, trace) }.orEmpty()
            Last(event, trace.shown(event), trace.now, trace.causeOf(event), isApplicable, failing, missed).also { last[plan] = it }
        }
    }

    fun settle(trace: Trace) {
        open.forEach { it.chosen = trace.chosen }
        open = emptyList()
    }

    /** Notes the percepts that the filter has dropped from [frames], the newest frames. */
    fun perceived(frames: Collection<Frame>) {
        for (frame in frames) {
            for (text in heldBack(frame.texts, frame.kept)) dropped[functorOf(text)] = Missed(text, frame)
        }
    }

    fun plans(trace: Trace): List<UnchosenPlan> {
        settle(trace)
        val all = plansOf(trace)
        return all.mapNotNull { plan -> stepOf(plan)?.let { described(trace, plan, it, all, 0) } }
    }

    private fun described(trace: Trace, plan: Plan, step: PlanBody, all: List<Plan>, depth: Int): UnchosenPlan {
        val last = last[plan]
        val place = Trace.placeOf(plan)
        val issuing = trace.issued.filter { question.isAbout(it.text) }.mapNotNull { it.cause?.plan }
        val isIssued = issuing.any { it.place == place && it.seconds == last?.seconds }
        val verdict = when {
            last == null -> Verdict.NO_EVENT
            !last.isApplicable -> Verdict.NOT_APPLICABLE
            last.chosen?.place != place -> Verdict.NOT_CHOSEN
            isIssued -> Verdict.ISSUED
            else -> Verdict.NOT_REACHED
        }
        val trigger = plan.trigger
        val parents = if (verdict != Verdict.NO_EVENT || depth >= MAX_ABOVE || !trigger.isGoal) emptyList() else all - plan
        val above = parents.mapNotNull { parent -> goalStep(parent, trigger)?.let { described(trace, parent, it, all, depth + 1) } }
        val missed = last?.missed ?: if (trigger.isGoal) emptyList() else listOfNotNull(missed(trigger.literal))
        return UnchosenPlan(
            place, normal("$trigger"), plan.context?.let { normal("$it") }, Trace.textOf(step).substringBefore(';'), step.srcInfo?.srcLine,
            last?.shown, last?.seconds, last?.cause, verdict, last?.conditions.orEmpty(),
            last?.chosen?.takeIf { verdict != Verdict.ISSUED && verdict != Verdict.NOT_REACHED }, missed, above,
        )
    }

    private fun asked(trace: Trace): List<Plan> {
        val all = plansOf(trace)
        val found = all.filterTo(ArrayList()) { stepOf(it) != null }
        repeat(MAX_ABOVE) {
            val goals = found.map { it.trigger }.filter { it.isGoal }
            found += all.filter { plan -> plan !in found && goals.any { goalStep(plan, it) != null } }
        }
        return found
    }

    private fun plansOf(trace: Trace) = Plans.of(trace.ts.ag).all.filter { it.sourceFile?.endsWith("kqmlPlans.asl") != true }

    private fun stepOf(plan: Plan): PlanBody? = steps(plan.body).firstOrNull { step ->
        val term = step.bodyTerm
        val command = when {
            term is InternalActionLiteral && term.functor == "argo.act" -> term.getTerm(0)
            step.bodyType == PlanBody.BodyType.action -> term
            else -> null
        }
        command != null && question.isAbout(textOf(command), command)
    }

    private fun textOf(command: Term) = if (command is StringTerm) command.string else "$command"

    private fun Question.isAbout(text: String, command: Term) = isAbout(text) || command.isVar ||
        command is Structure && command.functor == this.text.substringBefore('(') && !command.isGround

    private fun goalStep(plan: Plan, trigger: Trigger): PlanBody? = steps(plan.body).firstOrNull { step ->
        val goal = step.bodyTerm as? Literal
        (step.bodyType == PlanBody.BodyType.achieve || step.bodyType == PlanBody.BodyType.achieveNF) && goal != null &&
            goal.predicateIndicator == trigger.literal.predicateIndicator
    }

    private fun steps(body: PlanBody?): Sequence<PlanBody> = sequence {
        var step = body
        while (step != null && !step.isEmptyBody) {
            yield(step)
            (step.bodyTerm as? Structure)?.let { yieldAll(within(it)) }
            step = step.bodyNext
        }
    }

    private fun within(term: Structure): Sequence<PlanBody> = sequence {
        if (term is ListTerm) return@sequence
        for (argument in term.terms.orEmpty()) if (argument is PlanBody) yieldAll(steps(argument))
    }

    /** Returns the sent percepts that match literals of [context] and that the agent does not believe. */
    private fun missedBy(context: LogicalFormula?, trace: Trace): List<Missed> =
        literals(context).filter { trace.ts.ag.findBel(it, Unifier()) == null }.mapNotNull { missed(it) }

    private fun literals(formula: LogicalFormula?): List<Literal> = when {
        formula is LogExpr && formula.op != LogExpr.LogicalOp.not ->
            literals(formula.lhs as LogicalFormula) + literals(formula.rhs as LogicalFormula)
        formula is InternalActionLiteral || formula is BinaryStructure -> emptyList()
        formula is Literal && formula.isLiteral -> listOf(formula)
        else -> emptyList()
    }

    private fun missed(literal: Literal): Missed? = dropped[literal.functor]?.let { found ->
        val percept = believed(found.text, found.frame.namespace) ?: return null
        val isMeant = Unifier().unifies(literal.copy().apply { clearAnnots() }, percept.copy().apply { clearAnnots() })
        if (isMeant) found.copy(rule = ruleOf(found.frame.port, found.text)) else null
    }

    private fun functorOf(text: String) = text.removePrefix("~").substringBefore('(').substringBefore('[').trim()

    private companion object {
        const val MAX_ABOVE = 3
    }
}
