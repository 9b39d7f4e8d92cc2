package argo.links

import javino.LineClock
import javino.PortException
import javino.Services
import java.lang.ref.SoftReference
import java.util.WeakHashMap

/**
 * Opens boards that are reached otherwise than by bytes on a line. Found by [java.util.ServiceLoader]: a class with a public constructor
 * without arguments, named in `META-INF/services/argo.links.BoardLinkProvider`. One object opens all boards of its scheme. Boards on lines
 * come by [javino.TransportProvider].
 *
 * Called by any thread. Unlike a line, what it opens may be opened by several agents at once.
 */
interface BoardLinkProvider {
    /** What its ports begin with, without the colon: `ros`; no scheme of a transport. */
    val scheme: String

    /**
     * Opens the board that [port] names, which may take its time, but ends when the thread is interrupted.
     *
     * @param isPaced see [BoardLink.isPaced]
     * @param clock the time of the messages, and of waits
     * @throws PortException of the kind that says why it cannot be opened
     */
    @Throws(PortException::class)
    fun open(port: String, isPaced: Boolean, clock: LineClock): BoardLink

    /**
     * Opens a board called [port] that a test plays, with nothing behind it; null: boards of this scheme cannot be played so.
     *
     * @param heard takes what the board is sent, and the name of what takes it there, as the topic of a robot
     * @throws PortException as [open], for what is not about a connection
     */
    @Throws(PortException::class)
    fun play(port: String, isPaced: Boolean, clock: LineClock, heard: (name: String, message: String) -> Unit): PlayedBoard? = null

    /** Whether [open] is worth trying; asked again and again for a board that has gone, so it is cheap. */
    fun isPresent(port: String): Boolean = true

    companion object {
        /** Those that a thread with this class loader sees. They refer to their class loader, which they must not keep alive. */
        private val known = WeakHashMap<ClassLoader, SoftReference<List<BoardLinkProvider>>>()

        /** The provider for [port]; null: it is on a line, or of no known kind. */
        fun of(port: String): BoardLinkProvider? {
            val scheme = port.substringBefore(':', "").takeIf { it.isNotEmpty() } ?: return null
            return all().find { it.scheme == scheme }
        }

        private fun all(): List<BoardLinkProvider> {
            val loader = Thread.currentThread().contextClassLoader ?: ClassLoader.getSystemClassLoader()
            synchronized(known) { known[loader]?.get() }?.let { return it }
            val found = Services.providers(BoardLinkProvider::class.java).mapNotNull { Services.make(it) }.distinctBy { it.javaClass }
            return synchronized(known) { known[loader]?.get() ?: found.also { known[loader] = SoftReference(it) } }
        }
    }
}

/**
 * A board that a test plays.
 *
 * @property link what the agent has of it
 */
abstract class PlayedBoard(val link: BoardLink) {
    /**
     * The board sends [message] from its source [name], as the topic of a robot.
     *
     * @throws IllegalArgumentException if it is no message
     */
    abstract fun says(name: String, message: String)

    /** The far end goes: [link] fails from now on. */
    abstract fun goes()
}
