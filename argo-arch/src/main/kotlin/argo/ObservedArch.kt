package argo

import argo.acting.CommandOptions
import argo.acting.commandTerm
import argo.acting.requireCommand
import argo.calls.ArgumentException
import argo.calls.wrongArgument
import argo.filters.PerceptionFilter
import argo.observing.CommandFailure
import argo.observing.ObservedAgent
import argo.observing.ObservedPort
import argo.observing.Order
import argo.observing.Outcome
import argo.observing.Pausing
import argo.observing.SeveralComputers
import argo.perception.filterNames
import argo.perception.filterOf
import argo.platform.Platform
import argo.platform.Waker
import jason.asSemantics.Circumstance
import jason.asSemantics.TransitionSystem
import jason.bb.BeliefBase
import javino.link.SendOptions
import javino.wire.BoardAction
import java.util.logging.Logger

/** The view that observers have of [arch]. */
internal class ObservedArch(
    private val arch: Arch,
    private val waker: Waker,
    private val platform: Platform,
) : ObservedAgent {
    override val name: String = arch.agName
    override val policy get() = arch.policy.word
    override val intervalMs get() = arch.boards.intervalMs
    override val skewMs get() = arch.perception.skewMs()
    override val isPerceiving get() = arch.boards.isPerceiving
    override val beliefs: BeliefBase get() = arch.ts.ag.bb
    override val circumstance: Circumstance get() = arch.ts.c
    override val reasoning: TransitionSystem get() = arch.ts
    override val printed: Logger get() = arch.ts.logger
    override val pausing: Pausing get() = arch.pausing

    private val infrastructure = architectures(arch.ts).filterIsInstance<SeveralComputers>().firstOrNull()
    override val computers get() = infrastructure?.computers.orEmpty()

    override fun nanos() = platform.clock.nanos()

    override fun ports(): List<ObservedPort> {
        val boards = arch.boards
        val inUse = boards.ports.current?.terms.orEmpty()
        return boards.states.all().map { (port, status) ->
            val board = boards.current.find { it.term == port || port in it.port.terms }
            ObservedPort(
                "$port", status.word, port in inUse, boards.current.any { it.isStale(port) },
                board != null, board?.namespace, board?.intervalMs, board?.filter?.name,
            )
        }
    }

    override fun perceptKinds(portName: String) = arch.boards.perceptKinds(portName)
    override fun filterNames() = filterNames(arch.ts.ag)
    override fun filter(name: String) = filterOf(arch.ts.ag, name)
    override fun explain(percept: String) = arch.perception.explain(percept)
    override fun criticalRules() = arch.perception.criticalRules()
    override fun perceiveThrough(filter: PerceptionFilter?, done: () -> Unit) = later(done) { arch.perceiveThrough(filter) }
    override fun perceive(open: Boolean, done: () -> Unit) = later(done) { arch.boards.perceive(open) }

    override val actions: List<BoardAction>?
        get() = arch.boards.current.mapNotNull { it.actions }.takeIf { it.isNotEmpty() }?.flatten()?.distinct()

    override fun act(command: String, options: SendOptions, done: (CommandFailure?) -> Unit) {
        val term = try {
            commandTerm(command).also(::requireCommand)
        } catch (wrong: ArgumentException) {
            return done(wrongArgument(wrong.message.orEmpty()))
        }
        later({}) {
            try {
                arch.commands.send(term, options.toCommandOptions()) { { failure, _ -> done(failure) } }?.let(done)
            } catch (wrong: ArgumentException) {
                done(wrongArgument(wrong.message.orEmpty()))
            }
        }
    }

    override fun reload(done: (Outcome) -> Unit) = arch.reloading.reload(emptySet(), done)
    override fun sources() = arch.reloading.sources()
    override fun order(order: Order, done: (Outcome) -> Unit) = arch.orders.give(order, done = done)

    override fun wake() = waker.wake { true }
    override fun wakeUntil(seen: () -> Boolean) = waker.wake(seen)

    /** Makes the agent's thread do [work] and then [done]. A paused agent does them at once, a running one in its next cycle. */
    private fun later(done: () -> Unit, work: () -> Unit) = arch.requests.put {
        work()
        done()
    }
}

private fun SendOptions.toCommandOptions() = CommandOptions(limitMillis().takeIf { it > 0 }, urgent(), latest())
