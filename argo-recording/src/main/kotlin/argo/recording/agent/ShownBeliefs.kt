package argo.recording.agent

import argo.observing.isHidden
import jason.bb.BeliefBase

/** Returns the beliefs in [base] as Jason writes them, without rules and beliefs that Jason itself hides. */
internal fun shownBeliefs(base: BeliefBase): List<String> = base.filterNot { it.isRule || it.isHidden }.map { "$it" }
