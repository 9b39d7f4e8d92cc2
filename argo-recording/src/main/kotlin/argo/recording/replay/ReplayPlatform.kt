package argo.recording.replay

import argo.boundary.Boundary
import argo.links.BoardLink
import argo.platform.Platform
import javino.LineClock
import javino.LinkSettings
import javino.NoSuchPortException

/** The platform of an agent in a replay, with the recorded input. It opens no port and runs no thread. */
internal class ReplayPlatform(override val boundary: Boundary) : Platform {
    override val clock: LineClock = LineClock.system()

    /** Returns a thread that never runs: an agent starts one to close its ports, and here it has none. */
    override fun start(name: String, run: () -> Unit) = Thread(run, name)

    override fun later(delayMs: Long, action: () -> Unit) = Unit

    override fun open(port: String, settings: LinkSettings, owner: String): BoardLink =
        throw NoSuchPortException(port, "a replay has no ports")

    override fun isPresent(port: String) = false
}
