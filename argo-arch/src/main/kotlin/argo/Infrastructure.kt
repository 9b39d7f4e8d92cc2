package argo

import jason.architecture.AgArch
import jason.infra.local.BaseLocalMAS
import jason.infra.local.RunLocalMAS
import java.util.Collections
import java.util.WeakHashMap
import java.util.logging.Logger

/** Warns if a project does not run on the infrastructure that it declares. Jason itself gives no warning. */
internal object Infrastructure {
    /** The option by which an agent asks for percepts about its fleet. Without a fleet, the option has no effect. */
    const val FLEET_OPTION = "argo_fleet"
    private const val FLEET = "Fleet"
    private const val OF_FLEET = "argo.fleet."
    private val OF_ONE_COMPUTER = setOf("Local", "Centralised")
    private val told: MutableSet<BaseLocalMAS> = Collections.synchronizedSet(Collections.newSetFromMap(WeakHashMap()))

    /** Warns once in a run if Jason's launcher for one computer runs a project that declares another infrastructure. */
    fun check(log: Logger) {
        val runner = BaseLocalMAS.getRunner()?.takeIf { it.javaClass == RunLocalMAS::class.java } ?: return
        val wanted = runner.project?.infrastructure?.className
        if (wanted == null || wanted in OF_ONE_COMPUTER || !told.add(runner)) return
        val remedy = if (wanted == FLEET) "; \"java -jar argo-fleet.jar PROJECT.mas2j --at NAME\" runs the agents of one computer" else ""
        log.severe("infrastructure: $wanted has no effect: Jason's launcher for one computer runs all agents of the project here$remedy")
    }

    /** Warns if the fleet option has no effect because [last], the agent's last architecture, belongs to no fleet. */
    fun checkFleetOption(value: String?, last: AgArch, log: Logger) {
        if (value == null || last.javaClass.name.startsWith(OF_FLEET)) return
        log.warning("$FLEET_OPTION=$value has no effect: the agent runs in no fleet, which argo-fleet.jar starts")
    }
}
