package argo

import argo.acting.commandTerm
import argo.acting.requireCommand
import argo.calls.ArgumentException
import argo.observing.ObserverOptions
import argo.perception.PerceptLimit
import argo.sensing.SensingPolicy
import jason.asSyntax.Term
import jason.runtime.Settings
import java.util.concurrent.ConcurrentHashMap
import java.util.logging.Logger

/**
 * The options of an agent's architecture in the `.mas2j`: `agents: robot [argo_sensing=every, argo_view=8080] agentArchClass argo.Arch;`. A
 * system property such as `-Dargo_watch=true` adds an option to the [settings] of each agent without this option. A replay ignores system
 * properties, since its agents have the recorded options. Unknown options and values are reported to [log] and ignored.
 */
internal class ArchOptions(private val settings: Settings, private val log: Logger, isReplay: Boolean) {
    private val ofProgram: Set<String> = if (isReplay) emptySet() else addProperties()

    val policy: SensingPolicy = sensingPolicy()

    val maxPercepts: Int = maxPercepts()

    /** The command that makes a board safe before the agent is paused; null if there is none. */
    val safe: Term? = safeCommand()

    /** The file that keeps the agent's state; null if the state is not kept. */
    val resume: String? = settings.getUserParameter(Resuming.OPTION)

    val observers = ObserverOptions(observerOptions(), log)

    init {
        val own = listOf("$SENSING=${SensingPolicy.words}", "${PerceptLimit.OPTION}=N", "$SAFE=COMMAND", "${Resuming.OPTION}=FILE")
        val known = own + observers.usages
        observers.unread.filter { it !in ofProgram || TOLD.add(it) }.forEach {
            val missing = MODULES[it]?.let { module -> "; the module $module, which argo.jar holds, is not on the class path" }
            log.warning("$it is not an option of argo.Arch, which has ${known.joinToString()}" + missing.orEmpty())
        }
    }

    private fun addProperties(): Set<String> {
        val names = System.getProperties().stringPropertyNames().filter { it.startsWith(PREFIX) && it !in settings.userParameters }
        names.forEach { settings.addOption(it, System.getProperty(it)) }
        return names.toSet()
    }

    private fun observerOptions(): Map<String, String> =
        settings.userParameters.keys.filter { it.startsWith(PREFIX) && it !in OWN }.associateWith(settings::getUserParameter)

    private fun sensingPolicy(): SensingPolicy {
        val word = settings.getUserParameter(SENSING) ?: return SensingPolicy.FRESH
        return (SensingPolicy.of(word) ?: SensingPolicy.FRESH.also {
            log.severe("$SENSING=$word: a policy is one of ${SensingPolicy.words}; ${it.word} is used")
        }).also {
            if (it == SensingPolicy.IN_CYCLE) {
                log.warning(
                    "$SENSING=$word: each reasoning cycle waits for the board, so the agent falls behind the world; for comparison only",
                )
            }
        }
    }

    private fun maxPercepts(): Int {
        val written = settings.getUserParameter(PerceptLimit.OPTION)?.trim() ?: return PerceptLimit.DEFAULT
        return written.toIntOrNull()?.takeIf { it > 0 } ?: PerceptLimit.DEFAULT.also {
            log.severe("${PerceptLimit.OPTION}=$written: the limit of percepts believed at once is a whole number from 1; $it is used")
        }
    }

    private fun safeCommand(): Term? {
        val written = settings.getUserParameter(SAFE) ?: return null
        return try {
            commandTerm(written).also(::requireCommand)
        } catch (wrong: ArgumentException) {
            log.severe("$SAFE=$written: ${wrong.message}; the boards go on with what they do while the agent is paused")
            null
        }
    }

    private companion object {
        const val PREFIX = "argo_"
        const val SENSING = "argo_sensing"
        const val SAFE = "argo_safe"
        val OWN = setOf(SENSING, SAFE, PerceptLimit.OPTION, Resuming.OPTION, Infrastructure.FLEET_OPTION)

        /** The unknown system properties that a log has already reported. */
        val TOLD: MutableSet<String> = ConcurrentHashMap.newKeySet()

        /** The options that modules of this project add, each with its module. */
        val MODULES = mapOf(
            "argo_view" to "argo-view", "argo_debug" to "argo-debug", "argo_record" to "argo-recording", "argo_ros" to "argo-ros",
        )
    }
}
