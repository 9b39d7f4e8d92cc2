package argo.view

import jason.asSemantics.Circumstance.IntentionPlace
import jason.asSemantics.IntendedMeans
import jason.asSemantics.Intention
import jason.asSyntax.Literal
import jason.asSyntax.Trigger
import jason.asSyntax.Trigger.TEType
import jason.stdlib.suspend
import kotlinx.serialization.Serializable

/**
 * An intention and its plans.
 *
 * @property state `running`, `waiting`, or `suspended` (by the internal action `.suspend`)
 * @property waitsFor the step in which the intention waits; null if it does not wait
 * @property plans the plans of the intention, the latest first
 * @property more the number of plans left out of [plans]
 * @property goal the goal with which the intention began, without annotations; null if it has no goal
 */
@Serializable
internal data class IntentionState(
    val id: Int,
    val state: String,
    val waitsFor: String?,
    val plans: List<PlanState>,
    val more: Int,
    val goal: String?,
)

/**
 * A plan of an intention.
 *
 * @property trigger the triggering event, such as `+!start`
 * @property file the plan's file; null if there is none
 * @property line the plan's first line in [file]
 */
@Serializable
internal data class PlanState(val trigger: String, val file: String?, val line: Int?)

private const val MAX_PLANS = 10
private val WAITING = setOf(IntentionPlace.PendingActions, IntentionPlace.PendingIntentions)

/** Returns the current state of [intention]. [key] is Jason's key of a pending intention, else null. For the agent's thread only. */
internal fun intentionState(intention: Intention, key: String?): IntentionState {
    val means = intention.toList()
    val isSuspended = key?.startsWith(suspend.SUSPENDED_INT) == true
    val isWaiting = !isSuspended && (key != null || intention.place in WAITING)
    return IntentionState(
        id = intention.id,
        state = if (isSuspended) "suspended" else if (isWaiting) "waiting" else "running",
        waitsFor = if (isWaiting) means.firstOrNull()?.let(::step) else null,
        plans = means.take(MAX_PLANS).map(::planState),
        more = maxOf(0, means.size - MAX_PLANS),
        goal = means.lastOrNull { triggerOf(it).run { isAddition && type == TEType.achieve } }?.let { "${goal(it)}" },
    )
}

private fun triggerOf(means: IntendedMeans): Trigger = means.trigger ?: means.plan.trigger

private fun goal(means: IntendedMeans): Literal =
    (triggerOf(means).literal.capply(means.unif) as Literal).copy().apply { clearAnnots() }

private fun step(means: IntendedMeans): String? = means.currentStep?.bodyTerm?.capply(means.unif)?.let { shown("$it") }

private fun planState(means: IntendedMeans): PlanState {
    val plan = means.plan
    val trigger = triggerOf(means)
    val source = (plan.trigger.literal.srcInfo ?: plan.srcInfo)?.takeIf { it.srcFile != null } // the plan's source may be that of its body
    return PlanState(shown("${trigger.operator}${trigger.type}${goal(means)}"), source?.let { fileName(it.srcFile) }, source?.srcLine)
}

private fun fileName(path: String) = shown(path.substringAfterLast('/').substringAfterLast('\\'))
