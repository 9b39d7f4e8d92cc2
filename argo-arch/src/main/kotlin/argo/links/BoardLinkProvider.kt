package argo.links

import javino.LineClock
import javino.PortException
import javino.Services
import java.lang.ref.SoftReference
import java.nio.file.Path
import java.util.WeakHashMap

/**
 * Opens boards that are not on a line. [java.util.ServiceLoader] finds the provider. The provider's class has a public constructor without
 * arguments, and is named in `META-INF/services/argo.links.BoardLinkProvider`. One object opens all boards of its scheme. For boards on
 * lines see [javino.TransportProvider].
 *
 * Any thread may call the functions. Unlike a line, a board may be opened by several agents at once.
 */
interface BoardLinkProvider {
    /** The scheme of the provider's ports, without the colon, such as `ros`. */
    val scheme: String

    /**
     * Returns true if this provider opens [port]. By default, it opens ports that begin with [scheme]. If a transport also has this scheme,
     * override this function to distinguish their ports.
     */
    fun opens(port: String): Boolean = port.startsWith("$scheme:")

    /**
     * Opens the board that [port] names. Opening may take seconds. An interrupt of the thread ends it.
     *
     * @param isPaced see [BoardLink.isPaced]
     * @param clock the clock for messages and waits
     * @throws PortException if the board cannot be opened; the exception's class says why
     */
    @Throws(PortException::class)
    fun open(port: String, isPaced: Boolean, clock: LineClock): BoardLink

    /**
     * Opens a board that a test plays in place of the board at [port]. Returns null if no test can play boards of this scheme.
     *
     * @param recording a file with recorded messages, which the board sends at their times; if null, only [PlayedBoard.says] sends messages
     * @param heard receives each message to the board, with its destination, such as the topic of a robot
     * @throws PortException like [open], except for a failed connection, since none is made
     */
    @Throws(PortException::class)
    fun play(
        port: String,
        isPaced: Boolean,
        clock: LineClock,
        recording: Path?,
        heard: (name: String, message: String) -> Unit,
    ): PlayedBoard? = null

    /** Returns true if [open] may succeed. Called repeatedly for a board that has gone, so this function must be fast. */
    fun isPresent(port: String): Boolean = true

    companion object {
        /** The providers by class loader. The references are soft, since a provider refers to its class loader and would keep it alive. */
        private val known = WeakHashMap<ClassLoader, SoftReference<List<BoardLinkProvider>>>()

        /** Returns the provider for [port]; null if the port is on a line, or of no known kind. */
        fun of(port: String): BoardLinkProvider? = if (':' in port) all().find { it.opens(port) } else null

        private fun all(): List<BoardLinkProvider> {
            val loader = Thread.currentThread().contextClassLoader ?: ClassLoader.getSystemClassLoader()
            synchronized(known) { known[loader]?.get() }?.let { return it }
            val found = Services.providers(BoardLinkProvider::class.java).mapNotNull { Services.make(it) }.distinctBy { it.javaClass }
            return synchronized(known) { known[loader]?.get() ?: found.also { known[loader] = SoftReference(it) } }
        }
    }
}

/** A board that a test plays. [link] is the agent's end of the connection. */
abstract class PlayedBoard(val link: BoardLink) {
    /**
     * Sends [message] as the board, from its source [name], such as the topic of a robot.
     *
     * @throws IllegalArgumentException if [message] is malformed
     */
    abstract fun says(name: String, message: String)

    /** Ends the connection from the board's side. Later calls on [link] fail. */
    abstract fun goes()
}
