package argo.testkit

import argo.observing.AgentObserver
import argo.observing.AgentObserverProvider
import argo.observing.ObservedAgent
import java.util.logging.Logger

/** Gives an agent under test the observer of its [TestMas]. */
class TestObserverProvider : AgentObserverProvider {
    override val option: String get() = OPTION

    override val usage: String get() = "observed in a test of the test kit"

    override fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver? =
        VirtualTime.active()?.mas?.observing?.invoke(agent)

    internal companion object {
        const val OPTION = "argo_tested"
    }
}
