package argo.testkit

import argo.filters.matching.perceptsOf
import argo.links.BoardLink
import argo.links.BoardLinkProvider
import argo.links.PlayedBoard
import argo.mcap.McapReader
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
 * The board on a port of an agent under test. The board answers requests for percepts with the percepts that its sensors [show][shows].
 * Every other message is a command. The board speaks version 1 of the protocol unless [version2] is called.
 *
 * The board's line carries bytes at the agent's baud rate, in virtual time. Each function's name is a verb with the board as its subject:
 * `board.hangs()`. A function has its effect at once. The agent reacts when time advances.
 */
class Board internal constructor(private val time: VirtualTime) {
    private val fake = FakeBoard.unplugged("board", time)
    private var isConnected = true
    private var openingNanos = 0L
    private var refusal: ((String) -> PortException)? = null
    private var elsewhere: ((String, LineSettings, LineClock) -> Transport)? = null
    private var line: MemoryLine? = null
    private var played: PlayedBoard? = null
    private var bag: Path? = null
    private val taking = ArrayList<String>()
    private val threads = ArrayList<Thread>()
    private var answer: (Set<String>) -> String? = { "" }

    /** The number of answered requests for percepts since the last call of [shows] or [showsRaw]. */
    internal var answers = 0
        private set

    /**
     * The percepts of the board's last answer. Null before the first answer, if the board ignores requests, or if its port leads elsewhere.
     */
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

    /** True if the board's program must restart on this line. */
    @Volatile
    private var isToRestart = false

    /** True if the board ignores requests for percepts for now. */
    internal var isSilent = false

    /** One in this many bytes on the line has a wrong bit, in each direction. 0 means no wrong bytes. */
    internal var garbledOneIn = 0

    /**
     * The sensors show [percepts] from now on. Each percept is a text such as `dist(front,30)`. Without percepts, the board answers with an
     * empty message.
     * @throws IllegalArgumentException if an agent would ignore a malformed percept, such as `dist(front`. Use [showsRaw] for it
     */
    fun shows(vararg percepts: String): Board = apply {
        messageOf(percepts.toList())
        shows { percepts.toList() }
        shown = percepts.toList()
    }

    /**
     * The sensors show the percepts of [sensors] from now on. The board's thread calls [sensors] at each request, with the time since the
     * start of the test. Example of a robot that drives at 10 cm/s towards a wall:
     * `shows { listOf("dist(front,${90 - it.inWholeMilliseconds / 100})") }`. A malformed percept makes the test fail.
     */
    fun shows(sensors: (Duration) -> List<String>): Board = answers { functors ->
        val percepts = sensors(now).also { shown = it }
        messageOf(percepts.filter { functors.isEmpty() || functorOf(it) in functors })
    }

    /** The board answers requests for percepts with exactly [message] from now on. [message] may be malformed: `dist(front;)(;`. */
    fun showsRaw(message: String): Board = apply {
        sendable(message)
        showsRaw { message }
        shown = perceptsOf(message)
    }

    /** The board answers requests for percepts with the result of [message] from now on. The calls of [message] are as in [shows]. */
    fun showsRaw(message: (Duration) -> String): Board = answers {
        sendable(message(now)).also { shown = perceptsOf(it) }
    }

    /**
     * The board ignores requests for percepts until [shows] is called. The board still carries out commands. The agent believes
     * `port(P,timeout)`.
     */
    fun ignoresRequests(): Board = apply {
        answer = { null }
        shown = null
    }

    /**
     * The board sends [percepts] now, without a request. Ports opened with `mode(listen)` expect such messages.
     * @throws IllegalArgumentException if an agent would ignore a malformed percept
     */
    fun says(vararg percepts: String): Board = apply {
        fake.send(messageOf(percepts.toList()))
        shown = percepts.toList()
    }

    /**
     * The board puts [bytes] on the line now, unchanged. The [bytes] may be noise or a part of a message. Each character becomes one byte.
     */
    fun disturbs(bytes: String): Board = apply { fake.noise(*bytesOf(bytes)) }

    internal fun disturbs(frame: WireFrame): Board = apply { fake.noise(frame) }

    /**
     * At the next opening of its port, the board starts to send the bytes in [recording] at the recorded times. The board accepts any
     * command. Only the settings of its port have an effect.
     * @throws IllegalArgumentException if the board sends nothing in the recording
     */
    fun replays(recording: LineRecording): Board = apply {
        program = ReplayBoard.of(recording, time).tellingCommandsTo { replayed += Arrival(it, now) }
    }

    /**
     * The board [replays] the recording in [file], which `monitor --record` has written. If the file is a ROS 2 bag in the MCAP format, the
     * board [plays its mapping][playsItsMapping]. The board publishes the bag's messages at their recorded times, counted from the agent's
     * first perception.
     */
    fun replays(file: Path): Board =
        if (McapReader.isMcap(file)) playsItsMapping().apply { bag = file } else replays(LineRecording.read(file))

    /**
     * At the next opening of its port, the board uses the line that [open] returns, such as that of a simulated sketch. [open] gets the
     * port's name, its settings and the clock of the line. After that, only settings of the port have an effect, and expectations of
     * commands have none.
     */
    fun leadsTo(open: (String, LineSettings, LineClock) -> Transport): Board = apply { elsewhere = open }

    /**
     * The board is the robot that the port's name denotes, such as `ros://robot:9090`. A robot has no line. A mapping turns the robot's
     * topics into percepts. The mapping and ARGO are real, and the robot is simulated. The test [publishes] its messages, and each command
     * succeeds at once. Only the settings of its port have an effect. Call this function before the port is opened.
     */
    fun playsItsMapping(): Board = apply { isMapped = true }

    /**
     * The board publishes the JSON [message] on [topic] if its port is open and the agent subscribes to [topic]. If [topic] is a service or
     * an action, [message] becomes its response to all later commands. The board must [play its mapping][playsItsMapping].
     * @throws IllegalArgumentException if [message] is no JSON object
     * @throws IllegalStateException if the board is not mapped
     */
    fun publishes(topic: String, message: String): Board = apply {
        check(isMapped) { "a board on a line has no topics: call playsItsMapping() before its port is opened" }
        played?.says(topic, message)
    }

    /** The messages, requests and goals for the robot. Each follows its topic, service or action: `/cmd_vel {"linear":{"x":0.3}}`. */
    val published: List<String> get() = taking

    /** The board speaks version 2 of the protocol with agents that support it. Call this function before the port is opened. */
    fun version2(): Board = apply {
        isVersion2 = true
        fake.version2()
    }

    /**
     * The board tells version 2 agents that it knows only these [actions]. `ledOn` is an action without arguments, `speed/1` has one
     * argument. A star in place of the 1 stands for any number of arguments. Without this call, the board describes no actions, and agents
     * do not check commands.
     */
    fun knows(vararg actions: String): Board = apply { fake.knows(*actions) }

    /**
     * The board describes its percepts to version 2 agents by these [kinds]: `dist(front|left, cm 0..400)`. Live views show the
     * description. An agent also believes percepts that contradict the description.
     */
    fun describes(vararg kinds: String): Board = apply { fake.perceives(*kinds) }

    /**
     * The board can hold [count] critical rules. The board checks the rules every 5 ms against the percepts that its sensors [show][shows].
     * The board carries out the reflexes of the rules, and reflexes count as arrived [commands]. Board rules need version 2. Call this
     * function before the port is opened.
     */
    fun holdsRules(count: Int): Board = apply { fake.holdsRules(count) }

    /**
     * The board refuses [command]. The agent's plan then fails with `error(act_refused)`.
     * @throws IllegalStateException if the board speaks version 1, which has no refusals
     */
    fun refuses(command: String): Board = apply { refusable(fake.whenAsked(command)) }

    /** The board refuses every command for which [kind] returns true. The effect is that of the other [refuses]. */
    fun refuses(kind: (String) -> Boolean): Board = apply { refusable(fake.whenAsked(kind)) }

    /** The board carries out [command] at once from now on. Effects of [refuses] and [takes] on [command] end. */
    fun accepts(command: String): Board = apply { fake.whenAsked(command) }

    /** The board takes [duration] for [command], and does nothing else in that time. */
    fun takes(duration: Duration, command: String): Board = apply { fake.whenAsked(command).after(millis(duration)) }

    /** The board takes [duration] to boot when its port is opened. The board loses all bytes that arrive in that time. */
    fun boots(duration: Duration): Board = apply {
        bootMs = millis(duration)
        fake.bootTakes(bootMs)
    }

    /** The board delays each answer to a request for percepts by [duration]. The board does nothing else in that time. */
    fun answersAfter(duration: Duration): Board = apply { requestRules.forEach { it.after(millis(duration)) } }

    /**
     * The board restarts now, as after a reset or a drop of its supply voltage. The port stays open. The board forgets the version 2
     * session, and loses all bytes that arrive within [booting].
     */
    fun restarts(booting: Duration): Board = apply {
        if (!isOpen) return@apply
        recovers()
        fake.bootTakes(millis(booting))
        time.later(nanos(booting)) { fake.bootTakes(bootMs) }
        isToRestart = true
        threads.forEach(Thread::interrupt)
    }

    /** The board's port takes [duration] to open, as a Bluetooth adapter does. The agent's `argo.port` waits for that time. */
    fun opensAfter(duration: Duration): Board = apply { openingNanos = nanos(duration) }

    /** The board neither answers nor acts until [recovers] is called. The agent believes `port(P,timeout)`. */
    fun hangs(): Board = apply { fake.stall() }

    /** The board continues after [hangs]. */
    fun recovers(): Board = apply { fake.resume() }

    /**
     * The board's cable is unplugged. Opening the port fails with `error(no_such_port)` until [reconnects] is called. If the port is open,
     * the agent believes `port(P,off)`. The board loses its power, so [hangs] ends.
     */
    fun disconnects(): Board = apply {
        isConnected = false
        line?.unplug()
        played?.goes()
        recovers()
    }

    /** The board's cable is plugged in again. */
    fun reconnects(): Board = apply { isConnected = true }

    /**
     * [owner], another agent or program, uses the board's port. Opening the port fails with `error(port_busy)` until [admits] is called.
     */
    fun belongsTo(owner: String): Board = apply { refusal = { PortBusyException(it, owner) } }

    /** The agent has no permission to open the board's port. Opening fails with `error(port_permission)` until [admits] is called. */
    fun deniesAccess(): Board = apply { refusal = { PortPermissionException(it, "this user may not open port $it") } }

    /** The board's port is free, and the agent may open it. */
    fun admits(): Board = apply { refusal = null }

    /** True if the agent has opened the board's port. */
    val isOpen: Boolean get() = line?.let { !it.isGone } ?: played?.link?.isOpen ?: false

    /** The messages that have arrived, in the order of arrival: requests for percepts, and commands. */
    val received: List<String> get() = timed.map { it.command }

    /** The commands that have arrived, in the order of arrival. */
    val commands: List<String> get() = received.filterNot(PerceptsRequest::isIn)

    /** The [commands], each with the time of its arrival. */
    val arrivals: List<Arrival> get() = timed.filterNot { PerceptsRequest.isIn(it.command) }

    /** The arrived requests for percepts, in order of arrival: `getPercepts`, in version 2 possibly with functors. */
    val requests: List<String> get() = received.filter(PerceptsRequest::isIn)

    private val timed: List<Arrival> get() = fake.receivedMessages().map { Arrival(it.text(), it.nanos().nanoseconds) } + replayed

    private val now: Duration get() = time.nanos().nanoseconds

    /** The [arrivals]. The boolean is true if an expectation has used the arrival. */
    internal val accounted: List<Pair<Arrival, Boolean>> get() = arrivals.mapIndexed { i, arrival -> arrival to (i in taken) }

    internal val unexpected: List<String> get() = commands.filterIndexed { i, _ -> i !in taken }

    /** Marks [command] as used by an expectation. Returns false if no unused one has arrived at an [acceptable time][isTimely]. */
    internal fun take(command: String, isTimely: (Duration) -> Boolean = { true }): Boolean {
        // called at each instant of a wait, so it must be cheap while nothing has come
        if (fake.receivedMessages().none { it.text() == command } && replayed.none { it.command == command }) return false
        val index = arrivals.withIndex().firstOrNull { (i, it) -> i !in taken && it.command == command && isTimely(it.at) }?.index
            ?: return false
        return taken.add(index)
    }

    internal var wasOpened = false
        private set

    internal val isPresent: Boolean get() = isConnected

    internal var isMapped = false
        private set

    /** Opens the robot that the name [port] denotes. */
    internal fun openMapped(port: String, isPaced: Boolean): BoardLink {
        awaitOpening(port)
        val opened = BoardLinkProvider.of(port)?.play(port, isPaced, time, bag) { name, message -> taking += "$name $message" }
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
                // the agent closed its port, or the cable was unplugged
            } catch (_: PortInterruptedException) {
                Thread.interrupted() // the board restarts, or the test has ended
            } catch (_: InterruptedException) {
                // the board restarts, or the test has ended
            }
        } while (isToRestart)
    }

    internal fun end() {
        recovers()
        line?.unplug()
        threads.forEach(Thread::interrupt) // interrupts a replay or a slow command
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

/** A [command] that arrived at a board. [at] is the virtual time since the start of the test. */
data class Arrival(val command: String, val at: Duration)

private const val HIGHEST_BYTE = 0xFF

/** Refuses a malformed percept. The agent would ignore it, and a later `shouldNotSend` would then pass for the wrong reason. */
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
