package argo.testkit

import jason.asSyntax.Structure
import jason.environment.EnvironmentInfraTier
import jason.runtime.RuntimeServices
import jason.runtime.RuntimeServicesFactory

/** The infrastructure of the environment of agents under test. */
internal class EnvironmentTier(private val mas: TestMas) : EnvironmentInfraTier {
    override fun informAgsEnvironmentChanged(vararg agents: String) =
        mas.running().filter { agents.isEmpty() || it.name in agents }.forEach { it.infra.wake() }

    override fun getRuntimeServices(): RuntimeServices = RuntimeServicesFactory.get()

    override fun isRunning(): Boolean = mas.running().isNotEmpty()

    override fun actionExecuted(agent: String, action: Structure, success: Boolean, infraData: Any?) =
        throw UnsupportedOperationException("the outcome of $action is what executeAction returns")
}
