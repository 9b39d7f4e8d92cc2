package argo

import argo.acting.CommandOptions
import argo.acting.requireCommand
import jason.asSyntax.Term

/**
 * The internal action `argo.act(W)`: sends the text of W, any literal, to a board: `ledOn`, `speed(120)`. A string is sent without its
 * quotes. `getPercepts`, with or without arguments, cannot be sent: a board reads it as the request for percepts.
 *
 * If the agent perceives several boards, `argo.act(left::stop)` sends `stop` to the board in the namespace `left`, and `argo.act(stop,
 * [port(P)])` to the board on P. `argo.act(stop)` goes to the board of the plan's module, unless the board's description lacks `stop`.
 * Then, or if the plan is in no module, the command goes to the only board whose description has `stop`. If no description has `stop`, the
 * command goes to the board on the port in use.
 *
 * The intention, not the agent, is suspended until the last byte has left the line. With a board of version 2 of the protocol, it is
 * suspended until the board has acknowledged the action. A board with a table of actions has then carried it out; a sketch that
 * reads messages one by one has taken it. Commands are sent in order.
 *
 * `argo.act(W, Options)` takes a list of
 * - `port(P)`: the command goes to the board on P, an open port of the agent, perceived or not
 * - `timeout(Ms)`, 1 to 600,000: the intention resumes at most Ms ms after the call. A command that still waits then is never sent, and
 *   fails with `error(act_timeout)`. A command that has begun to go out fails with `error(act_unconfirmed)`: the board may carry it out
 * - `urgent`: the command overtakes waiting commands that are not urgent. An urgent command never interrupts a command on the line; with a
 *   board of version 2 it also waits for that command's outcome
 * - `latest`: the command replaces all commands of its functor that still wait, whatever their arguments. Replaced commands are never sent
 *   and fail with `error(act_replaced)`; the new command waits where the first of them waited. So `argo.act(speed(V), [latest])` sends the
 *   newest speed when the line is free, however often it is called. With `urgent` the new command waits among the urgent commands
 * - `answer(R)`: R unifies with the answer of a service or an action of a robot that speaks ROS; the robot's mapping says in which form
 *
 * If the agent drops the intention while the robot still carries out an action, the action's goal is cancelled.
 *
 * Fails the plan with `error(wrong_arguments)`, `error(no_port)` if no port is in use, `error(unknown_board)` if no board has the namespace
 * or the port, `error(ambiguous_action)` if the descriptions of several boards have the action, `error(port_gone)`, `error(port_timeout)`,
 * `error(port_failed)` or `error(not_argo)`. With a board of version 2 it also fails with `error(act_refused)`, if the board does not know
 * the action or its arguments, and with `error(act_unconfirmed)`, if the board does not acknowledge the action; the board may have carried
 * it out. With a robot that speaks ROS it also fails with `error(act_failed)`, if the robot could not carry the command out. With
 * `answer(R)` it also fails with `error(no_answer)`, and with `error(other_answer)`, if the answer does not unify with R.
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
