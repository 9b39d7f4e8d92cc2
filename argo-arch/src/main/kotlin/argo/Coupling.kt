package argo

import argo.acting.CommandOptions
import argo.acting.CommandSender
import argo.acting.Transmission
import argo.platform.Platform
import argo.platform.Waker
import argo.sensing.Sensing
import argo.sensing.SensingPolicy
import java.util.concurrent.TimeUnit

/** The coupling of reasoning cycles and lines, by the [SensingPolicy]. Belongs to the agent's thread but for [send]. */
internal interface Coupling {
    /** True if messages are written at the pace of the line, see [javino.LinkSettings.paced]. */
    val isPaced: Boolean

    /**
     * Begins to perceive.
     *
     * @param sensings returns the sensing of each port in use; none while perceiving is blocked
     */
    fun perceiving(intervalMs: Int, sensings: () -> List<Sensing>)

    /** Sends [text] as a command. Any thread. */
    fun send(commands: CommandSender, text: String, options: CommandOptions): Transmission
}

/** No reasoning cycle waits for a line: boards are sensed, and commands written, by other threads. */
internal object Decoupled : Coupling {
    override val isPaced get() = true

    override fun perceiving(intervalMs: Int, sensings: () -> List<Sensing>) = Unit

    override fun send(commands: CommandSender, text: String, options: CommandOptions) = commands.send(text, options)
}

/**
 * The published way: the agent's own thread asks each board in turn and waits for its answer, once an interval, and writes commands at
 * once.
 */
internal class InCycle(private val platform: Platform, private val waker: Waker) : Coupling {
    private var lastStart: Long? = null

    override val isPaced get() = false

    override fun perceiving(intervalMs: Int, sensings: () -> List<Sensing>) {
        val start = platform.clock.nanos()
        val isEarly = lastStart?.let { start - it < TimeUnit.MILLISECONDS.toNanos(intervalMs.toLong()) } == true
        val toAsk = if (isEarly) emptyList() else sensings()
        if (toAsk.isEmpty()) return
        lastStart = start
        toAsk.forEach(Sensing::exchange)
        waker.wakeIn(intervalMs.toLong()) // an agent that has nothing else to do must perceive again
    }

    override fun send(commands: CommandSender, text: String, options: CommandOptions): Transmission {
        val failure = commands.sendNow(text, options)
        return Transmission { left, outcome ->
            left()
            outcome(failure)
        }
    }
}
