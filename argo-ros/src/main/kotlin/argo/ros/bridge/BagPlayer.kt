package argo.ros.bridge

import argo.mcap.McapException
import argo.mcap.McapMessage
import javino.LineClock
import kotlinx.serialization.json.JsonObject
import java.io.IOException
import java.util.concurrent.Executor
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicBoolean

/**
 * Plays [bag] by [clock]. Starts at the first subscription to a topic of the bag. A message with an earlier time than its predecessor in
 * the file is published together with the predecessor. Safe for use by several threads.
 *
 * @param worker runs all work on the bag, one task at a time
 * @param isWanted returns true if messages of the topic shall be published
 * @param tell takes one sentence for each problem of the bag, and one for its end
 */
internal class BagPlayer(
    private val bag: Bag,
    private val clock: LineClock,
    private val worker: Executor,
    private val isWanted: (topic: String) -> Boolean,
    private val publish: (topic: String, message: JsonObject) -> Unit,
    private val tell: (sentence: String, isTrouble: Boolean) -> Unit,
) : AutoCloseable {
    private val hasBegun = AtomicBoolean()
    private val messages = bag.messages() // only the worker uses this field and the next one
    private var next: Pair<Long, McapMessage>? = null
    private var startNanos = 0L

    @Volatile
    private var isClosed = false

    /** Starts to play if the bag has [topic]. */
    fun subscribed(topic: String) {
        if (bag.typeOf(topic).isEmpty() || hasBegun.getAndSet(true)) return
        startNanos = clock.nanos() + LEAD_NANOS
        clock.schedule(LEAD_NANOS) { worker.execute(::begin) }
    }

    private fun begin() {
        bag.problems.forEach { tell("of the bag: $it", true) }
        play()
    }

    private fun play() {
        try {
            while (!isClosed) {
                val (sinceNanos, message) = next ?: if (messages.hasNext()) messages.next() else return tell("the bag is over", false)
                val waitNanos = startNanos + sinceNanos - clock.nanos()
                next = (sinceNanos to message).takeIf { waitNanos > 0 }
                if (waitNanos > 0) return clock.schedule(waitNanos) { worker.execute(::play) }
                if (isWanted(message.channel.topic)) take(message)
            }
        } catch (unreadable: IOException) {
            if (!isClosed) tell("the bag cannot be read any further: ${unreadable.message}", true)
        }
    }

    private fun take(message: McapMessage) {
        val fields = try {
            bag.read(message)
        } catch (unreadable: McapException) {
            return tell("a message of ${message.channel.topic} is left out: ${unreadable.message}", true)
        }
        publish(message.channel.topic, fields)
    }

    override fun close() {
        isClosed = true
        bag.close()
    }

    private companion object {
        /** The delay of the first message after the first subscription. Other subscriptions can arrive in this time. */
        val LEAD_NANOS = TimeUnit.MILLISECONDS.toNanos(10)
    }
}
