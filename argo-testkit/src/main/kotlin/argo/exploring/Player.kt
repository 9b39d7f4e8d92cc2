package argo.exploring

import argo.testkit.Board
import argo.testkit.MasSetUp
import argo.testkit.TestAgent
import argo.testkit.TestMas
import argo.testkit.nanos
import javino.PortException
import kotlin.time.Duration

/** Runs agents once with the boards of [exploration] and with [events], which are in order of time. */
internal class Player(private val exploration: Exploration, private val events: List<WorldEvent>) {
    private val state = WorldState(exploration.boards, events)
    private val mas = TestMas()
    private val recorder = TraceRecorder(mas)
    private val faults = HashMap<Board, Trouble>()

    private data class Trouble(val isUnplugged: Boolean, val hangs: Boolean)

    fun play(program: ExploredProgram): Run = mas.use {
        mas.mostCycles = MOST_CYCLES
        mas.delayOf = { state.messageDelay(it.receiver, recorder.now) }
        try {
            mas.begin {
                with(program) { MasSetUp(mas).make { describedBy(exploration, state) } }
                mas.all.forEach(recorder::watch)
            }
            drive()
        } catch (busy: AssertionError) { // the test kit detected an agent that reasons without end
            recorder.record(NeverRests(recorder.now, busy.message.orEmpty().lineSequence().first()))
        }
        recorder.isOver = true
        Run(events, recorder.trace(), recorder.now, mas.all.map(TestAgent::name), arrived(), opened())
    }

    private fun drive() {
        val end = exploration.lengthOf(events)
        val changes = events.flatMap { listOf(it.at, it.ends) }.distinct().sorted()
        for (at in changes) {
            passUntil(at)
            boards().forEach { (port, board) -> change(port, board, at) }
            events.filter { it.at == at }.forEach(::begin)
        }
        passUntil(end)
    }

    /** Advances time to [at]. An agent that waits inside its cycle may already have advanced it further. */
    private fun passUntil(at: Duration) {
        mas.after((at - recorder.now).coerceAtLeast(Duration.ZERO))
    }

    private fun boards(): List<Pair<String, Board>> =
        mas.all.flatMap { it.platform.named().toList() }.filter { (port, _) -> port in exploration.boards }

    private fun change(port: String, board: Board, at: Duration) {
        board.isSilent = state.ignoresRequests(port, at)
        board.garbledOneIn = state.garbledOneIn(port, at)
        board.answersAfter(state.lateness(port, at))
        val before = faults[board] ?: Trouble(isUnplugged = false, hangs = false)
        val now = Trouble(state.isUnplugged(port, at), state.hangs(port, at))
        faults[board] = now
        if (now.isUnplugged != before.isUnplugged) if (now.isUnplugged) board.disconnects() else board.reconnects()
        if (now.hangs && !now.isUnplugged) board.hangs() else if (before.hangs) board.recovers()
    }

    private fun begin(event: WorldEvent) {
        recorder.record(Happened(event.at, event))
        when (event) {
            is Restarts -> boards().filter { it.first == event.board }.forEach { (_, board) -> board.restarts(event.booting) }
            is Floods -> repeat(event.messages) { mas.time.later(nanos(FLOOD_INTERVAL * it)) { send(event.board) } }
            is Hears -> if (event.agent in mas.names) mas[event.agent].hears(event.sender, event.performative, event.content)
            else -> Unit // [WorldState] contains all other events
        }
    }

    private fun send(port: String) {
        val percepts = state.percepts(port, recorder.now).toTypedArray()
        boards().filter { it.first == port && it.second.isOpen }.forEach { (_, board) ->
            try {
                board.says(*percepts)
            } catch (_: IllegalStateException) {
                // the board is restarting
            } catch (_: PortException) {
                // the cable is unplugged
            }
        }
    }

    private fun arrived(): Map<String, List<String>> =
        mas.all.flatMap { agent -> agent.platform.named().map { (port, board) -> "${agent.name} $port" to board.commands } }.toMap()

    private fun opened(): Set<String> =
        mas.all.flatMap { agent -> agent.platform.named().filterValues(Board::wasOpened).keys }.toSet()

    private companion object {
        /** The limit is smaller than that of tests. Runs are many, and an agent that repeats a failing step grows in each cycle. */
        const val MOST_CYCLES = 500
    }
}
