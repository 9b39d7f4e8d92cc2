package argo.connecting

import argo.calls.Failure
import argo.calls.failureOf
import argo.platform.Platform
import argo.platform.SequentialExecutor
import argo.platform.forEachAtOnce
import jason.asSyntax.Term
import javino.PortException
import javino.Transports
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The ports that one agent holds open, and the ports in use.
 *
 * Links stay open until [closeAll], since opening a port resets most boards. When the device of a lost port returns, the port is opened
 * again with its options. While the device is missing, every call on the port fails.
 *
 * Opening and closing may block, so a sequential executor carries out the agent's requests. The ports of one request are opened in
 * parallel. Each lost port has its own thread. Safe for use by several threads.
 *
 * @param owner the agent's name, for the error when another agent asks for one of its ports
 * @param paced whether messages are written at the pace of the line, see [javino.link.LinkSettings.paced]
 * @param platform opens ports, and schedules the search for lost ones
 * @param warn receives warnings that the states of ports do not show, such as why a returned device cannot be opened
 */
internal class Ports(
    private val owner: String,
    private val states: PortStates,
    private val user: PortUser,
    private val paced: Boolean,
    private val platform: Platform,
    private val warn: (String) -> Unit,
) {
    private val lock = ReentrantLock()
    private val open = LinkedHashMap<String, OpenPort>()
    private val lost = LostPorts(owner, platform, ::reopen, warn)
    private val lastOptions = ConcurrentHashMap<String, PortOptions>() // by the port's name
    private var opening = 0
    private var stopped = false

    private val choosing = ReentrantLock() // held by a thread that changes the ports in use
    private val openings = PortOpenings(platform)
    private val opener = SequentialExecutor(platform, "argo-$owner-opening")

    @Volatile
    var inUse: List<PortInUse> = emptyList()
        private set

    val current: OpenPort? get() = inUse.firstOrNull()?.port

    private val choices = AtomicInteger()

    /** How many calls have chosen or closed ports so far. */
    val choicesSoFar: Int get() = choices.get()

    fun all(): List<OpenPort> = lock.withLock { open.values.toList() }

    /**
     * Puts the port [name] in use, on another thread. Opens the port if necessary.
     *
     * @param term the port as the agent calls it
     * @param options the options of the port; null for the options that the agent gave last
     * @param outcome called once by another thread, with null or with the reason why the port cannot be used. Not called if the agent is
     * being stopped
     */
    fun choose(term: Term, name: String, options: PortOptions?, outcome: (Failure?) -> Unit) =
        inTurn { outcome(tryToChoose(term, name, options)) }

    /**
     * Puts the ports [wanted] in use, in their order. Opens the closed ones in parallel. Each port is in use as soon as it is open. When
     * the first wanted port is in use, all ports that are not wanted leave use. If a port in use is wanted but cannot be opened, it stays
     * in use, and the search for it continues.
     *
     * @param outcome called once by another thread when each port is open or has failed. Its argument is null, or the reason why some ports
     * are not open. Not called if the agent is being stopped
     */
    fun chooseAll(wanted: List<WantedPort>, outcome: (Failure?) -> Unit) = inTurn { outcome(tryToChooseAll(wanted)) }

    private fun tryToChoose(term: Term, name: String, options: PortOptions?): Failure? =
        tryToUse(WantedPort(term, name, options)) { port -> inUse = listOf(PortInUse(term, port)) }

    private fun tryToChooseAll(asked: List<WantedPort>): Failure? {
        val devices = asked.groupBy { one -> runCatching { Transports.canonicalName(one.name) }.getOrDefault(one.name) }.values
        devices.filter { it.size > 1 }.forEach { same ->
            warn("the ports ${same.joinToString(" and ") { "${it.term}" }} are one device, which is used as ${same.first().term}")
        }
        val wanted = devices.map { it.first() }
        val opened = HashMap<WantedPort, OpenPort>() // guarded by choosing
        val failures = ConcurrentHashMap<WantedPort, Failure>()
        platform.forEachAtOnce(wanted, { "argo-$owner-opening-${it.name}" }) { one ->
            val failure = tryToUse(one) { port ->
                opened[one] = port
                inUse = wanted.mapNotNull { other ->
                    opened[other]?.let { PortInUse(other.term, it) } ?: inUse.find { it.term == other.term }
                }
            }
            if (failure != null) failures[one] = failure
        }
        return asOne(wanted.mapNotNull { one -> failures[one]?.let { one to it } }, wanted.size)
    }

    /** Combines the failures of some of the [wanted] ports into one failure; null if no port failed. */
    private fun asOne(failed: List<Pair<WantedPort, Failure>>, wanted: Int): Failure? = when (failed.size) {
        0 -> null
        1 -> failed.single().second
        else -> Failure(
            failed.first().second.error,
            "${failed.size} of $wanted ports cannot be used: " +
                failed.joinToString("; ") { (port, failure) -> "${port.term}: ${failure.cause}" },
        )
    }

    /** Opens [wanted], and calls [use], with [choosing] held, to put it in use. Returns the reason if the port cannot be opened. */
    private fun tryToUse(wanted: WantedPort, use: (OpenPort) -> Unit): Failure? {
        val trouble = troubleOf {
            val key = Transports.canonicalName(wanted.name)
            openings.atOnce(key) { openAndUse(wanted, key, use) }
        }
        if (trouble is TooManyPortsException) return Failure("too_many_ports", trouble.message.orEmpty())
        return trouble?.let(::failureOf)?.also { failure ->
            val isOpen = all().any { it.link.isOpen && wanted.term in it.names }
            if (!isOpen) states.set(wanted.term, PortStatus.OFF, failure.cause) { lock.withLock { !stopped } }
        }
    }

    private fun openAndUse(wanted: WantedPort, key: String, use: (OpenPort) -> Unit) {
        val (term, name, asked) = wanted
        val held = lock.withLock { open[key] }
        val options = (asked ?: held?.options ?: lastOptions[name] ?: PortOptions()).on(name)
        val port = held?.takeIf { it.link.isOpen && it.options.openAs(options) } ?: openOtherwise(held, key, name, term, options)
        lastOptions[name] = options
        choosing.withLock {
            port.renamed(options.namespace)
            use(port)
            noteReturn(port, term, name)
            user.portInUseChanged()
        }
    }

    /** Opens the port of [held] with the options [wanted]. If the opening fails, opens the port with the options of [held] again. */
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
            val again = openNew(key, port.link.port, port.options, port.names)
            choosing.withLock {
                replaceInUse(again) { it.port === port }
            }
        }
        if (trouble != null) lose(port, trouble)
    }

    /** @param before the lost port that this opening replaces; null if there is none */
    private fun openNew(key: String, name: String, options: PortOptions, names: Map<Term, String>, before: LostPort? = null): OpenPort {
        val isFull = lock.withLock { (open.size + opening >= MAX_PORTS).also { if (!it) opening++ } }
        if (isFull) throw TooManyPortsException("an agent holds at most $MAX_PORTS ports; argo.port(none) closes them")
        var opened: OpenPort? = null
        val tooLate: Boolean
        try {
            lost.close(key)
            val link = platform.open(name, options.linkSettings(paced), owner)
            opened = OpenPort(names, link, options, platform.clock.nanos(), before?.losses ?: 0, user::use)
        } finally {
            tooLate = lock.withLock {
                opening--
                stopped.also { isStopped -> opened?.takeUnless { isStopped }?.let { open[key] = it } }
            }
        }
        val port = checkNotNull(opened)
        if (tooLate) port.close() else user.opened(port)
        return port
    }

    /** Notes that [port] can be used under the name [term]. If there are too many ports, gives up the ports that were lost first. */
    private fun noteReturn(port: OpenPort, term: Term, name: String) {
        port.addName(term, name)
        lost.removeOthers(term, port)
        lost.keep(MAX_PORTS - all().size)
        report(port, PortStatus.ON)
    }

    /** Sets the state of [port] under each of its names. Does nothing if the agent no longer holds the port. */
    fun report(port: OpenPort, status: PortStatus, reason: String? = null) =
        port.names.keys.forEach { states.set(it, status, reason) { lock.withLock { open.containsValue(port) } } }

    /**
     * Notes that the device of [port] has gone, as [trouble] shows, and searches for the device. Does nothing if the loss is already noted.
     * Never waits for the driver, since another thread closes the port.
     */
    fun lost(port: OpenPort, trouble: PortException) = lose(port, trouble) { open.values.remove(port) }

    /**
     * Closes [port] and searches for its device under each of the port's names. Calls [isNews] with the lock held. If [isNews] returns
     * false, does nothing.
     */
    private fun lose(port: OpenPort, trouble: Throwable, isNews: () -> Boolean = { true }) {
        val ports = port.names.map { (term, name) -> LostPort(port, term, name, platform.clock.nanos()) }
        lock.withLock {
            if (stopped || !isNews()) return
            lost.add(ports)
        }
        val reason = "${trouble.message}; it is opened again when its device is back"
        ports.forEach { states.set(it.term, PortStatus.OFF, reason) { it in lost } }
        ports.forEach(lost::lookFor)
    }

    /** Opens [found] with its options, on its searching thread. The device may already be open under another name. */
    private fun reopen(found: LostPort) {
        val key = Transports.canonicalName(found.name)
        openings.ifFree(key) {
            val held = lock.withLock { open[key] }?.takeIf { it.link.isOpen }
            val port = held ?: openNew(key, found.name, found.port.options, mapOf(found.term to found.name), found)
            val isWanted = choosing.withLock { (found in lost).also { if (it) putBack(found, port) } }
            if (!isWanted && held == null) forget(port)
        }
    }

    private fun putBack(found: LostPort, port: OpenPort) {
        replaceInUse(port) { it.port === found.port && it.term == found.term }
        noteReturn(port, found.term, found.name)
    }

    /** Puts [port] in use in place of the [old] ports. Called with [choosing] held. */
    private fun replaceInUse(port: OpenPort, old: (PortInUse) -> Boolean) {
        if (inUse.none(old)) return
        inUse = inUse.map { if (old(it)) it.copy(port = port) else it }
        user.portInUseChanged()
    }

    private fun forget(port: OpenPort) {
        lock.withLock { open.values.remove(port) }
        port.close()
    }

    /**
     * Closes all ports on another thread, which finally calls [closed]. Afterwards no port is in use, ARGO searches for no port, and no
     * belief about a port remains.
     */
    fun closeAll(closed: () -> Unit) = inTurn {
        closeNow()
        closed()
    }

    private fun inTurn(work: () -> Unit) {
        choices.incrementAndGet()
        lock.withLock { if (!stopped) opener.execute(work) }
    }

    private fun closeNow() {
        lost.clear()
        openings.interrupt()
        val ports = choosing.withLock {
            inUse = emptyList()
            states.clear()
            user.portInUseChanged()
            lock.withLock {
                lost.clear() // a port may have been lost after the first clear
                open.values.toList().also { open.clear() }
            }
        }
        ports.forEach { it.link.leave() }
        ports.forEach(OpenPort::close)
        lost.closeAll()
    }

    /**
     * Closes all ports for good, even ports that are still being opened. Another agent that asks for one of these ports waits until it is
     * closed. Further calls have no effect.
     */
    fun stop() {
        lock.withLock {
            if (stopped) return
            stopped = true
            open.values.forEach { it.link.leave() } // another agent may ask for these ports at once
            openings.interrupt()
            opener.clear()
            opener.execute(::closeNow)
        }
    }

    companion object {
        /** The largest number of ports of one agent. The ARGO paper names 127 boards. */
        const val MAX_PORTS = 127
    }
}

/**
 * A port that an agent asks for.
 *
 * @property term the port as the agent calls it
 * @property name the name by which the transport opens the port
 * @property options the port's options; null for the options that the agent gave last
 */
internal data class WantedPort(val term: Term, val name: String, val options: PortOptions?)

internal data class PortInUse(val term: Term, val port: OpenPort)

private class TooManyPortsException(message: String) : Exception(message)
