package argo.filters

import java.util.Objects

/**
 * A perception filter. A filter's [rules] decide which percepts an agent perceives.
 *
 * Immutable, and safe to share between agents. Two filters are equal if they make the same decisions, even under different [name]s.
 *
 * @property name the name by which agents call the filter
 * @property mode whether percepts that meet a rule are dropped or kept
 * @property onSwitch whether beliefs that this filter hides are forgotten or frozen when an agent changes to the filter
 * @param critical the rules for urgent percepts, which decide before all other rules
 * @param smoothing the rules for noisy sensors; a percept is smoothed by the first of these rules that it meets
 */
class PerceptionFilter(
    val name: String,
    rules: List<Rule>,
    val mode: Mode = Mode.DROP,
    val onSwitch: OnSwitch = OnSwitch.FORGET,
    critical: List<CriticalRule> = emptyList(),
    smoothing: List<SmoothingRule> = emptyList(),
) {
    /** What the filter does with percepts that meet a rule. */
    enum class Mode {
        /** Percepts that meet a rule are dropped, all others are kept. The filters of the ARGO paper have this mode. */
        DROP,

        /** Percepts that meet a rule are kept, all others are dropped. */
        KEEP,
    }

    /** What happens to beliefs that a filter hides when an agent changes to the filter. */
    enum class OnSwitch {
        /** Jason's belief update deletes the hidden beliefs. */
        FORGET,

        /** The hidden beliefs stay as they were at the change. */
        FREEZE,
    }

    val rules: List<Rule> = java.util.List.copyOf(rules)

    /** The rules for urgent percepts, in their order. */
    val critical: List<CriticalRule> = java.util.List.copyOf(critical)

    /** The rules for percepts of noisy sensors, in their order. */
    val smoothing: List<SmoothingRule> = java.util.List.copyOf(smoothing)

    constructor(name: String, vararg rules: Rule) : this(name, rules.asList())

    override fun equals(other: Any?): Boolean =
        other is PerceptionFilter && mode == other.mode && onSwitch == other.onSwitch && rules == other.rules &&
            critical == other.critical && smoothing == other.smoothing

    override fun hashCode(): Int = Objects.hash(mode, onSwitch, rules, critical, smoothing)

    /** The filter in words: `filter frontDistance drops temperature; light; distance where argument 0 is not front`. */
    override fun toString(): String {
        val verb = if (mode == Mode.DROP) "drops" else "keeps only"
        val what = if (rules.isEmpty()) "nothing" else rules.joinToString("; ")
        val lane = if (critical.isEmpty()) "" else critical.joinToString("; ", ", treats as critical ")
        val smooth = if (smoothing.isEmpty()) "" else smoothing.joinToString("; ", ", smooths ")
        return "filter $name $verb $what$lane$smooth" + if (onSwitch == OnSwitch.FREEZE) ", and freezes what it hides" else ""
    }
}
