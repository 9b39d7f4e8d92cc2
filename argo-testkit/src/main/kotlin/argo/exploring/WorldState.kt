package argo.exploring

import kotlin.time.Duration

/** The state of the outside world at any time of a run, which depends only on [events]. */
internal class WorldState(private val boards: Map<String, ExploredBoard>, private val events: List<WorldEvent>) {
    fun percepts(port: String, at: Duration): List<String> =
        boards.getValue(port).sensors.map { shownBy(port, it, at) }.filter { it.isNotEmpty() }

    private fun shownBy(port: String, sensor: Sensor, at: Duration): String {
        val flickers = active<Flickers>(at) { it.board == port && it.sensor == sensor.name }.lastOrNull()
        if (flickers != null) return if (((at - flickers.at) / flickers.every).toLong() % 2 == 0L) flickers.percept else flickers.other
        val reads = events.lastOrNull { it is Reads && it.at <= at && it.board == port && it.sensor == sensor.name } as Reads?
        return reads?.percept ?: sensor.percepts[sensor.first]
    }

    fun isUnplugged(port: String, at: Duration) = active<Unplugged>(at) { it.board == port }.isNotEmpty()

    fun hangs(port: String, at: Duration) = active<Hangs>(at) { it.board == port }.isNotEmpty()

    fun ignoresRequests(port: String, at: Duration) = active<IgnoresRequests>(at) { it.board == port }.isNotEmpty()

    fun lateness(port: String, at: Duration): Duration =
        active<AnswersLate>(at) { it.board == port }.maxOfOrNull { it.by } ?: Duration.ZERO

    fun garbledOneIn(port: String, at: Duration): Int = active<Garbles>(at) { it.board == port }.minOfOrNull { it.oneIn } ?: 0

    fun messageDelay(agent: String, at: Duration): Duration =
        active<MessagesLate>(at) { it.agent == agent }.maxOfOrNull { it.by } ?: Duration.ZERO

    private inline fun <reified E : WorldEvent> active(at: Duration, matches: (E) -> Boolean): List<E> =
        events.filterIsInstance<E>().filter { at >= it.at && at < it.ends && matches(it) }
}
