package argo.testkit

import argo.links.BoardLink
import argo.links.JavinoLink
import argo.platform.Platform
import javino.NoSuchPortException
import javino.link.Link
import javino.link.LinkSettings
import java.util.concurrent.TimeUnit

/** The platform of an agent under test: [time] and simulated boards. A port that the test does not name gets a board when it is opened. */
internal class TestPlatform(private val time: VirtualTime) : Platform {
    private val boards = LinkedHashMap<String, Board>()
    private var unnamed: Board? = null

    override val clock = time
    override val standsStill get() = true

    override fun start(name: String, run: () -> Unit): Thread = time.start(name, run)

    override fun later(delayMs: Long, action: () -> Unit) {
        time.later(TimeUnit.MILLISECONDS.toNanos(delayMs), action)
    }

    override fun open(port: String, settings: LinkSettings, owner: String): BoardLink {
        if (port.isBlank()) throw NoSuchPortException(port, "a port has a name")
        val board = at(port)
        if (board.isMapped) return board.openMapped(port, settings.paced())
        return JavinoLink(Link.over(board.open(port, settings.line()), settings, time))
    }

    override fun isPresent(port: String) = at(port).isPresent

    fun at(port: String): Board = boards.getOrPut(port) { unnamed?.also { unnamed = null } ?: Board(time) }

    /** Returns the board of the first port. If there is no port yet, this will be the board of the first port that the agent opens. */
    fun first(): Board = boards.values.firstOrNull() ?: unnamed ?: Board(time).also { unnamed = it }

    fun named(): Map<String, Board> = boards

    fun all(): Collection<Board> = boards.values + listOfNotNull(unnamed)
}
