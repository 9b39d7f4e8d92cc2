package experiment.delegation

import experiment.AgentHost
import experiment.SlowComputer
import jason.asSyntax.ASSyntax.parseLiteral
import jason.asSyntax.Literal
import jason.infra.local.LocalAgArch
import javino.sim.SimulatedBoards
import java.util.concurrent.Semaphore

/**
 * The agents of [run] on one computer. The load of the run gives its number of processors. Each is [slowdown] times slower than a processor
 * of this computer. The boards are on [ports], in the order of the design. [host] runs the agents.
 */
internal class Society(
    private val run: DelegationRun, private val ports: List<String>, private val slowdown: Double, private val host: AgentHost,
) {
    private val load = run.load
    private val processors = Semaphore(load.processors, true)
    private val computers = ArrayList<SlowComputer>()

    val busyNanos: Long get() = computers.sumOf { it.busyNanos }

    /** Creates and starts the agents. An agent that receives messages starts before the agents that send them. */
    fun begin(): List<LocalAgArch> = when (run.design) {
        Design.ONE, Design.BOARDS -> listOf(whole("all", ports, KINDS))
        Design.KINDS_APART -> KINDS.mapIndexed { i, kind -> whole(kind, listOf(ports[i]), listOf(kind)) }
        Design.DELEGATES -> KINDS.map { member(it, "reasoner", isArgo = false, kinds = listOf(it)) } +
            member("body", "body", beliefs = sensing(ports) + KINDS.map { parseLiteral("reasons_on($it,${name(it)})") })
    }

    private fun whole(role: String, boards: List<String>, kinds: List<String>) = member(role, "whole", sensing(boards), kinds)

    private fun name(role: String) = "${run.id}_$role"

    private fun sensing(boards: List<String>): List<Literal> {
        val ports = boards.map { "port(\"${SimulatedBoards.SCHEME}:$it\",[baud($BAUD)])" }
        return listOf(parseLiteral("boards($ports)"), parseLiteral("interval(${load.interval})"))
    }

    private fun member(
        role: String, program: String, beliefs: List<Literal> = emptyList(), kinds: List<String> = emptyList(), isArgo: Boolean = true,
    ) = host.begin(
        name(role), "delegation/$program.asl", isArgo,
        beliefs = beliefs + if (kinds.isEmpty()) emptyList() else (1 until load.plans).map { parseLiteral("alarm$it(0)") },
        plans = kinds.flatMap { plansFor(it, load.plans) },
        witnesses = listOf(SlowComputer(slowdown, processors).also(computers::add)),
    )

    companion object {
        const val BAUD = 115_200
    }
}

/** Returns [count] plans for a percept of this [kind]. Only the last one applies. The other plans need a belief that does not exist. */
internal fun plansFor(kind: String, count: Int): List<String> =
    (1 until count).map { "+$kind(_, N) : alarm$it(Limit) & N < Limit." } + "+$kind(_, _)."
