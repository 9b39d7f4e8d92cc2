package argo

import argo.perception.PerceptLimit
import argo.ports.whole
import argo.sensing.SensingPolicy
import jason.runtime.Settings
import java.util.logging.Logger

/**
 * What a `.mas2j` says about an agent's architecture: `agents: robot [argo_sensing=every, argo_view=8080] agentArchClass argo.Arch;`.
 *
 * A word that means nothing is told to [log], and the agent runs as if it were not there.
 */
internal class ArchOptions(private val settings: Settings, private val log: Logger) {
    /** When snapshots are handed over. */
    val policy: SensingPolicy = sensingPolicy()

    /** How many percepts of a board are believed at once. */
    val mostPercepts: Int = mostPercepts()

    /** What is written for the port of the live view; null: there is to be none. */
    val view: String? = settings.getUserParameter(VIEW)

    init {
        settings.userParameters.keys.filter { it.startsWith("argo_") && it !in KNOWN }.forEach {
            log.warning("$it is not an option of argo.Arch, which has $SENSING=${SensingPolicy.words}, ${PerceptLimit.OPTION}=N and $VIEW=a port number")
        }
    }

    private fun sensingPolicy(): SensingPolicy {
        val word = settings.getUserParameter(SENSING) ?: return SensingPolicy.FRESH
        return (SensingPolicy.of(word) ?: SensingPolicy.FRESH.also {
            log.severe("$SENSING=$word: a policy is one of ${SensingPolicy.words}; ${it.word} is used")
        }).also {
            if (it == SensingPolicy.IN_CYCLE) log.warning("$SENSING=$word: every reasoning cycle waits for the board, so this agent falls behind the world; for comparison only")
        }
    }

    private fun mostPercepts(): Int {
        val written = settings.getUserParameter(PerceptLimit.OPTION)?.trim() ?: return PerceptLimit.DEFAULT
        return written.toIntOrNull()?.takeIf { it > 0 } ?: PerceptLimit.DEFAULT.also {
            log.severe("${PerceptLimit.OPTION}=$written: the most percepts that are believed at once are a whole number from 1; $it is used")
        }
    }

    private companion object {
        const val SENSING = "argo_sensing"
        const val VIEW = "argo_view"
        val KNOWN = setOf(SENSING, VIEW, PerceptLimit.OPTION)
    }
}
