package argo.recording.agent

import jason.asSyntax.ASSyntax
import jason.asSyntax.Atom
import jason.bb.BeliefBase

private val HIDDEN: Atom = ASSyntax.createAtom("hide_in_mind_inspector") // of what Jason's own plans need

/** The beliefs in [base], as Jason writes them, without rules and those that Jason hides itself. */
internal fun shownBeliefs(base: BeliefBase): List<String> = base.filterNot { it.isRule || it.hasAnnot(HIDDEN) }.map { "$it" }
