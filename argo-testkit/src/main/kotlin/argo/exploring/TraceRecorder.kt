package argo.exploring

import argo.boundary.Transparent
import argo.observing.AgentObserver
import argo.observing.CommandFailure
import argo.observing.IssuedCommand
import argo.observing.ObservedAgent
import argo.observing.PerceivedMessage
import argo.testkit.TestAgent
import argo.testkit.TestMas
import jason.architecture.AgArch
import jason.asSemantics.Circumstance
import jason.asSemantics.Intention
import jason.asSyntax.InternalActionLiteral
import kotlin.time.Duration
import kotlin.time.Duration.Companion.nanoseconds

/** Records the trace of a run of [mas]. The threads of [mas] run one at a time. */
internal class TraceRecorder(private val mas: TestMas) {
    private val entries = ArrayList<TraceEntry>()
    private val minds = ArrayList<AgentWatch>()

    init {
        mas.observing = { ObserverOf(it) }
    }

    val now: Duration get() = mas.time.nanos().nanoseconds

    fun record(entry: TraceEntry) {
        entries += entry
    }

    fun watch(agent: TestAgent) {
        minds += AgentWatch(agent).also(agent.infra::insertAgArch)
    }

    fun trace(): List<TraceEntry> {
        val names = minds.map { it.agent.name }
        val logged = mas.log.entries.mapNotNull { entry ->
            val at = entry.atNanos.nanoseconds
            val agent = names.find(entry::isOf) ?: return@mapNotNull null
            when {
                entry.isPrinted -> Printed(at, agent, entry.text)
                UNHANDLED.any(entry.text::startsWith) -> FailedUnhandled(at, agent, entry.text.substringBefore(SOURCE).take(LONGEST_TEXT))
                else -> null
            }
        }
        return (entries + logged + minds.flatMap { it.waits() }).sortedBy { it.at }
    }

    private inner class AgentWatch(val agent: TestAgent) : AgArch(), Transparent {
        private var last: MindSize? = null
        private var waiting = emptyMap<String, Pair<String, Duration>>()
        private var said = 0
        private var isStopped = false

        override fun reasoningCycleFinished() {
            super.reasoningCycleFinished()
            val messages = agent.said
            messages.drop(said).forEach { record(Said(now, agent.name, it)) }
            said = messages.size
            val c = agent.ts.c
            val mind = MindSize(now, agent.name, agent.ts.ag.bb.size(), intentionsOf(c).size, c.events.size)
            if (mind != last?.copy(at = now)) record(mind)
            last = mind
            waiting = waitingIn(c).associate { (key, words) -> key to (waiting[key] ?: (words to now)) }
        }

        override fun stop() {
            if (!isStopped && !isOver) record(Stopped(now, agent.name))
            isStopped = true
            super.stop()
        }

        /** Sorts the waits without the ids of intentions, since the ids differ in each run. */
        fun waits() = waiting.values.map { (words, since) -> Waits(now, agent.name, words, since) }
            .sortedWith(compareBy({ it.since }, { it.intention }))
    }

    /** True at the end of the run. Agents that stop after this are not recorded. */
    var isOver = false

    private fun intentionsOf(c: Circumstance) = c.allIntentions.asSequence().distinctBy { it.id }.toList()

    /** Returns each intention at a step without a time limit, as a key and a description. The key identifies the step. */
    private fun waitingIn(c: Circumstance): List<Pair<String, String>> =
        (c.pendingIntentions.values + c.pendingActions.values.mapNotNull { it.intention }).distinctBy { it.id }
            .filterNot { it.isFinished || endsByItself(it) }
            .map { "${it.id} ${it.size()} ${stepOf(it)}" to "${it.last().trigger.literal.copy().apply { clearAnnots() }} at ${stepOf(it)}" }

    /** Returns true if the step of [intention] has a time limit, such as `.wait(9000)` or `.send(bob, askOne, price(P), A, 9000)`. */
    private fun endsByItself(intention: Intention): Boolean {
        val means = intention.peek()
        val step = means.currentStep?.bodyTerm as? InternalActionLiteral ?: return false
        val limits = when (step.functor) {
            ".wait" -> step.terms.take(2)
            ".send" -> step.terms.drop(SEND_LIMIT)
            else -> emptyList()
        }
        return limits.any { it.capply(means.unif).isNumeric }
    }

    private fun stepOf(intention: Intention): String = intention.peek().currentStep?.toString().orEmpty()

    private inner class ObserverOf(private val agent: ObservedAgent) : AgentObserver {
        override fun messageFiltered(message: PerceivedMessage) = record(Received(now, agent.name, message.portName))

        override fun messagePerceived(message: PerceivedMessage) =
            record(Perceived(now, agent.name, message.portName, message.kept.toList(), message.receivedNanos.nanoseconds))

        override fun commandIssued(command: IssuedCommand) =
            record(Issued(now, agent.name, command.number, command.port, command.text, planThatRuns()))

        private fun planThatRuns() = if (mas.time.running == null) planOf(agent.circumstance.selectedIntention) else null

        override fun commandEnded(command: IssuedCommand, failure: CommandFailure?) =
            record(Ended(now, agent.name, command.number, command.text, failure?.error))

        override fun portChanged(port: String, status: String, reason: String?) = record(PortChanged(now, agent.name, port, status))

        override fun close() = Unit
    }

    private fun planOf(intention: Intention?): String? {
        val plan = intention?.takeUnless { it.isFinished }?.peek()?.plan ?: return null
        val place = plan.srcInfo?.let { ", line ${it.srcLine}" }.orEmpty()
        return "${plan.trigger.operator}${plan.trigger.type}${plan.trigger.literal.copy().apply { clearAnnots() }}$place"
    }

    private companion object {
        /** The beginnings of Jason's messages about a failure without a plan. */
        val UNHANDLED = listOf("No failure event was generated for ", "No fail event was generated for ")

        /** The text behind the goal in these messages. */
        const val SOURCE = "["

        /** The index of `.send`'s time limit among its arguments, from 0. */
        const val SEND_LIMIT = 4
        const val LONGEST_TEXT = 200
    }
}
