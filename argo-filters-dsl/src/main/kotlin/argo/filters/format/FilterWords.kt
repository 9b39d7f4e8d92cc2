package argo.filters.format

import argo.filters.PerceptionFilter.Mode
import argo.filters.PerceptionFilter.OnSwitch

/** The words that both kinds of files have for what a whole filter does. */
internal object FilterWords {
    /** What `keep` may be. */
    val MODES = mapOf("true" to Mode.KEEP, "false" to Mode.DROP)

    /** What `onSwitch` may be. */
    val ON_SWITCHES = mapOf("forget" to OnSwitch.FORGET, "freeze" to OnSwitch.FREEZE)
}
