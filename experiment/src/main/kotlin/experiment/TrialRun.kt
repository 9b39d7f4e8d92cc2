package experiment

import javino.LineClock
import javino.sim.SimulatedBoard
import javino.sim.SimulatedBoards
import javino.sim.Sketch
import samples.board.FieldBoard
import samples.collision.Course
import samples.collision.Robot
import samples.collision.Sensors
import samples.collision.Witness
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import kotlin.random.Random

/** Makes runs, and writes their records without the result. */
internal fun interface Laboratory {
    /** Makes the run [trial]. Returns its result, or null if [given] has ended the run. Safe for use by several threads. */
    fun run(trial: Trial, record: RecordWriter, given: GivenUp): Entry.Result?
}

/** Tells waiting threads that the experiment is aborted. */
internal class GivenUp {
    private val latch = CountDownLatch(1)

    val isUp: Boolean get() = latch.count == 0L

    fun giveUp() = latch.countDown()

    /** Waits for up to [millis] ms. Returns true if the experiment is aborted. */
    fun await(millis: Long): Boolean = latch.await(millis, TimeUnit.MILLISECONDS)
}

/** Simulates robots in real time. Each calling thread of [run] has its own robot. */
internal class SimulatedLaboratory(
    private val host: AgentHost,
    private val punctuality: Punctuality,
    private val settings: Settings<Plan>,
    private val clock: LineClock = LineClock.system(),
) : Laboratory {
    override fun run(trial: Trial, record: RecordWriter, given: GivenUp): Entry.Result? {
        val begin = clock.nanos()
        val robot = Robot(clock, Sensors(Random(noiseSeed(trial, settings.seed)), trial.sensors / Sensors.PER_SET))
        val sketch = RecordedSketch(robot, record, begin, clock)
        SimulatedBoards.plugIn(trial.id, board(trial, sketch))
        val sighting = Sighting(trial.limit)
        val witness = sighting.witness(record, begin, clock)
        val agent = host.begin(trial, "${SimulatedBoards.SCHEME}:${trial.id}", listOf(witness, SlowComputer(settings.slowdown)))
        try {
            while (!given.await(LOOK_MS)) {
                val now = clock.nanos()
                val beliefs = witness.beliefs
                val end = measured(robot.course, trial.limit, sighting.perceived, now)?.takeIf { isOver(trial, it, beliefs) }
                    ?: unmeasured(robot.course, now, beliefs.trouble ?: overdue(robot.course, now - begin) ?: continue, beliefs)
                return end.copy(commands = sketch.commands.get(), frames = sketch.frames.get(), lateMs = punctuality.worstSinceMs(begin))
            }
            return null
        } finally {
            host.end(agent)
            SimulatedBoards.unplug(trial.id)
        }
    }

    /**
     * Returns true if the run is over. If the board has stopped the robot, the run continues until the agent has done so, too. A command
     * under way may restart the robot.
     */
    private fun isOver(trial: Trial, measured: Entry.Result, beliefs: Witness.Beliefs) = measured.outcome == Outcome.COLLIDED ||
        measured.sincePerceivingMs != null && (trial.condition != Condition.REFLEX || beliefs.isStopped)

    private fun unmeasured(course: Course, now: Long, reason: String, beliefs: Witness.Beliefs) = Entry.Result(
        if (beliefs.trouble == null && course.departure == null) Outcome.IDLE else Outcome.FAILED, course.distanceAt(now), reason = reason,
    )

    private fun overdue(course: Course, nanos: Long): String? = when {
        nanos <= TimeUnit.SECONDS.toNanos(MAX_S) -> null
        course.departure == null -> "no command to drive has reached the board within $MAX_S s"
        else -> "the robot has neither stopped nor reached the wall within $MAX_S s"
    }

    private fun board(trial: Trial, sketch: Sketch): SimulatedBoard =
        when (trial.condition) {
            Condition.REFLEX -> SimulatedBoard { sketch.run(it, clock, 1) }
            Condition.VERSION_2 -> SimulatedBoard { sketch.run(it, clock, 0) }
            else -> SimulatedBoard { FieldBoard(sketch, clock).run(it) }
        }

    private companion object {
        const val LOOK_MS = 20L
        const val MAX_S = 60L
    }
}

/**
 * Returns the result of a robot on [course], or null while it drives or is at the start. [limit] is the distance in cm at which the agent
 * should stop the robot. [perceived] is the time at which the agent perceived the wall, or null if it has not.
 */
internal fun measured(course: Course, limit: Int, perceived: Long?, now: Long): Entry.Result? {
    val (outcome, end) = when (course.stateAt(now)) {
        Course.State.STOPPED -> Outcome.STOPPED to checkNotNull(course.halt)
        Course.State.COLLIDED -> Outcome.COLLIDED to checkNotNull(course.reached(0.0, now))
        else -> return null
    }
    val sinceLimitMs = msSince(course.reached(limit.toDouble(), now), end) ?: 0.0
    return Entry.Result(outcome, course.distanceAt(now), sinceLimitMs, msSince(perceived, end))
}

internal fun msSince(start: Long?, end: Long): Double? = start?.let { (end - it) / 1e6 }

/** A robot that records its percepts and actions, with its true distance. */
internal class RecordedSketch(
    private val robot: Robot, private val record: RecordWriter, private val begin: Long, private val clock: LineClock,
) : Sketch {
    override fun actions() = robot.actions()

    /** The number of commands that have taken effect. Safe for use by several threads. */
    val commands = AtomicInteger()

    val frames = AtomicInteger()

    override fun percepts(): List<String> {
        val now = clock.nanos()
        return robot.percepts().also {
            frames.incrementAndGet()
            record.write(Entry.Frame(now - begin, it.joinToString("") { percept -> "$percept;" }, robot.course.distanceAt(now)))
        }
    }

    override fun sensors() = robot.percepts() // the board reads these for its rules, so they are not recorded

    override fun act(command: String) = robot.act(command).also {
        commands.incrementAndGet()
        val now = clock.nanos()
        record.write(Entry.Command(now - begin, command, robot.course.distanceAt(now)))
    }
}
