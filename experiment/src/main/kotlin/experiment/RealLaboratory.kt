package experiment

import javino.LineClock
import samples.collision.Course
import samples.collision.Witness
import java.io.BufferedReader
import java.util.concurrent.CountDownLatch
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/**
 * Asks a user to put a real robot back, and waits for a line from [keyboard]. The end of [keyboard] aborts the experiment. Not safe for use
 * by several threads at once.
 */
internal class Attendant(private val keyboard: BufferedReader, private val given: GivenUp, private val tell: (String) -> Unit) {
    private val answers = LinkedBlockingQueue<Boolean>() // false means that no more answers come
    private val reader = lazy {
        thread(name = "keyboard", isDaemon = true) { // a read of the keyboard cannot be interrupted
            keyboard.forEachLine { answers.put(true) }
            answers.put(false)
        }
    }

    /** Asks the user to put the robot at the start for [trial], and waits. Returns false if the experiment is aborted. */
    fun ready(trial: Trial): Boolean {
        tell("put the robot ${Course.START_CM.toInt()} cm from the wall for ${trial.id}, then press Enter")
        reader.value
        while (!given.isUp) if (answers.poll(LOOK_MS, TimeUnit.MILLISECONDS) ?: continue) return true else given.giveUp()
        return false
    }

    private companion object {
        const val LOOK_MS = 50L
    }
}

/**
 * Makes runs with a real robot on [port], one at a time. Only the front sensor tells the robot's position. Both times of a result start as
 * in a [Sighting]. The times end when the agent's `stop` was sent. The robot has collided if the agent believes a distance of at most
 * [WALL_CM] cm. If the agent does not send `stop`, the laboratory does. [ready] waits until the user has put the robot at the start.
 * [ready] returns false if the experiment is aborted.
 */
internal class RealLaboratory(
    private val host: AgentHost,
    private val port: String,
    private val ready: (Trial) -> Boolean,
    private val clock: LineClock = LineClock.system(),
) : Laboratory {
    private val pause = CountDownLatch(1)

    override fun run(trial: Trial, record: RecordWriter, given: GivenUp): Entry.Result? {
        if (!ready(trial)) return null
        val begin = clock.nanos()
        val sighting = Sighting(trial.limit)
        val witness = sighting.witness(record, begin, clock)
        val agent = host.begin(trial, port, listOf(witness))
        try {
            while (!given.await(LOOK_MS)) {
                val now = clock.nanos()
                val outcome = outcome(witness.beliefs, now - begin) ?: continue
                halt(witness)
                pause.await(SETTLE_MS, TimeUnit.MILLISECONDS) // the newest readings then show the robot at rest
                val (front, _, trouble) = witness.beliefs
                val reason = if (outcome != Outcome.FAILED) null else trouble
                    ?: "the agent has not stopped the robot on $port within $MAX_S s; the front sensor says $front"
                return Entry.Result(
                    outcome, front ?: 0.0, msSince(sighting.crossed, now) ?: 0.0, msSince(sighting.perceived, now), reason = reason,
                )
            }
            halt(witness)
            pause.await(SETTLE_MS, TimeUnit.MILLISECONDS) // the command is sent in this time
            if (witness.beliefs.mayDrive) println("the robot on $port may still drive: its agent could not send stop")
            return null
        } finally {
            host.end(agent)
        }
    }

    private fun outcome(beliefs: Witness.Beliefs, nanos: Long): Outcome? = when {
        beliefs.isStopped -> Outcome.STOPPED
        beliefs.distance.let { it != null && it <= WALL_CM } -> Outcome.COLLIDED
        beliefs.trouble != null || nanos > TimeUnit.SECONDS.toNanos(MAX_S) -> Outcome.FAILED
        else -> null
    }

    /**
     * Stops the robot if its agent has not done so. The motors keep their last command. Does nothing if the agent is in trouble, since it
     * then has no board.
     */
    private fun halt(witness: Witness) {
        if (!witness.beliefs.isStopped && witness.beliefs.trouble == null) witness.haltRobot()
    }

    companion object {
        /** At this distance in cm or less, a robot counts as at the wall. */
        const val WALL_CM = 3.0
        private const val LOOK_MS = 5L
        private const val SETTLE_MS = 1_000L
        private const val MAX_S = 60L
    }
}
