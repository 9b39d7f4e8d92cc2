package argo.recording.replay

import argo.boundary.Boundary
import argo.links.BoardLink
import argo.platform.Platform
import javino.LineClock
import javino.LinkSettings
import javino.NoSuchPortException

/** What an agent of a replay runs on: what was recorded. It opens no port and runs no thread. */
internal class ReplayPlatform(override val boundary: Boundary) : Platform {
    override val clock: LineClock = LineClock.system()

    /** The thread never runs: an agent without ports starts one to close them. */
    override fun start(name: String, run: () -> Unit) = Thread(run, name)

    override fun later(delayMs: Long, action: () -> Unit) = Unit

    override fun open(port: String, settings: LinkSettings, owner: String): BoardLink =
        throw NoSuchPortException(port, "a replay has no ports")

    override fun isPresent(port: String) = false
}
