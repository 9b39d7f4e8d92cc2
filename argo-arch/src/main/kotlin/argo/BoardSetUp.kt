package argo

import argo.calls.ArgumentException
import argo.calls.Failure
import argo.connecting.WantedPort
import argo.filters.GroundTerm
import argo.filters.PerceptionFilter
import argo.filters.jason.PerceptReader
import argo.platform.Platform
import jason.JasonException
import jason.asSyntax.Literal

/**
 * Describes an agent's use of its boards as calls of internal actions, and sets boards up by these calls.
 *
 * @param told receives the reason for each call that cannot be repeated
 */
internal class BoardSetUp(private val arch: Arch, private val platform: Platform, private val told: (String) -> Unit) {
    private val boards get() = arch.boards
    private val ports get() = arch.boards.ports

    private var awaited: List<String>? = null // calls that wait until all ports are open; null if none waits

    /**
     * Returns the calls, without the prefix `argo.`, that set the boards up. While ports are still being opened, these are the calls for
     * the time when all ports are open. Called by the agent's thread.
     */
    fun calls(): List<String> = awaited?.let { it + ofAgent() } ?: (listOfNotNull(portsInUse()) + ofAgent() + ofBoards())

    private fun ofAgent(): List<String> = buildList {
        add("limit(${boards.intervalMs})")
        add("percepts(${if (boards.isPerceiving) "open" else "block"})")
        boards.filter?.let { add("change_filter(${nameOf(it)})") }
    }

    private fun ofBoards(): List<String> = buildList {
        for (board in boards.current) {
            board.ownIntervalMs?.let { add("limit($it,[port(${board.term})])") }
            if (board.hasOwnFilter) add("change_filter(${nameOf(board.filter)},[port(${board.term})])")
        }
    }

    private fun portsInUse(): String? = ports.inUse.takeIf { it.isNotEmpty() }
        ?.joinToString(",", "ports([", "])") { "port(${it.term},${it.port.options.text})" }

    private fun nameOf(filter: PerceptionFilter?) = filter?.let { "${GroundTerm.Text(it.name)}" } ?: "none"

    /**
     * Sets the boards up by [calls]. Calls [done] once, on any thread, when all ports are open. Tries again each second to open a port that
     * cannot be opened. If the agent meanwhile chooses ports itself, also calls [done].
     */
    fun restore(calls: List<String>, done: () -> Unit) {
        val read = calls.associateWith(PerceptReader::read)
        val (choice, settings) = read.values.partition { it.functor == PORTS }
        val (ofBoards, ofAgent) = settings.partition { it.arity > 1 }
        later { ofAgent.forEach(::carryOut) }
        val wanted = choice.lastOrNull()?.let(::portsIn) ?: return done()
        awaited = read.filterValues { it !in ofAgent }.keys.toList()
        open(wanted, ::waits) {
            later {
                ofBoards.forEach(::carryOut)
                awaited = null
            }
            done()
        }
    }

    private fun waits(failure: Failure) = told("${failure.cause}; this is tried again each second, and the goals wait for it")

    private fun portsIn(choice: Literal): List<WantedPort>? = try {
        wantedPorts(choice.getTerm(0))
    } catch (wrong: ArgumentException) {
        null.also { told("argo.$choice: ${wrong.message}") }
    }

    private fun open(wanted: List<WantedPort>, failed: (Failure) -> Unit, done: () -> Unit) {
        val choice = ports.choicesSoFar + 1
        ports.chooseAll(wanted) { failure ->
            if (failure == null) return@chooseAll done()
            failed(failure)
            platform.later(AGAIN_MS) { if (ports.choicesSoFar == choice) open(wanted, { }, done) else done() }
        }
    }

    /** Calls [setUp] in the agent's next cycle, so the agent's recording contains the filters. */
    private fun later(setUp: () -> Unit) = arch.ts.runAtBeginOfNextCycle { setUp() }

    /** Carries out [call] as if a plan contained it. */
    private fun carryOut(call: Literal) {
        val action = ACTIONS[call.functor]?.invoke() ?: return told("argo.$call is no call that sets boards up")
        try {
            action.carryOut(action.Call(arch.ts, call.termsArray))
        } catch (refused: JasonException) {
            told("${refused.message}")
        }
    }

    private companion object {
        const val PORTS = "ports"
        const val AGAIN_MS = 1000L

        /** The actions, besides [PORTS], by which an agent sets its boards up. */
        val ACTIONS = mapOf("limit" to ::limit, "percepts" to ::percepts, "change_filter" to ::change_filter)
    }
}
