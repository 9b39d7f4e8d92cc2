package argo.boards

import argo.acting.BoardRules
import argo.acting.CommandSender
import argo.connecting.OpenPort
import argo.connecting.PortStatus
import argo.filters.CriticalRule
import argo.filters.foreignText
import argo.links.BoardMessage
import argo.links.Wish
import argo.sensing.Sensing
import argo.sensing.SensingInstants
import argo.sensing.SensingListener
import javino.PerceptsRequest
import javino.PortException
import javino.PortTimeoutException
import javino.link.BoardListener
import javino.wire.ReflexOutcome
import java.util.concurrent.TimeUnit

/**
 * The users of one open port: sensing, commands, and rules on the board. All of them work even if the agent does not perceive the board.
 */
internal class BoardLine(private val port: OpenPort, private val agent: AgentBoards, private val closed: () -> Unit) :
    BoardListener, SensingListener, AutoCloseable {
    val commands = CommandSender(port.link, agent.owner, agent.platform) { agent.ports.lost(port, it) }
    val sensing = Sensing(port, agent.owner, this, agent.platform)

    val described = DescribedPercepts(port) { agent.log.warning(it) }

    private val warning = agent.rateLimitedWarning() // about reports that are left out; each rule is a kind of warning

    val rules = BoardRules(
        { agent.boardOn(port)?.takeIf { agent.leavesRulesToBoards }?.critical.orEmpty() },
        { change, outcome -> commands.send(change).follow({ }) { failure, _ -> outcome(failure) } },
    )

    override val intervalMs get() = agent.boardOn(port)?.intervalMs ?: agent.intervalMs

    override fun nextStart(startNanos: Long) =
        if (agent.areSeveral) SensingInstants.after(startNanos, TimeUnit.MILLISECONDS.toNanos(intervalMs.toLong()))
        else super.nextStart(startNanos)

    override fun isSensed(port: OpenPort) = agent.boardOn(port) != null

    override fun request(port: OpenPort): String {
        val board = agent.boardOn(port) ?: return PerceptsRequest.ALL
        board.answer.asked(agent.platform.clock.nanos())
        return if (port.link.canSelect) board.request else PerceptsRequest.ALL
    }

    override fun mayReport(port: OpenPort) = !rules.isEmpty

    override fun received(port: OpenPort, message: BoardMessage, askedNanos: Long) {
        agent.boardOn(port)?.received(port, message, askedNanos, nextStart(askedNanos))
        described.askIfWanted()
    }

    override fun unanswered(port: OpenPort, trouble: PortTimeoutException) {
        agent.boardOn(port)?.answer?.stayedOut()
        agent.ports.report(port, PortStatus.TIMEOUT, trouble.message)
    }

    override fun answeredAgain(port: OpenPort) = agent.ports.report(port, PortStatus.ON)

    override fun lost(port: OpenPort, trouble: PortException) = agent.ports.lost(port, trouble)

    override fun sessionBegan(room: Int) {
        described.renew()
        rules.began(room)
    }

    override fun critical(rule: Int, outcome: ReflexOutcome, percept: String, receivedNanos: Long) {
        val critical = rules.ruleOf(rule)
        val isTaken = critical != null && rules.isHeld(critical) &&
            agent.boardOn(port)?.reported(port, critical, outcome, percept, receivedNanos) == true
        if (!isTaken) tellLeftOut(critical, outcome, percept)
    }

    /** Logs that a report is not used. The board does not know yet that the agent no longer wants the report. */
    private fun tellLeftOut(rule: CriticalRule?, outcome: ReflexOutcome, percept: String) {
        val of = "${rule ?: "unknown percepts"}"
        warning.report(of) {
            val reflex = if (outcome == ReflexOutcome.CARRIED_OUT) ". It has carried the reflex out" else ""
            "the board on port ${port.link.port} reports ${foreignText(percept)} by the critical rule on $of, which is watched no more, " +
                "so the report is left out$reflex"
        }
    }

    /** Passes the agent's wishes for the board on again: its rules, interval and filter. Any thread. */
    fun renew() {
        rules.renew()
        sensing.wake()
        val board = agent.boardOn(port)
        port.link.wants(Wish(board != null, intervalMs, board?.filter))
    }

    override fun close() {
        sensing.close()
        closed()
    }
}
