package argo.ports

import argo.calls.Failure
import argo.calls.failureOf
import argo.platform.Platform
import argo.platform.SequentialExecutor
import argo.sensing.SensingListener
import jason.asSyntax.Term
import javino.Link
import javino.PortException
import javino.Transports
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The ports that one agent holds open, and the one it uses now.
 *
 * Links stay open until [closeAll], since opening a port resets most boards. One whose device goes is opened again, as it was, when its device
 * returns; until then it is looked for, and what is done with it fails. What a driver may take its time for, opening and
 * closing, is done by threads of this class's own: one for what the agent asks for, in its order, and one for each port that is looked for.
 * Safe for use by several threads.
 *
 * @param owner the agent's name: what a second agent is told that asks for the same port
 * @param paced whether messages are written at the pace of the line, see [javino.LinkSettings.paced]
 * @param platform opens the ports, and says when to look for lost ones
 * @param settle is called after each change of the port in use
 * @param warn is told why a port cannot be opened though its device has returned, once for each cause
 */
internal class Ports(
    private val owner: String,
    private val states: PortStates,
    private val listener: SensingListener,
    private val paced: Boolean,
    private val platform: Platform,
    private val settle: () -> Unit,
    private val warn: (String) -> Unit,
) {
    private val lock = ReentrantLock()
    private val open = LinkedHashMap<String, OpenPort>()
    private val lost = LostPorts(owner, platform, ::reopen, warn)
    private val lastOptions = HashMap<String, PortOptions>() // by name; for the thread that opens
    private var stopped = false

    private val choosing = ReentrantLock() // held while the port in use changes
    private val openings = PortOpenings(platform)
    private val opener = SequentialExecutor(platform, "argo-$owner-opening")

    /** The port for sensing and acting, or null. */
    @Volatile
    var current: OpenPort? = null
        private set

    /** What the agent called it when it chose it; guarded by [choosing]. */
    private var chosen: Term? = null

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
    fun choose(term: Term, name: String, options: PortOptions?, outcome: (Failure?) -> Unit) =
        inTurn { outcome(tryToChoose(term, name, options)) }

    private fun tryToChoose(term: Term, name: String, options: PortOptions?): Failure? {
        val trouble = troubleOf {
            val key = Transports.canonicalName(name)
            openings.atOnce(key) { openAndChoose(term, name, key, options) }
        }
        if (trouble is ArgumentException) return Failure("too_many_ports", trouble.message.orEmpty())
        return trouble?.let(::failureOf)?.also { failure ->
            if (all().none { it.link.isOpen && term in it.names }) states.set(term, PortStatus.OFF, failure.cause) { lock.withLock { !stopped } }
        }
    }

    private fun openAndChoose(term: Term, name: String, key: String, options: PortOptions?) {
        val held = lock.withLock { open[key] }
        val wanted = (options ?: held?.options ?: lastOptions[name] ?: PortOptions()).on(name)
        val port = held?.takeIf { it.link.isOpen && it.options == wanted } ?: openOtherwise(held, key, name, term, wanted)
        lastOptions[name] = wanted
        choosing.withLock {
            chosen = term
            current = port
            isBack(port, term, name)
            settle()
        }
    }

    /** Opens a port as [wanted], in place of what is [held] of it; if it cannot be opened so it is held again as it was. */
    private fun openOtherwise(held: OpenPort?, key: String, name: String, term: Term, wanted: PortOptions): OpenPort {
        if (held == null) return openNew(key, name, wanted, mapOf(term to name))
        forget(held)
        var opened: OpenPort? = null
        try {
            return openNew(key, name, wanted, held.names + (term to name)).also { opened = it }
        } finally {
            if (opened == null) holdAgain(held, key)
        }
    }

    private fun holdAgain(port: OpenPort, key: String) {
        val trouble = troubleOf {
            val again = openNew(key, port.link.port(), port.options, port.names)
            choosing.withLock {
                if (current === port) {
                    current = again
                    settle()
                }
            }
        }
        if (trouble != null) lose(port, trouble)
    }

    /** @param before what was lost, if it is opened because of that */
    private fun openNew(key: String, name: String, options: PortOptions, names: Map<Term, String>, before: LostPort? = null): OpenPort {
        if (lock.withLock { open.size } >= MOST_PORTS) {
            throw ArgumentException("an agent holds at most $MOST_PORTS ports; argo.port(none) closes them")
        }
        val link = platform.open(name, options.linkSettings(paced), owner)
        val port = OpenPort(names, link, options, platform.clock.nanos(), before?.losses ?: 0, owner, listener, platform)
        val tooLate = lock.withLock { stopped.also { if (!it) open[key] = port } }
        if (tooLate) port.close() else port.sensing.set(false, 0)
        return port
    }

    /** [port] can be used, and the agent calls it [term]. Who holds too many has those that were lost first looked for no longer. */
    private fun isBack(port: OpenPort, term: Term, name: String) {
        port.isCalled(term, name)
        lost.found(term, port)
        lost.keep(MOST_PORTS - all().size)
        report(port, PortStatus.ON)
    }

    /** What is known of [port] now; nothing is said of one that has been given up. */
    fun report(port: OpenPort, status: PortStatus, reason: String? = null) =
        port.names.keys.forEach { states.set(it, status, reason) { lock.withLock { open.containsValue(port) } } }

    /** [port] cannot be used any more, for the reason given; nothing new if it has been given up already. Its device is looked for. */
    fun lost(port: OpenPort, trouble: PortException) {
        lose(port, trouble) { open.values.remove(port) }
        port.close()
    }

    /** Has the device of [port] looked for under each of its names, if [isNews], which is asked under the lock. */
    private fun lose(port: OpenPort, trouble: Throwable, isNews: () -> Boolean = { true }) {
        val ports = port.names.map { (term, name) -> LostPort(port, term, name, platform.clock.nanos()) }
        lock.withLock {
            if (stopped || !isNews()) return
            lost.add(ports)
        }
        port.close()
        ports.forEach { states.set(it.term, PortStatus.OFF, trouble.message) { it in lost } }
        ports.forEach(lost::lookFor)
    }

    /** Opens [found] as it was; for a thread that looks for it. If it has another name that has been found, it is open already. */
    private fun reopen(found: LostPort) {
        val key = Transports.canonicalName(found.name)
        openings.ifFree(key) {
            val held = lock.withLock { open[key] }?.takeIf { it.link.isOpen }
            val port = held ?: openNew(key, found.name, found.port.options, mapOf(found.term to found.name), found)
            choosing.withLock { if (found in lost) isFound(found, port) else if (held == null) forget(port) }
        }
    }

    private fun isFound(found: LostPort, port: OpenPort) {
        val inUse = current === found.port && chosen == found.term
        if (inUse) current = port
        isBack(port, found.term, found.name)
        if (inUse) settle()
    }

    private fun forget(port: OpenPort) {
        lock.withLock { open.values.remove(port) }
        port.close()
    }

    /**
     * Closes all ports, on another thread; none is in use afterwards, none is looked for, and nothing is believed of them.
     * @param closed is called by that thread
     */
    fun closeAll(closed: () -> Unit) = inTurn {
        closeNow()
        closed()
    }

    /** Does [work] on the thread for it, unless the agent is being stopped. */
    private fun inTurn(work: () -> Unit) = lock.withLock { if (!stopped) opener.execute(work) }

    private fun closeNow() {
        lost.clear()
        openings.interrupt()
        choosing.withLock {
            current = null
            chosen = null
            all().forEach(::forget)
            states.clear()
            settle()
        }
    }

    /** [closeAll] for good: what is being opened now is closed at once. May be called twice. */
    fun stop() {
        lock.withLock {
            if (stopped) return
            stopped = true
            openings.interrupt()
            opener.clear()
            opener.execute(::closeNow)
        }
    }

    companion object {
        /** The most ports that one agent holds, after the 127 boards that the paper names. */
        const val MOST_PORTS = 127
    }
}
