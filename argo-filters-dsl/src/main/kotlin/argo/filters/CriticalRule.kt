package argo.filters

/**
 * A rule for urgent percepts. The filter keeps urgent percepts even if other rules drop them, and never holds them back. An agent
 * perceives urgent percepts before other waiting percepts. A critical rule drops nothing. [argo.filters.matching.PerceptMatcher] decides
 * whether a percept meets the rule.
 *
 * @property rule the rule that the percepts meet; it has no rate
 * @property reflex the command that ARGO sends for an urgent percept before the agent reasons; null: no command. A reflex has 1 to
 *     [MAX_REFLEX_LENGTH] characters up to U+00FF. A reflex must not contain control characters, blanks at its ends, or `fffe` before two
 *     hexadecimal digits. A reflex must not be the request `getPercepts`, with or without arguments.
 * @property smoothed true: the rule tests the percept that a [SmoothingRule] selects; false: the rule tests the received percept, without
 *     delay
 * @throws IllegalArgumentException if [rule] has a rate, or [reflex] cannot be sent
 */
data class CriticalRule(val rule: Rule, val reflex: String? = null, val smoothed: Boolean = false) {
    init {
        require(rule.rate == null) {
            "a critical percept is never held back, so its rule on ${rule.predicate} has neither everyMs nor a deadband"
        }
        reflex?.let(::requireSendable)
    }

    /** Returns the rule in words: `dist where argument 1 is less than 15, with the reflex stop`. */
    override fun toString(): String = "$rule" + (if (smoothed) ", smoothed" else "") + reflex?.let { ", with the reflex $it" }.orEmpty()

    companion object {
        const val MAX_REFLEX_LENGTH: Int = 255

        private val FRAME_HEADER = Regex("fffe\\p{XDigit}{2}")
        private val REQUEST = Regex("getPercepts(\\(.*)?")

        internal fun requireSendable(reflex: String) {
            require(reflex.isNotBlank() && reflex == reflex.trim()) {
                "the reflex '$reflex' is empty or begins or ends with a blank; expected a command such as stop or speed(0)"
            }
            require(reflex.length <= MAX_REFLEX_LENGTH) {
                "the reflex has ${reflex.length} characters; a command has at most $MAX_REFLEX_LENGTH"
            }
            val foreign = reflex.find { it > '\u00FF' || it.isISOControl() }
            require(foreign == null) {
                "the reflex holds the character U+%04X; ".format(foreign?.code) +
                    "a command has characters up to U+00FF that are no control characters"
            }
            val header = FRAME_HEADER.find(reflex)
            require(header == null) {
                "the reflex '$reflex' holds '${header?.value}', which a board may take for the beginning of another command; leave it out"
            }
            require(!REQUEST.matches(reflex)) {
                "a board takes $reflex for the request for percepts, which argo.percepts(open) sends, and not for a command"
            }
        }
    }
}
