package argo

import jason.asSyntax.Term
import javino.PortException
import javino.Transports
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The ports that one agent holds open, and the one it uses now.
 *
 * Links stay open until [closeAll], since opening a port resets most boards. What a driver may take its time for, opening and
 * closing, is done by a thread of this class's own. Safe for use by several threads.
 *
 * @param owner the agent's name: what a second agent is told that asks for the same port
 * @param paced whether messages are written at the pace of the line, see [javino.LinkSettings.paced]
 * @param platform opens the ports
 * @param settle is called after each change of the port in use
 */
internal class Ports(
    private val owner: String,
    private val states: PortStates,
    private val listener: SensingListener,
    private val paced: Boolean,
    private val platform: Platform,
    private val settle: () -> Unit,
) {
    private val lock = ReentrantLock()
    private val open = LinkedHashMap<String, OpenPort>()
    private val lastOptions = HashMap<String, PortOptions>()
    private var stopped = false

    private val opener = SerialWork(platform, "argo-$owner-opening")

    /** The port for sensing and acting, or null. */
    @Volatile
    var current: OpenPort? = null
        private set

    /** All open ports. */
    fun all(): List<OpenPort> = lock.withLock { open.values.toList() }

    /**
     * Makes the port [name] the one in use, and opens it if it is not open yet, on another thread.
     *
     * @param term the port as the agent calls it
     * @param options how to use it, or null for what the agent said of it last
     * @param outcome is called once by another thread, with null or with why the port in use is still the one before; never once
     * the agent is being stopped
     */
    fun choose(term: Term, name: String, options: PortOptions?, outcome: (Failure?) -> Unit) {
        later { outcome(tryToChoose(term, name, options)) }
    }

    private fun tryToChoose(term: Term, name: String, options: PortOptions?): Failure? = try {
        val key = Transports.canonicalName(name)
        val wanted = options ?: lastOptions[key] ?: PortOptions()
        val port = reusable(key, wanted) ?: openNew(key, name, term, wanted)
        lastOptions[key] = wanted
        port.isCalled(term)
        current = port
        report(port, PortStatus.ON)
        settle()
        null
    } catch (refused: ArgumentException) {
        Failure("too_many_ports", refused.message.orEmpty())
    } catch (trouble: Exception) { // a plan that waits for its port must go on, whatever a transport throws
        notOpened(term, trouble)
    } catch (unloadable: LinkageError) { // the driver's native library
        notOpened(term, unloadable)
    }

    private fun notOpened(term: Term, trouble: Throwable): Failure =
        failureOf(trouble).also { states.set(term, PortStatus.OFF, it.cause) }

    /** The port if it is open and used as [wanted]; closed if it is open and used otherwise. */
    private fun reusable(key: String, wanted: PortOptions): OpenPort? {
        val port = lock.withLock { open[key] } ?: return null
        if (port.link.isOpen && port.options == wanted) return port
        forget(port)
        return null
    }

    private fun openNew(key: String, name: String, term: Term, options: PortOptions): OpenPort {
        if (lock.withLock { open.size } >= MOST_PORTS) {
            throw ArgumentException("an agent holds at most $MOST_PORTS ports; argo.port(none) closes them")
        }
        val port = OpenPort(term, platform.open(name, options.linkSettings(paced), owner), options, owner, listener, platform)
        val tooLate = lock.withLock { stopped.also { if (!it) open[key] = port } }
        if (tooLate) port.close()
        return port
    }

    /** What is known of [port] now; nothing is said of one that has been given up. */
    fun report(port: OpenPort, status: PortStatus, reason: String? = null) =
        port.terms.forEach { states.set(it, status, reason) { lock.withLock { open.containsValue(port) } } }

    /** [port] cannot be used any more, for the reason given; nothing new if it has been given up already. */
    fun lost(port: OpenPort, trouble: PortException) {
        if (forget(port) && !lock.withLock { stopped }) port.terms.forEach { states.set(it, PortStatus.OFF, trouble.message) }
    }

    /** Gives [port] up and returns whether it had still been held. */
    private fun forget(port: OpenPort): Boolean {
        val held = lock.withLock { open.values.remove(port) }
        port.close()
        return held
    }

    /**
     * Closes all ports, on another thread; none is in use afterwards, and nothing is believed of them.
     * @param closed is called by that thread
     */
    fun closeAll(closed: () -> Unit) = later {
        closeNow()
        closed()
    }

    /** Does [work] on the thread for it, unless the agent is being stopped. */
    private fun later(work: () -> Unit) = lock.withLock { if (!stopped) opener.execute(work) }

    private fun closeNow() {
        current = null
        all().forEach(::forget)
        states.clear()
        settle()
    }

    /** [closeAll] for good: what is being opened now is closed at once. May be called twice. */
    fun stop() {
        lock.withLock {
            if (stopped) return
            stopped = true
            opener.clear()
            opener.execute(::closeNow)
        }
    }

    companion object {
        /** The most ports that one agent holds, after the 127 boards that the paper names. */
        const val MOST_PORTS = 127
    }
}
