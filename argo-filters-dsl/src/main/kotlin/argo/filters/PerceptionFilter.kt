package argo.filters

import java.util.Objects

/**
 * A perception filter. A filter's [rules] decide which percepts an agent perceives.
 *
 * Immutable, and safe to share between agents. Two filters are equal if all their properties except [name] are equal.
 *
 * @property name the name by which agents call the filter
 * @property mode whether the filter drops or keeps percepts that meet a rule
 * @property onSwitch whether an agent that changes to this filter forgets or freezes the beliefs that the filter hides
 * @param critical the rules for urgent percepts, which decide before all other rules
 * @param smoothing the rules for noisy sensors. The first of these rules that a percept meets smooths the percept
 */
class PerceptionFilter(
    val name: String,
    rules: List<Rule>,
    val mode: Mode = Mode.DROP,
    val onSwitch: OnSwitch = OnSwitch.FORGET,
    critical: List<CriticalRule> = emptyList(),
    smoothing: List<SmoothingRule> = emptyList(),
) {
    /** Tells what the filter does with percepts that meet a rule. */
    enum class Mode {
        /** Percepts that meet a rule are dropped. All others are kept. The filters of the ARGO paper have this mode. */
        DROP,

        /** Percepts that meet a rule are kept. All others are dropped. */
        KEEP,
    }

    /** Tells what happens to hidden beliefs when an agent changes to a filter. */
    enum class OnSwitch {
        /** Jason's belief update deletes the hidden beliefs. */
        FORGET,

        /** The hidden beliefs stay as they are at the change. */
        FREEZE,
    }

    val rules: List<Rule> = java.util.List.copyOf(rules)

    /** The rules for urgent percepts, in order. */
    val critical: List<CriticalRule> = java.util.List.copyOf(critical)

    /** The rules for percepts of noisy sensors, in order. */
    val smoothing: List<SmoothingRule> = java.util.List.copyOf(smoothing)

    constructor(name: String, vararg rules: Rule) : this(name, rules.asList())

    override fun equals(other: Any?): Boolean =
        other is PerceptionFilter && mode == other.mode && onSwitch == other.onSwitch && rules == other.rules &&
            critical == other.critical && smoothing == other.smoothing

    override fun hashCode(): Int = Objects.hash(mode, onSwitch, rules, critical, smoothing)

    /** Returns the filter in words: `filter frontDistance drops temperature; light; distance where argument 0 is not front`. */
    override fun toString(): String {
        val verb = if (mode == Mode.DROP) "drops" else "keeps only"
        val what = if (rules.isEmpty()) "nothing" else rules.joinToString("; ")
        val lane = if (critical.isEmpty()) "" else critical.joinToString("; ", ", treats as critical ")
        val smooth = if (smoothing.isEmpty()) "" else smoothing.joinToString("; ", ", smooths ")
        return "filter $name $verb $what$lane$smooth" + if (onSwitch == OnSwitch.FREEZE) ", and freezes what it hides" else ""
    }
}
