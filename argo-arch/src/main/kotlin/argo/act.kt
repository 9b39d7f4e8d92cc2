package argo

import argo.acting.CommandOptions
import argo.calls.ArgumentException
import jason.asSyntax.BinaryStructure
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import javino.Frame
import javino.PerceptsRequest

/**
 * The internal action `argo.act(W)`: sends the text of W, any literal, to the board in use: `ledOn`, `speed(120)`. A string
 * is sent without its quotes. `getPercepts`, with or without arguments, is no command: a board takes it for the request for percepts.
 *
 * The intention, not the agent, is suspended until the last byte has left the line, or, with a board of version 2 of the protocol, until
 * the board has acknowledged the action. Commands are sent in order.
 *
 * `argo.act(W, Options)` takes a list of
 * - `timeout(Ms)`, 1 to 600,000: the intention resumes at most Ms ms after the call. A command that has not begun to go out by then is
 *   withdrawn, never sent, and fails with `error(act_timeout)`. One that has begun fails with `error(act_unconfirmed)`: the board may carry
 *   it out
 * - `urgent`: the command overtakes waiting ones that are not urgent. It never interrupts a command on the line, and with a board of
 *   version 2 it waits for the outcome of that command
 * - `latest`: the command takes the place of the first waiting one of the same functor, whatever the arguments; that one and all others of
 *   the functor that have not begun to go out are never sent, and fail with `error(act_replaced)`. So `argo.act(speed(V), [latest])` sends
 *   the newest speed when the line is free, however often it is called. With `urgent` it has the place of an urgent command
 *
 * Fails the plan with `error(wrong_arguments)`, `error(no_port)` when no port is in use, `error(port_gone)`,
 * `error(port_timeout)`, `error(port_failed)` or `error(not_argo)`; with a board of version 2 also with `error(act_refused)` for an action
 * or arguments that it does not know, and with `error(act_unconfirmed)` without its acknowledgement, though it may have acted.
 */
@Suppress("ClassName")
open class act : BoardAction("argo.act", 1..2) {
    override val suspends get() = true

    override fun run(call: Call) {
        val io = call.arch.io
        val text = commandText(call.args[0])
        val options = call.args.getOrNull(1)?.let(CommandOptions::of) ?: CommandOptions()
        val port = io.portInUse() ?: throw call.failure("no_port", "no port is in use; choose one with argo.port first")
        io.send(port, text, options, call.suspendIntention())
    }
}

private fun commandText(term: Term): String {
    val text = when {
        term is StringTerm -> term.string
        !term.isGround -> throw ArgumentException("$term holds a variable that has no value")
        term is Literal && !term.isList && !term.isPlanBody && term !is BinaryStructure -> term.toString()
        else -> throw ArgumentException("a command is a literal such as ledOn or speed(120), not $term")
    }
    if (text.isEmpty()) throw ArgumentException("a command has at least one character")
    if (PerceptsRequest.isIn(text)) {
        throw ArgumentException("a board takes $text for the request for percepts, which argo.percepts(open) sends, and not for a command")
    }
    try {
        return Frame.ofCommand(text).text()
    } catch (unsendable: IllegalArgumentException) {
        throw ArgumentException(unsendable.message.orEmpty())
    }
}
