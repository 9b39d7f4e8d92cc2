package argo.platform

import argo.boundary.Boundary
import argo.links.BoardLink
import argo.links.BoardLinkProvider
import argo.links.JavinoLink
import javino.LineClock
import javino.Transports
import javino.link.Link
import javino.link.LinkSettings
import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.TimeUnit
import java.util.logging.Level
import java.util.logging.Logger

/**
 * The platform of an `argo.Arch`: its time, its threads and its ports. [system] is the machine. A test can pass a platform with virtual
 * time. Any thread may call the functions.
 */
interface Platform {
    /** The clock of the architecture. The architecture's threads wait on locks of this clock. */
    val clock: LineClock

    /**
     * The boundary that gives agents on this platform their inputs, as in a replay. If null, inputs come from [open] ports and from Jason.
     */
    val boundary: Boundary? get() = null

    /** True if the world and its time stop while an agent's thread is blocked, as in virtual time and in a replay. */
    val standsStill: Boolean get() = false

    /** Starts [run] on a new thread called [name]. The thread does not keep the program alive, and ends when interrupted. */
    fun start(name: String, run: () -> Unit): Thread

    /**
     * Does [action] in [delayMs] ms of [clock]. Does nothing if the whole system has ended. [action] must not wait. Its exceptions are
     * logged.
     */
    fun later(delayMs: Long, action: () -> Unit)

    /**
     * Opens a port for the agent [owner]. Opening may take seconds. See [Link.open] and [BoardLinkProvider.open] for times and exceptions.
     */
    fun open(port: String, settings: LinkSettings, owner: String): BoardLink

    /** Returns true if [port] can probably be opened, but does not open it. Called about once a second while a device is missing. */
    fun isPresent(port: String): Boolean = BoardLinkProvider.of(port)?.isPresent(port) ?: Transports.isPresent(port)

    companion object {
        val system: Platform = object : Platform {
            override val clock: LineClock = LineClock.system()

            override fun start(name: String, run: () -> Unit) = Thread(run, name).apply {
                isDaemon = true
                start()
            }

            override fun later(delayMs: Long, action: () -> Unit) {
                try {
                    SchedulerLayer.machine().schedule({ carryOut(action) }, delayMs, TimeUnit.MILLISECONDS)
                } catch (_: RejectedExecutionException) {
                    // the multi-agent system is being stopped, so nobody needs the action
                }
            }

            private fun carryOut(action: () -> Unit) = try {
                action()
            } catch (broken: Throwable) { // otherwise Jason's scheduler would hide the exception
                Logger.getLogger(Platform::class.java.name).log(Level.SEVERE, "a delayed action has failed", broken)
            }

            override fun open(port: String, settings: LinkSettings, owner: String): BoardLink =
                BoardLinkProvider.of(port)?.open(port, settings.paced(), clock) ?: JavinoLink(Link.open(port, settings, owner))
        }
    }
}

internal val Platform.nowMs: () -> Long get() = { clock.nanos() / 1_000_000 }
