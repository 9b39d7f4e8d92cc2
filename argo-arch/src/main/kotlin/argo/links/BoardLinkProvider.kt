package argo.links

import javino.LineClock
import javino.PortException
import javino.Services
import java.lang.ref.SoftReference
import java.nio.file.Path
import java.util.WeakHashMap

/**
 * Opens boards that are not on a line. [java.util.ServiceLoader] finds it: a class with a public constructor without arguments, named in
 * `META-INF/services/argo.links.BoardLinkProvider`. One object opens all boards of its scheme. Boards on lines have
 * [javino.TransportProvider].
 *
 * Any thread may call. Unlike a line, a board may be opened by several agents at once.
 */
interface BoardLinkProvider {
    /** The scheme of the provider's ports, without the colon, such as `ros`. */
    val scheme: String

    /**
     * Returns true if [port] is the provider's, judged by its [scheme]. The scheme must not be a transport's, unless this function tells
     * the two apart.
     */
    fun opens(port: String): Boolean = port.startsWith("$scheme:")

    /**
     * Opens the board that [port] names. Opening may take its time; an interrupt of the thread ends it.
     *
     * @param isPaced see [BoardLink.isPaced]
     * @param clock the clock for messages and waits
     * @throws PortException if the board cannot be opened; its class is the reason
     */
    @Throws(PortException::class)
    fun open(port: String, isPaced: Boolean, clock: LineClock): BoardLink

    /**
     * Opens the board at [port], with a test in the board's place; null: no test can play boards of this scheme.
     *
     * @param recording a file with the board's messages, which come at their times; null: only [PlayedBoard.says] sends messages
     * @param heard takes the messages to the board, each with its destination, such as the topic of a robot
     * @throws PortException like [open], but never for a failed connection: no connection is made
     */
    @Throws(PortException::class)
    fun play(
        port: String,
        isPaced: Boolean,
        clock: LineClock,
        recording: Path?,
        heard: (name: String, message: String) -> Unit,
    ): PlayedBoard? = null

    /** Returns true if [open] is worth trying. Called repeatedly for a board that has gone, so it must be cheap. */
    fun isPresent(port: String): Boolean = true

    companion object {
        /** The providers by class loader. The references are soft, since a provider would keep its class loader alive. */
        private val known = WeakHashMap<ClassLoader, SoftReference<List<BoardLinkProvider>>>()

        /** Returns the provider for [port]; null: the port is on a line, or of no known kind. */
        fun of(port: String): BoardLinkProvider? = if (':' in port) all().find { it.opens(port) } else null

        private fun all(): List<BoardLinkProvider> {
            val loader = Thread.currentThread().contextClassLoader ?: ClassLoader.getSystemClassLoader()
            synchronized(known) { known[loader]?.get() }?.let { return it }
            val found = Services.providers(BoardLinkProvider::class.java).mapNotNull { Services.make(it) }.distinctBy { it.javaClass }
            return synchronized(known) { known[loader]?.get() ?: found.also { known[loader] = SoftReference(it) } }
        }
    }
}

/** A board that a test plays, with the agent's end of its [link]. */
abstract class PlayedBoard(val link: BoardLink) {
    /**
     * Sends [message] as the board, from its source [name], such as the topic of a robot.
     *
     * @throws IllegalArgumentException if [message] is malformed
     */
    abstract fun says(name: String, message: String)

    /** Ends the connection from the far end: afterwards [link] fails. */
    abstract fun goes()
}
