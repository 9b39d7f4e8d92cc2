package argo

import jason.architecture.AgArch
import jason.asSemantics.TransitionSystem

/** All architectures of the agent of [ts], the first one first. */
internal fun architectures(ts: TransitionSystem): Sequence<AgArch> = generateSequence(ts.agArch) { it.nextAgArch }
