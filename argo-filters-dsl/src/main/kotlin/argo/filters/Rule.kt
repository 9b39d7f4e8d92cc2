package argo.filters

/**
 * One rule of a filter: percepts of this [predicate] and [arity] that meet all [conditions] meet it.
 *
 * @property conditions if there are none, every percept of the predicate meets the rule
 * @property arity the number of arguments that the percept must have; null: any
 * @property rate the rate by which percepts that meet the rule are held back; null: they are not held back
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

    /** The rule in words: `distance where argument 0 is not front`. */
    override fun toString(): String {
        val number = arity?.let { if (it == 1) "there is 1 argument" else "there are $it arguments" }
        val parts = listOfNotNull(number) + conditions + listOfNotNull(rate)
        return if (parts.isEmpty()) "$predicate" else parts.joinToString(" and ", "$predicate where ")
    }
}

/**
 * Holds percepts back that come too soon or differ too little from the one that was let through last.
 *
 * It counts for each kind of percept: `dist(f,2)` is of the same kind as `dist(f,1)`, as they differ only in numbers; `dist(b,1)` is of
 * another. A percept is held back while the interval has not ended *and* no number has moved as far as its deadband. A percept that is held
 * back is not lost: it is delivered when the interval ends or, if there are only deadbands, [SETTLING_MS] after it was first held back.
 *
 * Only an [argo.filters.matching.FilterSession], which has the time, holds percepts back.
 *
 * @property everyMs the interval in milliseconds in which at most one percept is let through; null: there is no interval
 * @property deadbands the distances by which numbers must move for a percept to be let through at once
 * @throws IllegalArgumentException if there is neither an interval nor a deadband, if an argument has two deadbands, or if the interval is
 * below 1 ms
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
        /** A percept that only a deadband holds back is delivered after this time, in milliseconds. */
        const val SETTLING_MS: Long = 1_000
    }
}

/**
 * The distance by which a number must move for its percept to be let through.
 *
 * @property argument the argument's position, counted from 0; null: each argument that is a number
 * @property width the least distance: a percept is held back if its number is closer to the number that was let through last
 * @throws IllegalArgumentException if [width] is not a finite number above 0, or [argument] is negative
 */
data class Deadband(val argument: Int?, val width: Double) {
    init {
        argument?.let(::requireIndex)
        require(width > 0 && width.isFinite()) { "a deadband of $width holds nothing back; expected a number above 0" }
    }

    override fun toString(): String =
        (if (argument == null) "no number has" else "argument $argument has not") + " moved by ${GroundTerm.Number(width)}"
}
