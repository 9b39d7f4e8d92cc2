package argo

import argo.boards.Board
import argo.calls.Failure
import argo.connecting.OpenPort
import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import jason.bb.BeliefBase
import kotlin.io.path.Path

/**
 * Finds the board of [io]'s agent for a command. Belongs to the agent's thread.
 *
 * A command names its board by its namespace, or by a port in its options. A command that does neither is for the board of its plan's
 * module, unless that board has described itself without it; else for the one board that has described itself with it; else, if no board
 * has, for the one on the port in use.
 */
internal class Routing(private val io: AgentIo) {
    /** The port of a board, or the reason why there is none. */
    sealed interface Route {
        data class To(val port: OpenPort) : Route
        data class Nowhere(val failure: Failure) : Route
    }

    /**
     * Returns the port for [command].
     *
     * @param command a literal, or a string
     * @param port the port that the options name; null: they name none
     * @param module the namespace of the module in which the command is; null: it is in none
     */
    fun routeOf(command: Term, port: Term?, module: String?): Route {
        if (port != null) return io.openPort(port)?.let { Route.To(it) } ?: unknown(unknownBoard(port, io))
        val inUse = io.portInUse() ?: return Route.Nowhere(NO_PORT)
        val literal = literalOf(command)
        val namespace = literal?.ns?.takeIf { command !is StringTerm && it != Literal.DefaultNS }?.functor
        return when {
            namespace != null -> within(namespace, literal, inUse)
            io.perceivedBoards().size < 2 || literal == null -> Route.To(inUse)
            else -> ofModule(module, literal, inUse) ?: among(io.perceivedBoards(), literal, inUse) ?: Route.To(inUse)
        }
    }

    private fun within(namespace: String, command: Literal, inUse: OpenPort): Route {
        val boards = io.perceivedBoards().filter { it.namespace == namespace }
        return boards.singleOrNull()?.let { Route.To(it.port) }
            ?: among(boards, command, inUse)
            ?: boards.find { it.port === inUse }?.let { Route.To(it.port) }
            ?: if (boards.isEmpty()) unknown(noSuchNamespace(namespace)) else ambiguous(command, boards)
    }

    private fun ofModule(module: String?, command: Literal, inUse: OpenPort): Route? {
        val boards = io.perceivedBoards().filter { module != null && it.namespace == module && (it.actions == null || it.knows(command)) }
        return if (boards.isEmpty()) null else within(checkNotNull(module), command, inUse)
    }

    /** Returns the one of [boards] that has described itself with [command]; null: none has. */
    private fun among(boards: List<Board>, command: Literal, inUse: OpenPort): Route? {
        val knowing = boards.filter { it.knows(command) }
        return when (knowing.size) {
            0 -> null
            1 -> Route.To(knowing.single().port)
            else -> ambiguous(command, knowing)
        }
    }

    private fun unknown(cause: String) = Route.Nowhere(Failure("unknown_board", cause))

    private fun ambiguous(command: Literal, boards: List<Board>) = Route.Nowhere(
        Failure(
            "ambiguous_action",
            "${boards.joinToString(" and ") { "${it.term}" }} are all boards for ${command.functor}; " +
                "name one by its namespace, argo.act(NAMESPACE::${command.functor}), or by its port, [port(${boards.first().term})]",
        ),
    )

    private fun noSuchNamespace(namespace: String) =
        "no board has the namespace $namespace; " + io.perceivedBoards().mapNotNull { it.namespace }.distinct().let {
            if (it.isEmpty()) "the option as($namespace) of argo.port gives it to one" else "there are ${it.joinToString()}"
        }

    private companion object {
        val NO_PORT = Failure("no_port", "no port is in use; choose one with argo.port first")
    }
}

/** Returns the command as a literal; null: it is a string that holds none. */
private fun literalOf(command: Term): Literal? = try {
    if (command is StringTerm) PerceptReader.read(command.string) else command as? Literal
} catch (_: PerceptSyntaxException) {
    null
}

/** Returns the namespace of the module with the plan that the agent of [ts] is carrying out; null: the plan is in no module. */
internal fun moduleOf(ts: TransitionSystem): String? {
    val plan = intentionOf(ts)?.peek()?.plan ?: return null
    val namespace = plan.trigger.literal.ns.takeIf { it != Literal.DefaultNS } ?: return null
    return namespace.functor.takeIf { !isSameFile(plan.sourceFile, ts.ag.aslSrc) }
}

/** Returns true if both name one file. Jason gives its whole path, a URL or only its name. */
private fun isSameFile(one: String?, other: String?): Boolean {
    if (one == null || other == null) return one == other
    val (path, otherPath) = listOf(one, other).map { Path(it.removePrefix("file:")).normalize() }
    return path.endsWith(otherPath) || otherPath.endsWith(path)
}

/** Returns the percept whose event began the intention that the agent of [ts] is carrying out; null: none did. */
internal fun perceptBehind(ts: TransitionSystem): Literal? = intentionOf(ts)?.bottom?.trigger?.literal
    ?.takeIf { it.hasSource(BeliefBase.APercept) }

/** Returns the intention that the agent of [ts] is carrying out; null: it has finished. */
private fun intentionOf(ts: TransitionSystem): Intention? = ts.c.selectedIntention?.takeUnless { it.isFinished }
