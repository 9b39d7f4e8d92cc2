package argo.exploring

import kotlin.random.Random
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds

/** Draws the events of a run of [exploration] from a seed: equal seeds give equal events. Messages go to the agents named [agents]. */
internal class RandomEvents(private val exploration: Exploration, private val agents: List<String>) {
    private val ports = exploration.boards.keys.toList()
    private val sensing = exploration.boards.entries.flatMap { (port, board) -> board.sensors.map { port to it } }

    fun events(seed: Long): List<WorldEvent> {
        val random = Random(seed)
        val makers = makers(random)
        val kinds = makers.shuffled(random).take(1 + random.nextInt(makers.size)) // runs with few kinds of events find more faults
        var at = FIRST_AT
        return (1..1 + random.nextInt(exploration.mostEvents)).mapNotNull {
            at += pause(random)
            if (at > exploration.eventful) null else kinds[random.nextInt(kinds.size)](at)
        }
    }

    /**
     * Adds a fault to [events], the events of [run]. The fault hits a command of [run]: it begins shortly before the command, during its
     * transfer, or at its outcome. Returns null if no command was sent, or if the exploration has no fault that hits commands.
     *
     * A command takes so little time that random faults seldom hit it.
     */
    fun atCommand(run: Run, events: List<WorldEvent>, seed: Long): List<WorldEvent>? {
        val random = Random(seed.inv())
        val kinds = hits(random).takeIf { it.isNotEmpty() } ?: return null
        val sent = run.trace.filterIsInstance<Issued>().filter { it.port in exploration.boards && it.at <= exploration.eventful }
        val equal = sent.groupBy { it.command }.values.toList().takeIf { it.isNotEmpty() } ?: return null
        val command = equal[random.nextInt(equal.size)].let { it[random.nextInt(it.size)] } // rare and frequent commands have equal chances
        val ended = run.of(command.agent).filterIsInstance<Ended>().find { it.number == command.number }?.at ?: command.at
        val from = (command.at.inWholeMilliseconds - AROUND_MS).coerceAtLeast(1)
        val until = minOf(ended, command.at + LONGEST).inWholeMilliseconds + AROUND_MS
        val at = random.nextLong(from, until + 1).milliseconds
        return (events + kinds[random.nextInt(kinds.size)](at, command.port)).sortedBy { it.at }
    }

    private fun hits(random: Random): List<(Duration, String) -> WorldEvent> = exploration.played.mapNotNull { fault ->
        when (fault) {
            Fault.CABLES -> { at, port -> Unplugged(at, port, lasts(random)) }
            Fault.SILENCE -> { at, port -> Hangs(at, port, lasts(random)) }
            Fault.RESTARTS -> { at, port -> Restarts(at, port, random.nextInt(10, 2000).milliseconds) }
            Fault.NOISE -> { at, port -> Garbles(at, port, random.nextInt(3, 20), lasts(random)) }
            Fault.SLOWNESS, Fault.FLOODS, Fault.FLICKER, Fault.LATE_MESSAGES -> null
        }
    }

    /** Draws the time until the next event. Often the agent is still handling the previous event. */
    private fun pause(random: Random): Duration = when (random.nextInt(4)) {
        0 -> random.nextInt(1, 60)
        1 -> random.nextInt(60, 600)
        else -> random.nextInt(600, 3000)
    }.milliseconds

    private fun lasts(random: Random): Duration = LENGTHS[random.nextInt(LENGTHS.size)].let { random.nextInt(it / 2, it + 1) }.milliseconds

    private fun makers(random: Random): List<(Duration) -> WorldEvent> {
        fun port() = ports[random.nextInt(ports.size)]
        val makers = ArrayList<(Duration) -> WorldEvent>()
        if (sensing.isNotEmpty()) repeat(2) { makers += { at -> reads(at, random) } }
        val messages = exploration.messages
        if (messages.isNotEmpty()) makers += { at -> messages[random.nextInt(messages.size)].copy(at = at) }
        for (fault in exploration.played) when (fault) {
            Fault.CABLES -> makers += { at -> Unplugged(at, port(), lasts(random)) }
            Fault.SILENCE -> {
                makers += { at -> Hangs(at, port(), lasts(random)) }
                makers += { at -> IgnoresRequests(at, port(), lasts(random)) }
            }
            Fault.SLOWNESS -> makers += { at -> AnswersLate(at, port(), random.nextInt(20, 600).milliseconds, lasts(random)) }
            Fault.RESTARTS -> makers += { at -> Restarts(at, port(), random.nextInt(10, 2000).milliseconds) }
            Fault.NOISE -> makers += { at -> Garbles(at, port(), random.nextInt(5, 120), lasts(random)) }
            Fault.FLOODS -> makers += { at -> Floods(at, port(), random.nextInt(2, 30)) }
            Fault.FLICKER -> if (sensing.isNotEmpty()) makers += { at -> flickers(at, random) }
            Fault.LATE_MESSAGES -> if (agents.size > 1) makers += { at ->
                MessagesLate(at, agents[random.nextInt(agents.size)], random.nextInt(10, 2000).milliseconds, lasts(random))
            }
        }
        return makers.ifEmpty { error("nothing can happen: no sensor, no message and no fault is described") }
    }

    private fun reads(at: Duration, random: Random): Reads {
        val (port, sensor) = sensing[random.nextInt(sensing.size)]
        val last = sensor.percepts.lastIndex
        val index = when (random.nextInt(4)) {
            0 -> 0
            1 -> last
            else -> random.nextInt(last + 1)
        }
        return Reads(at, port, sensor.name, sensor.percepts[index])
    }

    /** Draws a sensor and two neighbouring values, between which the sensor flickers. */
    private fun flickers(at: Duration, random: Random): Flickers {
        val (port, sensor) = sensing[random.nextInt(sensing.size)]
        val index = random.nextInt(sensor.percepts.size)
        val far = maxOf(1, sensor.percepts.size / NEAR)
        val other = (index + 1 + random.nextInt(far)).let { if (it > sensor.percepts.lastIndex) maxOf(0, index - 1) else it }
        val every = random.nextInt(20, 400).milliseconds
        return Flickers(at, port, sensor.name, sensor.percepts[index], sensor.percepts[other], every, lasts(random))
    }

    private companion object {
        val FIRST_AT = 200.milliseconds

        /** Upper limits for the length of a fault in ms. A loose contact is short, and a missing board is long. */
        val LENGTHS = listOf(40, 200, 800, 2000, 5000)

        /** The margin in ms around a command, within which a fault that hits the command begins. */
        const val AROUND_MS = 3L

        /** The latest beginning of a fault that hits a command, counted from the command. */
        val LONGEST = 200.milliseconds

        /** The range of a sensor divided by [NEAR] is the greatest change while it flickers. */
        const val NEAR = 20
    }
}
