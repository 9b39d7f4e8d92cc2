package argo.filters

/**
 * A rule of a filter. A percept meets the rule if it has the [predicate] and the [arity] and meets all [conditions].
 *
 * @property conditions the conditions. If there are none, every percept of the predicate and arity meets the rule
 * @property arity the required number of arguments; null: any
 * @property rate the rate that holds back percepts that meet the rule; null: no rate
 */
data class Rule(
    val predicate: Predicate,
    val conditions: List<Condition> = emptyList(),
    val arity: Int? = null,
    val rate: Rate? = null,
) {
    constructor(predicate: String, vararg conditions: Condition) : this(Predicate.of(predicate), conditions.toList())

    init {
        require(arity == null || arity >= 0) { "a percept cannot have $arity arguments" }
    }

    /** Returns the rule in words: `distance where argument 0 is not front`. */
    override fun toString(): String {
        val number = arity?.let { if (it == 1) "there is 1 argument" else "there are $it arguments" }
        val parts = listOfNotNull(number) + conditions + listOfNotNull(rate)
        return if (parts.isEmpty()) "$predicate" else parts.joinToString(" and ", "$predicate where ")
    }
}

/**
 * Holds back a percept that comes too soon after the last percept let through, or that differs too little from it.
 *
 * The rate applies to each kind of percept separately. Percepts that differ only in numbers are of one kind: `dist(f,2)` and `dist(f,1)`
 * are of one kind, `dist(b,1)` is of another. A percept is held back while the interval has not ended *and* no number has moved by its
 * deadband. The session delivers a held-back percept at the end of the interval. If there are only deadbands, the session delivers the
 * percept [SETTLING_MS] after it first held back a percept of this kind.
 *
 * Only an [argo.filters.matching.FilterSession] holds percepts back, because only a session knows the time.
 *
 * @property everyMs the interval in milliseconds, in which at most one percept is let through; null: no interval
 * @property deadbands the distances by which a number must move so that its percept is let through at once
 * @throws IllegalArgumentException if there is neither an interval nor a deadband, if an argument has two deadbands, or if the interval
 *     is below 1 ms
 */
data class Rate(val everyMs: Long? = null, val deadbands: Set<Deadband> = emptySet()) {
    init {
        require(everyMs != null || deadbands.isNotEmpty()) { "a rate needs an interval or a deadband" }
        require(deadbands.distinctBy(Deadband::argument).size == deadbands.size) { "an argument has two deadbands" }
        require(everyMs == null || everyMs >= 1) { "an interval of $everyMs ms holds nothing back; expected at least 1" }
    }

    override fun toString(): String = (
        listOfNotNull(everyMs?.let { "the last one was less than $it ms ago" }) + deadbands
        ).joinToString(" and ")

    companion object {
        /** The time in milliseconds after which a percept that only a deadband holds back is delivered. */
        const val SETTLING_MS: Long = 1_000
    }
}

/**
 * The distance by which a number must move so that its percept is let through.
 *
 * @property argument the argument's position, counted from 0; null: each argument that is a number
 * @property width the least distance to the number of the last percept that was let through
 * @throws IllegalArgumentException if [width] is not a finite number above 0, or [argument] is negative
 */
data class Deadband(val argument: Int?, val width: Double) {
    init {
        argument?.let(::requireIndex)
        require(width > 0 && width.isFinite()) { "a deadband of $width means nothing; expected a finite number above 0" }
    }

    override fun toString(): String =
        (if (argument == null) "no number has" else "argument $argument has not") + " moved by ${GroundTerm.Number(width)}"
}
