package argo.testkit

import jason.architecture.AgArch
import jason.asSyntax.Literal

/** Counts how often the agent has perceived something new; it is the first of its architectures. */
internal class PerceptionCounter : AgArch() {
    var perceptions = 0
        private set

    override fun perceive(): MutableCollection<Literal>? = super.perceive().also { if (it != null) perceptions++ }
}
