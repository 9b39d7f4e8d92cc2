package argo.view

import jason.asSemantics.Circumstance.IntentionPlace
import jason.asSemantics.IntendedMeans
import jason.asSemantics.Intention
import jason.asSyntax.Literal
import jason.stdlib.suspend
import kotlinx.serialization.Serializable

/**
 * An intention, and the plans that it consists of.
 *
 * @property state `running`, `waiting` or `suspended`, by the internal action `.suspend`
 * @property waitsFor the step that it waits in; null: it does not wait
 * @property plans the latest first
 * @property more how many plans are left out of [plans]
 */
@Serializable
internal data class IntentionState(
    val id: Int,
    val state: String,
    val waitsFor: String?,
    val plans: List<PlanState>,
    val more: Int,
)

/**
 * A plan of an intention.
 *
 * @property trigger the event that it is for, such as `+!start`
 * @property file where it stands; null: in no file
 * @property line the line of its beginning in [file]
 */
@Serializable
internal data class PlanState(val trigger: String, val file: String?, val line: Int?)

private const val MAX_PLANS = 10
private val WAITING = setOf(IntentionPlace.PendingActions, IntentionPlace.PendingIntentions)

/**
 * [intention] as it is now. For the agent's thread only.
 *
 * @param key what Jason keeps it by while it is pending; null: it is not pending
 */
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
    )
}

/** The step that [means] has come to. */
private fun step(means: IntendedMeans): String? = means.currentStep?.bodyTerm?.capply(means.unif)?.let { shown("$it") }

private fun planState(means: IntendedMeans): PlanState {
    val plan = means.plan
    val trigger = means.trigger ?: plan.trigger
    val goal = (trigger.literal.capply(means.unif) as Literal).copy().apply { clearAnnots() }
    val source = (plan.trigger.literal.srcInfo ?: plan.srcInfo)?.takeIf { it.srcFile != null } // a plan's own may begin at its body
    return PlanState(shown("${trigger.operator}${trigger.type}$goal"), source?.let { fileName(it.srcFile) }, source?.srcLine)
}

private fun fileName(path: String) = shown(path.substringAfterLast('/').substringAfterLast('\\'))
