package argo.testkit

import argo.boundary.Transparent
import jason.architecture.AgArch
import jason.asSyntax.Literal

/** Counts how often the agent has perceived something new; it is the first of its architectures. */
internal class PerceptionCounter : AgArch(), Transparent {
    var perceptions = 0
        private set

    override fun perceive(): MutableCollection<Literal>? = super.perceive().also { if (it != null) perceptions++ }
}
