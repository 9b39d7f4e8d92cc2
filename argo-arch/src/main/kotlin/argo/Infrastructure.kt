package argo

import jason.architecture.AgArch
import jason.infra.local.BaseLocalMAS
import jason.infra.local.RunLocalMAS
import java.util.Collections
import java.util.WeakHashMap
import java.util.logging.Logger

/** Reports that a project does not get the infrastructure that it asks for. Jason itself does not report it. */
internal object Infrastructure {
    /** The option by which an agent asks for percepts about its fleet. The fleet's infrastructure reads the option. */
    const val FLEET_OPTION = "argo_fleet"
    private const val FLEET = "Fleet"
    private const val OF_FLEET = "argo.fleet."
    private val OF_ONE_COMPUTER = setOf("Local", "Centralised")
    private val told: MutableSet<BaseLocalMAS> = Collections.synchronizedSet(Collections.newSetFromMap(WeakHashMap()))

    /** Tells [log], once in a run, if Jason's launcher for one computer runs a project that asks for another infrastructure. */
    fun check(log: Logger) {
        val runner = BaseLocalMAS.getRunner()?.takeIf { it.javaClass == RunLocalMAS::class.java } ?: return
        val wanted = runner.project?.infrastructure?.className
        if (wanted == null || wanted in OF_ONE_COMPUTER || !told.add(runner)) return
        val remedy = if (wanted == FLEET) "; \"java -jar argo-fleet.jar PROJECT.mas2j --at NAME\" runs the agents of one computer" else ""
        log.severe("infrastructure: $wanted has no effect: Jason's launcher for one computer runs all agents of the project here$remedy")
    }

    /** Tells [log] that the fleet option with [value] has no effect if [last], the agent's last architecture, belongs to no fleet. */
    fun checkFleetOption(value: String?, last: AgArch, log: Logger) {
        if (value == null || last.javaClass.name.startsWith(OF_FLEET)) return
        log.warning("$FLEET_OPTION=$value has no effect: the agent runs in no fleet, which argo-fleet.jar starts")
    }
}
