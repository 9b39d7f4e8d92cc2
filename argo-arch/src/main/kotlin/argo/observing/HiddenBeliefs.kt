package argo.observing

import jason.asSyntax.ASSyntax
import jason.asSyntax.Atom
import jason.asSyntax.Literal

private val HIDDEN: Atom = ASSyntax.createAtom("hide_in_mind_inspector")

/** True if Jason's own tools hide this belief from people, such as the rules that its own plans need. */
val Literal.isHidden: Boolean get() = hasAnnot(HIDDEN)
