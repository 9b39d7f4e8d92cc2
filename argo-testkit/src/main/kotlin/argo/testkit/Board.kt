package argo.testkit

import argo.filters.matching.perceptsOf
import argo.links.BoardLink
import argo.links.BoardLinkProvider
import argo.links.PlayedBoard
import argo.perception.whyLeftOut
import javino.Frame
import javino.LineClock
import javino.LineSettings
import javino.NoSuchPortException
import javino.PerceptsRequest
import javino.PortBusyException
import javino.PortException
import javino.PortGoneException
import javino.PortInterruptedException
import javino.PortPermissionException
import javino.Transport
import javino.sim.FakeBoard
import javino.sim.LineRecording
import javino.sim.MemoryLine
import javino.sim.ReplayBoard
import javino.wire.WireFrame
import java.nio.file.Path
import kotlin.time.Duration
import kotlin.time.Duration.Companion.nanoseconds

/**
 * The board on a port of an agent under test. It answers each request for percepts with the values that its sensors [show][shows], and
 * takes every other message as a command. It speaks version 1 of the protocol unless [version2] is called.
 *
 * Its line carries bytes at the baud rate that the agent opens the port with, in virtual time. Each function is a sentence whose subject is
 * the board, and takes effect at once; the agent reacts to it when time advances.
 */
class Board internal constructor(private val time: VirtualTime) {
    private val fake = FakeBoard.unplugged("board", time)
    private var isConnected = true
    private var openingNanos = 0L
    private var refusal: ((String) -> PortException)? = null
    private var elsewhere: ((String, LineSettings, LineClock) -> Transport)? = null
    private var line: MemoryLine? = null
    private var played: PlayedBoard? = null
    private val taking = ArrayList<String>()
    private val threads = ArrayList<Thread>()
    private var answer: (Set<String>) -> String? = { "" }

    /** The number of requests for percepts that it has answered since [shows] or [showsRaw] was called last. */
    internal var answers = 0
        private set

    /** The percepts that its sensors showed last; null: none yet, or it ignores requests, or its port leads elsewhere. */
    internal var shown: List<String>? = null
        private set

    private var isVersion2 = false
    private var program = fake.program()
    private val replayed = ArrayList<Arrival>()
    private val taken = HashSet<Int>()
    private val requestRules = listOf(
        fake.whenAsked(PerceptsRequest.ALL).answer(::percepts) { answer(emptySet()) },
        fake.whenAsked(PerceptsRequest::isIn).answer(::percepts),
    )
    private var bootMs = 0

    /** True if its program is to begin anew on its line. */
    @Volatile
    private var isToRestart = false

    /** True if it answers no requests for percepts now, whatever its sensors show. */
    internal var isSilent = false

    /** One in this many bytes on its line arrives with a wrong bit, in each direction; 0: none does. */
    internal var garbledOneIn = 0

    /**
     * Its sensors show [percepts] from now on, each as text, `dist(front,30)`; without percepts it answers with an empty message.
     * @throws IllegalArgumentException if an agent would leave out one of them, as `dist(front`: see [showsRaw]
     */
    fun shows(vararg percepts: String): Board = apply {
        messageOf(percepts.toList())
        shows { percepts.toList() }
        shown = percepts.toList()
    }

    /**
     * Its sensors show the percepts that [sensors] returns, from now on. The board's thread calls [sensors] for each request, with the time
     * since the test began: a robot that drives at 10 cm/s towards a wall,
     * `shows { listOf("dist(front,${90 - it.inWholeMilliseconds / 100})") }`. Percepts that an agent would leave out fail the test.
     */
    fun shows(sensors: (Duration) -> List<String>): Board = answers { functors ->
        val percepts = sensors(now).also { shown = it }
        messageOf(percepts.filter { functors.isEmpty() || functorOf(it) in functors })
    }

    /** It answers requests for percepts from now on with exactly [message], even one that no sensor should send: `dist(front;)(;`. */
    fun showsRaw(message: String): Board = apply {
        sendable(message)
        showsRaw { message }
        shown = perceptsOf(message)
    }

    /**
     * It answers requests for percepts from now on with the message that [message] returns; [message] is called as the argument of [shows]
     * is.
     */
    fun showsRaw(message: (Duration) -> String): Board = answers {
        sendable(message(now)).also { shown = perceptsOf(it) }
    }

    /**
     * It answers no request for percepts from now on, until [shows] is called, though it takes commands.
     * The agent believes `port(P,timeout)`.
     */
    fun ignoresRequests(): Board = apply {
        answer = { null }
        shown = null
    }

    /**
     * It sends [percepts] unasked, now, as a board does if its port is opened with `mode(listen)`.
     * @throws IllegalArgumentException if an agent would leave out one of them
     */
    fun says(vararg percepts: String): Board = apply {
        fake.send(messageOf(percepts.toList()))
        shown = percepts.toList()
    }

    /** It puts [bytes] on the line as they are, now: noise, half a message. A character is a byte. */
    fun disturbs(bytes: String): Board = apply { fake.noise(*bytesOf(bytes)) }

    internal fun disturbs(frame: WireFrame): Board = apply { fake.noise(frame) }

    /**
     * When its port is opened next, it begins to send the bytes of the board in [recording], at the times of the recording; it takes any
     * command. Its other settings have no effect then, except for those of its port.
     * @throws IllegalArgumentException if the board sends nothing in the recording
     */
    fun replays(recording: LineRecording): Board = apply {
        program = ReplayBoard.of(recording, time).tellingCommandsTo { replayed += Arrival(it, now) }
    }

    /** It [replays] the recording in [file], as `monitor --record` of ARGO's tools writes it. */
    fun replays(file: Path): Board = replays(LineRecording.read(file))

    /**
     * When its port is opened next, it leads to the line that [open] opens, such as one of a simulator that runs a sketch. [open] gets the
     * port's name and settings, and the line's clock. Then expectations of commands have no effect, nor do the board's other settings,
     * except for those of its port.
     */
    fun leadsTo(open: (String, LineSettings, LineClock) -> Transport): Board = apply { elsewhere = open }

    /**
     * Its port is not a line but the robot that the port's name addresses, as `ros://robot:9090`, whose topics a mapping turns into
     * percepts. The mapping and all of ARGO's side are real, and there is no robot behind them: the test [publishes] its messages, and each
     * command is done at once. The board's other settings have no effect then, except for those of its port. To be called before the port
     * is opened.
     */
    fun playsItsMapping(): Board = apply { isMapped = true }

    /**
     * It publishes [message], in JSON, on [topic], if its port is open and the agent wants that topic. If [topic] is a service or an
     * action of the mapping, [message] is its response to all further commands. For a board that [plays its mapping][playsItsMapping].
     * @throws IllegalArgumentException if [message] is no object of JSON
     * @throws IllegalStateException if the board is not mapped
     */
    fun publishes(topic: String, message: String): Board = apply {
        check(isMapped) { "a board on a line has no topics: call playsItsMapping() before its port is opened" }
        played?.says(topic, message)
    }

    /** The messages, requests and goals to the robot, each with its topic, service or action: `/cmd_vel {"linear":{"x":0.3}}`. */
    val published: List<String> get() = taking

    /** It speaks version 2 of the protocol with agents that do; to be called before the port is opened. */
    fun version2(): Board = apply {
        isVersion2 = true
        fake.version2()
    }

    /**
     * It tells agents that speak version 2 that it has only these [actions]: `ledOn`, `speed/1` with an argument, `say` with a slash and a
     * star behind it for any number of them. Without this it describes no actions, and agents check no command before they send it.
     */
    fun knows(vararg actions: String): Board = apply { fake.knows(*actions) }

    /**
     * It describes its percepts to agents that speak version 2, by these [kinds]: `dist(front|left, cm 0..400)`. Live views show that; an
     * agent believes a percept whatever its description says.
     */
    fun describes(vararg kinds: String): Board = apply { fake.perceives(*kinds) }

    /**
     * It has room for [count] critical rules, which it watches itself: it compares them every 5 ms with the percepts that its sensors
     * [show][shows], and carries out their reflexes, which count as [commands] that arrived. In version 2; to be called before the port is
     * opened.
     */
    fun holdsRules(count: Int): Board = apply { fake.holdsRules(count) }

    /**
     * It refuses [command]: the agent's plan fails with `error(act_refused)`.
     * @throws IllegalStateException if it speaks version 1, in which no board can refuse
     */
    fun refuses(command: String): Board = apply { refusable(fake.whenAsked(command)) }

    /** It refuses every command for which [kind] is true: see the other form. */
    fun refuses(kind: (String) -> Boolean): Board = apply { refusable(fake.whenAsked(kind)) }

    /** It carries [command] out without delay from now on, though it [refuses] it or [takes] time for it so far. */
    fun accepts(command: String): Board = apply { fake.whenAsked(command) }

    /** It needs [duration] to carry out [command], and does nothing else meanwhile. */
    fun takes(duration: Duration, command: String): Board = apply { fake.whenAsked(command).after(millis(duration)) }

    /** It needs [duration] to boot when its port is opened, and loses all bytes that arrive meanwhile. */
    fun boots(duration: Duration): Board = apply {
        bootMs = millis(duration)
        fake.bootTakes(bootMs)
    }

    /** It answers each request for percepts [duration] later than it could, and does nothing else meanwhile. */
    fun answersAfter(duration: Duration): Board = apply { requestRules.forEach { it.after(millis(duration)) } }

    /**
     * It restarts now, as after a reset by its watchdog or a dip of its supply: its port stays open, it forgets the session of version 2,
     * and loses all bytes that arrive within [booting].
     */
    fun restarts(booting: Duration): Board = apply {
        if (!isOpen) return@apply
        recovers()
        fake.bootTakes(millis(booting))
        time.later(nanos(booting)) { fake.bootTakes(bootMs) }
        isToRestart = true
        threads.forEach(Thread::interrupt)
    }

    /** Its port needs [duration] to open, as that of an adapter over Bluetooth does; the agent's `argo.port` waits meanwhile. */
    fun opensAfter(duration: Duration): Board = apply { openingNanos = nanos(duration) }

    /** It hangs: it neither answers nor acts, until [recovers] is called. The agent believes `port(P,timeout)`. */
    fun hangs(): Board = apply { fake.stall() }

    /** It continues where it [hung][hangs]. */
    fun recovers(): Board = apply { fake.resume() }

    /**
     * Its cable is pulled: opening the port fails with `error(no_such_port)` until [reconnects] is called. An agent that has the port open
     * believes `port(P,off)`. The board loses power: afterwards it no longer [hangs].
     */
    fun disconnects(): Board = apply {
        isConnected = false
        line?.unplug()
        played?.goes()
        recovers()
    }

    /** Its cable is plugged in again. */
    fun reconnects(): Board = apply { isConnected = true }

    /** Its port is held by [owner], an agent or a program: opening it fails with `error(port_busy)`, until [admits] is called. */
    fun belongsTo(owner: String): Board = apply { refusal = { PortBusyException(it, owner) } }

    /** The agent has no permission to open its port: that fails with `error(port_permission)`, until [admits] is called. */
    fun deniesAccess(): Board = apply { refusal = { PortPermissionException(it, "this user may not open port $it") } }

    /** Its port is free, and the agent has permission to open it. */
    fun admits(): Board = apply { refusal = null }

    /** True if the agent has its port open. */
    val isOpen: Boolean get() = line?.let { !it.isGone } ?: played?.link?.isOpen ?: false

    /** The messages that have arrived, requests for percepts and commands, in their order. */
    val received: List<String> get() = timed.map { it.command }

    /** The commands that have arrived, in their order. */
    val commands: List<String> get() = received.filterNot(PerceptsRequest::isIn)

    /** Its [commands], each with the time at which it arrived. */
    val arrivals: List<Arrival> get() = timed.filterNot { PerceptsRequest.isIn(it.command) }

    /** The requests for percepts that have arrived, in their order: `getPercepts`, or with functors from an agent that speaks version 2. */
    val requests: List<String> get() = received.filter(PerceptsRequest::isIn)

    private val timed: List<Arrival> get() = fake.receivedMessages().map { Arrival(it.text(), it.nanos().nanoseconds) } + replayed

    private val now: Duration get() = time.nanos().nanoseconds

    /** Its [arrivals], each with true if an expectation has taken it. */
    internal val accounted: List<Pair<Arrival, Boolean>> get() = arrivals.mapIndexed { i, arrival -> arrival to (i in taken) }

    internal val unexpected: List<String> get() = commands.filterIndexed { i, _ -> i !in taken }

    /** Takes [command] if it has arrived at an [acceptable time][isTimely] and no expectation has taken it. */
    internal fun take(command: String, isTimely: (Duration) -> Boolean = { true }): Boolean {
        val index = arrivals.withIndex().firstOrNull { (i, it) -> i !in taken && it.command == command && isTimely(it.at) }?.index
            ?: return false
        return taken.add(index)
    }

    /** True if its port has been opened at least once. */
    internal var wasOpened = false
        private set

    /** True if its port exists. */
    internal val isPresent: Boolean get() = isConnected

    /** True if its port is the robot that the port's name addresses: see [playsItsMapping]. */
    internal var isMapped = false
        private set

    /** Opens its port as the robot that the port's name addresses. */
    internal fun openMapped(port: String, isPaced: Boolean): BoardLink {
        awaitOpening(port)
        val opened = BoardLinkProvider.of(port)?.play(port, isPaced, time) { name, message -> taking += "$name $message" }
            ?: throw NoSuchPortException(port, "port $port has no mapping to play; for ros:// the library argo-ros is needed")
        played = opened
        return NotedLink(opened.link) { replayed += Arrival(it, now) }
    }

    private fun awaitOpening(port: String) {
        if (openingNanos > 0) time.block(time.nanos() + openingNanos, interruptible = false) { false }
        if (!isConnected) throw NoSuchPortException(port, "there is no port $port")
        refusal?.let { throw it(port) }
        wasOpened = true
    }

    internal fun open(port: String, settings: LineSettings): Transport {
        awaitOpening(port)
        elsewhere?.let { return it(port, settings, time) }
        val line = MemoryLine.paced(port, settings, time).also { this.line = it }
        threads.removeAll { !it.isAlive }
        threads += time.start("board $port") { run(line) }
        return GarbledLine(line.computer(), ::garbledOneIn)
    }

    private fun run(line: MemoryLine) {
        do {
            isToRestart = false
            try {
                program.run(line.board())
            } catch (_: PortGoneException) {
                // the agent closed its port, or the cable was pulled
            } catch (_: PortInterruptedException) {
                Thread.interrupted() // it restarts, or the test is over
            } catch (_: InterruptedException) {
                // likewise
            }
        } while (isToRestart)
    }

    internal fun end() {
        recovers()
        line?.unplug()
        threads.forEach(Thread::interrupt) // a replay or a slow command may be under way
    }

    private fun answers(answer: (Set<String>) -> String) = apply {
        this.answer = answer
        answers = 0
        shown = null
    }

    private fun percepts(request: String): String? =
        if (isSilent) null else answer(PerceptsRequest.functorsIn(request))?.also { answers++ }

    private fun messageOf(percepts: List<String>) = percepts.onEach(::requirePercept).joinToString("") { "$it;" }.also(::sendable)

    private fun sendable(message: String) = message.also {
        require(isVersion2 || it.length <= Frame.MAX_PAYLOAD) {
            "a message of version 1 has at most ${Frame.MAX_PAYLOAD} bytes, not ${it.length}; show less, or call version2() first"
        }
        bytesOf(it)
    }

    private fun refusable(rule: FakeBoard.Rule) {
        check(isVersion2) { "a board of version 1 cannot refuse a command; call version2() before refuses(…)" }
        rule.refuse()
    }

    private fun bytesOf(text: String): ByteArray {
        require(text.all { it.code <= HIGHEST_BYTE }) { "a message carries one byte per character, and \"$text\" holds others" }
        return text.toByteArray(Charsets.ISO_8859_1)
    }
}

private const val HIGHEST_BYTE = 0xFF

/** Refuses a misspelt percept, which would let each later `shouldNotSend` pass. */
private fun requirePercept(percept: String) {
    val fault = if (perceptsOf(percept) == listOf(percept.trim())) whyLeftOut(percept.trim()) else "a text is one percept, without a ;"
    require(fault == null) {
        "no agent would believe the percept \"$percept\": $fault. perceivesRaw and showsRaw send a message as it is"
    }
}

private fun functorOf(percept: String) = percept.removePrefix("~").substringBefore('(').substringBefore('[').trim()

private fun millis(duration: Duration): Int = duration.inWholeMilliseconds.also {
    require(it in 0..Int.MAX_VALUE) { "a board takes 0 ms or more, not $duration" }
}.toInt()
