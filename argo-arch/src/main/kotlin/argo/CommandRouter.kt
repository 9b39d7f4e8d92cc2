package argo

import argo.acting.CommandOptions
import argo.acting.Transmission
import argo.acting.commandText
import argo.boards.AgentBoards
import argo.boards.Board
import argo.calls.Failure
import argo.calls.NO_ANSWER
import argo.connecting.OpenPort
import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import argo.platform.isSameFile
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import jason.bb.BeliefBase

/**
 * Finds the board for a command of the agent among [boards], and sends the command to the board. For the agent's thread only.
 *
 * A command may name its board by a namespace, or by a port in its options. For any other command, these boards are tried in this order:
 * 1. the board of the plan's module, if its description has the command, or if it has no description
 * 2. the only board whose description has the command
 * 3. the board on the port in use, if no description has the command
 */
internal class CommandRouter(private val boards: AgentBoards) {
    private sealed interface Route {
        data class To(val port: OpenPort) : Route
        data class Nowhere(val failure: Failure) : Route
    }

    /**
     * Sends [command], a literal or a string. Until the command is done, one board gives the agent no further snapshot. This is the board
     * that sent the percept behind the command or, without a percept, the board that gets the command.
     *
     * @param module the namespace of the module whose plan sends the command; null if the plan is in no module
     * @param cause returns the percept that made the agent send the command, or null. Called when the command is under way, before
     * [outcome]
     * @param outcome returns the receiver of the outcome, see [Transmission.follow]. Called with [Transmission.giveUp] when the command is
     * under way
     * @return null if the command was sent, else the reason why it was not sent
     * @throws argo.calls.ArgumentException if the line cannot carry the command
     */
    fun send(
        command: Term,
        options: CommandOptions,
        module: String? = null,
        cause: () -> Literal? = { null },
        outcome: (giveUp: (() -> Unit)?) -> (Failure?, String?) -> Unit,
    ): Failure? = when (val route = routeOf(command, options.port, module)) {
        is Route.Nowhere -> route.failure
        is Route.To -> {
            val text = commandText(command, route.port.link.isLine)
            if (options.answer != null && !route.port.link.answers(text)) return Failure(NO_ANSWER, noAnswer(text, route.port))
            val sent = boards.send(route.port, text, options)
            hold(sent, route.port, cause(), outcome(sent.giveUp))
            null
        }
    }

    private fun noAnswer(text: String, port: OpenPort) = "port ${port.link.port} has no answer to \"$text\", which was not sent; only " +
        "services and actions of a robot that speaks ROS have one"

    private fun hold(sent: Transmission, port: OpenPort, cause: Literal?, outcome: (Failure?, String?) -> Unit) {
        val causing = cause?.let(boards::of).orEmpty()
        val holder = causing.find { it.port === port } ?: causing.firstOrNull() ?: boards.inUseOn(port)
        val ledger = holder?.ledger ?: return sent.follow({ }, outcome)
        val number = ledger.issue(port)
        sent.follow({ ledger.done(port, number) }, outcome)
    }

    private fun routeOf(command: Term, port: Term?, module: String?): Route {
        if (port != null) return boards.openPort(port)?.let { Route.To(it) } ?: unknown(unknownBoard(port, boards))
        val inUse = boards.ports.current ?: return Route.Nowhere(NO_PORT)
        val literal = literalOf(command)
        val namespace = literal?.ns?.takeIf { command !is StringTerm && it != Literal.DefaultNS }?.functor
        return when {
            namespace != null -> within(namespace, literal, inUse)
            !boards.areSeveral || literal == null -> Route.To(inUse)
            else -> ofModule(module, literal, inUse) ?: among(boards.current, literal, inUse) ?: Route.To(inUse)
        }
    }

    private fun within(namespace: String, command: Literal, inUse: OpenPort): Route {
        val named = boards.current.filter { it.namespace == namespace }
        return named.singleOrNull()?.let { Route.To(it.port) }
            ?: among(named, command, inUse)
            ?: named.find { it.port === inUse }?.let { Route.To(it.port) }
            ?: if (named.isEmpty()) unknown(noSuchNamespace(namespace)) else ambiguous(command, named)
    }

    private fun ofModule(module: String?, command: Literal, inUse: OpenPort): Route? {
        if (module == null) return null
        val isKnown = boards.current.any { it.namespace == module && (it.actions == null || it.knows(command)) }
        return if (isKnown) within(module, command, inUse) else null
    }

    private fun among(some: List<Board>, command: Literal, inUse: OpenPort): Route? {
        val knowing = some.filter { it.knows(command) }
        return when (knowing.size) {
            0 -> null
            1 -> Route.To(knowing.single().port)
            else -> ambiguous(command, knowing)
        }
    }

    private fun unknown(cause: String) = Route.Nowhere(Failure("unknown_board", cause))

    private fun ambiguous(command: Literal, able: List<Board>) = Route.Nowhere(
        Failure(
            "ambiguous_action",
            "${able.joinToString(" and ") { "${it.term}" }} could each be the board for ${command.functor}; " +
                "name one by its namespace, argo.act(NAMESPACE::${command.functor}), or by its port, [port(${able.first().term})]",
        ),
    )

    private fun noSuchNamespace(namespace: String) =
        "no board has the namespace $namespace; " + boards.current.mapNotNull { it.namespace }.distinct().let {
            if (it.isEmpty()) "the option as($namespace) of argo.port gives a board this namespace" else "there are ${it.joinToString()}"
        }

    private companion object {
        val NO_PORT = Failure("no_port", "no port is in use; choose one with argo.port first")
    }
}

/** Returns the command as a literal; null if it is a string that cannot be read as a literal. */
private fun literalOf(command: Term): Literal? = try {
    if (command is StringTerm) PerceptReader.read(command.string) else command as? Literal
} catch (_: PerceptSyntaxException) {
    null
}

/** Returns the namespace of the module that contains the current plan of the agent of [ts]; null if the plan is in no module. */
internal fun moduleOf(ts: TransitionSystem): String? {
    val plan = intentionOf(ts)?.peek()?.plan ?: return null
    val namespace = plan.trigger.literal.ns.takeIf { it != Literal.DefaultNS } ?: return null
    return namespace.functor.takeIf { !isSameFile(plan.sourceFile, ts.ag.aslSrc) }
}

/** Returns the percept that began the current intention of the agent of [ts]; null if another event began it. */
internal fun perceptBehind(ts: TransitionSystem): Literal? = intentionOf(ts)?.bottom?.trigger?.literal
    ?.takeIf { it.hasSource(BeliefBase.APercept) }

/** Returns the current intention of the agent of [ts]; null if it has finished. */
private fun intentionOf(ts: TransitionSystem): Intention? = ts.c.selectedIntention?.takeUnless { it.isFinished }
