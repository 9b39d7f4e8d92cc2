package argo

import argo.acting.CommandOptions
import argo.acting.requireCommand
import jason.asSyntax.Term

/**
 * The internal action `argo.act(W)`: sends the text of W, any literal, to a board: `ledOn`, `speed(120)`. A string is sent without its
 * quotes. `getPercepts`, with or without arguments, is no command: a board reads it as the request for percepts.
 *
 * If the agent perceives several boards, `argo.act(left::stop)` sends `stop` to the one in the namespace `left`, and
 * `argo.act(stop, [port(P)])` to the one on P. `argo.act(stop)` is for the board of the plan's module, unless that board's description
 * lacks `stop`; else for the only board whose description has it; if no description has it, for the board on the port in use.
 *
 * The intention, not the agent, is suspended until the last byte has left the line, or, with a board of version 2 of the protocol, until
 * the board has acknowledged the action. Commands are sent in order.
 *
 * `argo.act(W, Options)` takes a list of
 * - `port(P)`: the board is the one on P, a port that the agent has open, perceived or not
 * - `timeout(Ms)`, 1 to 600,000: the intention resumes at most Ms ms after the call. A command that has not begun to go out by then is
 *   withdrawn, never sent, and fails with `error(act_timeout)`. One that has begun fails with `error(act_unconfirmed)`: the board may carry
 *   it out
 * - `urgent`: the command overtakes waiting ones that are not urgent. It never interrupts a command on the line, and with a board of
 *   version 2 it waits for the outcome of that command
 * - `latest`: the command takes the place of the first waiting one of the same functor, whatever the arguments; that one and all others of
 *   the functor that have not begun to go out are never sent, and fail with `error(act_replaced)`. So `argo.act(speed(V), [latest])` sends
 *   the newest speed when the line is free, however often it is called. With `urgent` it waits among the urgent commands
 *
 * - `answer(R)`: R unifies with the answer of a service or an action of a robot that speaks ROS, as its mapping has it
 *
 * If the agent drops the intention while a robot carries the goal of an action out, the goal is cancelled.
 *
 * Fails the plan with `error(wrong_arguments)`, `error(no_port)` if no port is in use, `error(unknown_board)` if no board has the namespace
 * or the port, `error(ambiguous_action)` if the descriptions of several boards have the action, `error(port_gone)`, `error(port_timeout)`,
 * `error(port_failed)` or `error(not_argo)`; with a board of version 2 also with `error(act_refused)` for an action or arguments that it
 * does not know, and with `error(act_unconfirmed)` if it does not acknowledge the action, though it may have acted; with a robot that
 * speaks ROS also with `error(act_failed)` if the robot could not carry the command out; with `answer(R)` also with `error(no_answer)`, and
 * with `error(other_answer)` if the answer does not unify with R.
 */
@Suppress("ClassName")
open class act : BoardInternalAction("argo.act", 1..2) {
    override val suspends get() = true

    override fun awaitedIn(args: Array<Term>) = args.getOrNull(1)?.let(CommandOptions::of)?.answer

    override fun run(call: Call) {
        val router = call.arch.commands
        val command = call.args[0].also(::requireCommand)
        val options = call.args.getOrNull(1)?.let(CommandOptions::of) ?: CommandOptions()
        val failure = router.send(command, options, moduleOf(call.ts), { perceptBehind(call.ts) }, call::suspendIntention)
        if (failure != null) throw failure.of(call.text)
    }
}
