package argo.recording.why

/** The longest chain of causes from a step to the root of its intention. */
internal const val MAX_CAUSES = 60

/** The longest chain of causes behind a condition. */
internal const val MAX_CAUSES_OF_CONDITION = 8

/** Returns this cause with a [depth][Cause.depth] of at most [levels]. */
internal fun Cause.within(levels: Int): Cause = when {
    depth <= levels -> this
    this is StepCause -> copy(plan = plan.planWithin(levels - 1), tests = tests.map { it.within(levels - 1) })
    this is PlanCause -> planWithin(levels)
    else -> this
}

private fun PlanCause.planWithin(levels: Int): PlanCause = when {
    depth <= levels -> this
    levels <= 1 -> copy(event = UnknownCause(trigger, "further back than is followed"), conditions = conditions.map { it.within(0) })
    else -> copy(event = event.within(levels - 1), conditions = conditions.map { it.within(levels - 1) })
}

/** Returns this condition with causes of a depth of at most [levels]. */
internal fun Condition.within(levels: Int): Condition =
    if (causes.all { it.depth <= levels }) this else copy(causes = if (levels < 1) emptyList() else causes.map { it.within(levels) })
