package argo.recording.agent

import argo.observing.isHidden
import jason.bb.BeliefBase

/** The beliefs in [base], as Jason writes them, without rules and those that Jason hides itself. */
internal fun shownBeliefs(base: BeliefBase): List<String> = base.filterNot { it.isRule || it.isHidden }.map { "$it" }
