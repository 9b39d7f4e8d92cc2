package argo

import argo.acting.CommandOptions
import argo.acting.requireCommand
import jason.asSyntax.Term

/**
 * The internal action `argo.act(W)`: sends the text of W, any literal, to a board: `ledOn`, `speed(120)`. A string is sent without its
 * quotes. `getPercepts`, with or without arguments, cannot be sent, since boards read it as the request for percepts.
 *
 * `argo.act(left::stop)` sends `stop` to the board in the namespace `left`. `argo.act(stop, [port(P)])` sends `stop` to the board on P. If
 * the agent perceives several boards, `argo.act(stop)` goes to the board of the plan's module, if this board's description has `stop` or
 * the board has no description. If the plan's module gives no board, `argo.act(stop)` goes to the only board with `stop` in its
 * description. If no description has `stop`, `argo.act(stop)` goes to the board on the port in use.
 *
 * The action suspends the intention, not the agent, until the last byte has left the line. If the board speaks version 2 of the protocol,
 * the intention is suspended until the board has acknowledged the action. A board with a table of actions acknowledges an action that it
 * has carried out. A sketch that reads messages one by one acknowledges a message that it has taken. Commands are sent in order.
 *
 * `argo.act(W, Options)` takes a list of
 * - `port(P)`: the command goes to the board on P, an open port of the agent, perceived or not
 * - `timeout(Ms)`, 1 to 600,000: the intention resumes at most Ms ms after the call. A command that is still waiting at that time is never
 *   sent, and fails with `error(act_timeout)`. A command that has begun to go out fails with `error(act_unconfirmed)`, and the board may
 *   carry it out
 * - `urgent`: the command overtakes waiting commands that are not urgent. An urgent command never interrupts a command on the line. If the
 *   board speaks version 2, the urgent command also waits for the outcome of the command on the line
 * - `latest`: the command replaces all waiting commands with its functor, even if their arguments differ. Replaced commands are never sent
 *   and fail with `error(act_replaced)`. The new command takes the place of the first replaced command; if it is `urgent`, it waits among
 *   the urgent commands. For example, `argo.act(speed(V), [latest])` sends only the newest speed when the line is free
 * - `answer(R)`: R unifies with the answer of a service or an action of a robot that speaks ROS. The robot's mapping defines the form of
 *   the answer
 *
 * If the agent drops the intention while a ROS robot carries out an action, the goal of the robot's action is cancelled.
 *
 * Fails the plan with `error(wrong_arguments)`, `error(no_port)` if no port is in use, `error(unknown_board)` if no board has the namespace
 * or the port, `error(ambiguous_action)` if the descriptions of several boards have the action, `error(port_gone)`, `error(port_timeout)`,
 * `error(port_failed)` or `error(not_argo)`. With a board of version 2, fails also with `error(act_refused)` if the board does not know the
 * action or its arguments. If the board does not acknowledge the action, fails with `error(act_unconfirmed)`; the board may have carried
 * the action out. With a robot that speaks ROS, fails also with `error(act_failed)` if the robot could not carry the command out. With
 * `answer(R)`, fails also with `error(no_answer)`, or with `error(other_answer)` if the answer does not unify with R.
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
