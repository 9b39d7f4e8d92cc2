package argo.testkit

import javino.Frame
import javino.LineSettings
import javino.NoSuchPortException
import javino.PerceptsRequest
import javino.PortBusyException
import javino.PortException
import javino.PortGoneException
import javino.PortPermissionException
import javino.Transport
import javino.sim.FakeBoard
import javino.sim.MemoryLine
import javino.sim.Recording
import javino.sim.ReplayBoard
import java.nio.file.Path
import kotlin.time.Duration

/**
 * The board on a port of an agent under test. It answers each request for percepts with what the test last said that its sensors show,
 * and takes everything else as a command. It speaks version 1 of the protocol unless [version2] is called.
 *
 * Its line carries bytes at the rate that the agent opens the port with, in the test's time.
 */
class Board internal constructor(private val time: VirtualTime) {
    private val fake = FakeBoard.unplugged("board", time)
    private var refusal: ((String) -> PortException)? = null
    private var line: MemoryLine? = null
    private val threads = ArrayList<Thread>()
    private var shown: List<String> = emptyList()

    /** How many requests for percepts it has answered since [shows] was called last. */
    internal var answers = 0
        private set

    private var isVersion2 = false
    private var program = fake.program()
    private val replayed = ArrayList<String>()
    private val taken = HashSet<Int>()

    init {
        fake.whenAsked(PerceptsRequest.ALL).answer(::percepts)
        fake.whenAsked(PerceptsRequest::isIn).answer(::percepts)
    }

    /** Its sensors show [percepts] from now on, `dist(front,30)` say, each as its text; none: it answers with an empty message. */
    fun shows(vararg percepts: String): Board = apply {
        messageOf(percepts.toList())
        shown = percepts.toList()
        answers = 0
    }

    /** It says [percepts] of its own accord, now, as a board does whose port is opened with `mode(listen)`. */
    fun says(vararg percepts: String): Board = apply { fake.send(messageOf(percepts.toList())) }

    /** It puts [bytes] on the line as they are, now: noise, half a message. A character is a byte. */
    fun disturbs(bytes: String): Board = apply { fake.noise(*bytesOf(bytes)) }

    /**
     * From the next opening of its port on it says what a board said in [recording], at the times of the recording, and takes any command. What
     * else was said of this board does not count then, but for its port.
     * @throws IllegalArgumentException if the board says nothing in the recording
     */
    fun replays(recording: Recording): Board = apply {
        program = ReplayBoard.of(recording, time).tellingCommandsTo { replayed += it }
    }

    /** [replays] the recording in [file], as `monitor --record` of ARGO's tools writes it. */
    fun replays(file: Path): Board = replays(Recording.read(file))

    /** It speaks version 2 of the protocol with those who do; to be called before the port is opened. */
    fun version2(): Board = apply {
        isVersion2 = true
        fake.version2()
    }

    /** It refuses [command], which an agent learns if it speaks version 2 with it: the plan fails with `error(act_refused)`. */
    fun refuses(command: String): Board = apply { fake.whenAsked(command).refuse() }

    /** It refuses every command that [kind] is true for. */
    fun refuses(kind: (String) -> Boolean): Board = apply { fake.whenAsked(kind).refuse() }

    /** It takes [command] again, at once. */
    fun accepts(command: String): Board = apply { fake.whenAsked(command) }

    /** It takes [duration] for [command], and does nothing else meanwhile. */
    fun takes(duration: Duration, command: String): Board = apply { fake.whenAsked(command).after(millis(duration)) }

    /** It takes [duration] to start when its port is opened, and loses what comes meanwhile. */
    fun boots(duration: Duration): Board = apply { fake.bootTakes(millis(duration)) }

    /** It hangs: it neither answers nor acts, until [recovers] is called. The agent believes `port(P,timeout)`. */
    fun hangs(): Board = apply { fake.stall() }

    /** It goes on where it [hung][hangs]. */
    fun recovers(): Board = apply { fake.resume() }

    /**
     * Its cable is pulled; the port is not there until [plugIn] is called. The agent believes `port(P,off)`. A board that hangs does not any more when
     * it has power again.
     */
    fun unplug(): Board = apply {
        isMissing()
        line?.unplug()
        recovers()
    }

    /** The port is there and can be opened. */
    fun plugIn(): Board = apply { refusal = null }

    /** The port is not there: opening it fails with `error(no_such_port)`. */
    fun isMissing(): Board = apply { refusal = { NoSuchPortException(it, "there is no port $it") } }

    /** The port belongs to [owner], an agent or a program: opening it fails with `error(port_busy)`. */
    fun isHeldBy(owner: String): Board = apply { refusal = { PortBusyException(it, owner) } }

    /** The agent may not open the port: it fails with `error(port_permission)`. */
    fun isForbidden(): Board = apply { refusal = { PortPermissionException(it, "this user may not open port $it") } }

    /** The commands that have arrived, in their order. */
    val commands: List<String> get() = fake.received().filterNot(PerceptsRequest::isIn) + replayed

    /** The requests for percepts that have arrived, in their order: `getPercepts`, or with functors from an agent that speaks version 2. */
    val requests: List<String> get() = fake.received().filter(PerceptsRequest::isIn)

    /** Its [commands], and whether an expectation has taken each. */
    internal val accounted: List<Pair<String, Boolean>> get() = commands.mapIndexed { i, command -> command to (i in taken) }

    /** The commands that no expectation has taken. */
    internal val unexpected: List<String> get() = commands.filterIndexed { i, _ -> i !in taken }

    /** Takes [command] if it has arrived and no expectation has taken it. */
    internal fun take(command: String): Boolean {
        val index = commands.withIndex().firstOrNull { (i, text) -> i !in taken && text == command }?.index ?: return false
        return taken.add(index)
    }

    /** Whether there is something on its port. */
    internal val isPresent: Boolean get() = refusal?.invoke("") !is NoSuchPortException

    internal fun open(port: String, settings: LineSettings): Transport {
        refusal?.let { throw it(port) }
        val line = MemoryLine.paced(port, settings, time).also { this.line = it }
        threads.removeAll { !it.isAlive }
        threads += time.start("board $port") { run(line) }
        return line.computer()
    }

    private fun run(line: MemoryLine) {
        try {
            program.run(line.board())
        } catch (_: PortGoneException) {
            // the agent closed its port, or the cable was pulled
        } catch (_: InterruptedException) {
            // the test is over
        }
    }

    internal fun end() {
        recovers()
        line?.unplug()
        threads.forEach(Thread::interrupt) // whatever else it still does
    }

    private fun percepts(request: String): String {
        answers++
        val functors = PerceptsRequest.functorsIn(request)
        return messageOf(shown.filter { functors.isEmpty() || functorOf(it) in functors })
    }

    private fun messageOf(percepts: List<String>) = percepts.joinToString("") { "$it;" }.also {
        require(isVersion2 || it.length <= Frame.MAX_PAYLOAD) {
            "a board of version 1 says ${Frame.MAX_PAYLOAD} bytes at once, not ${it.length}; let it say less, or call version2() first"
        }
        bytesOf(it)
    }

    private fun bytesOf(text: String): ByteArray {
        require(text.all { it.code <= HIGHEST_BYTE }) { "a message carries one byte per character, and \"$text\" holds others" }
        return text.toByteArray(Charsets.ISO_8859_1)
    }
}

private const val HIGHEST_BYTE = 0xFF

private fun functorOf(percept: String) = percept.removePrefix("~").substringBefore('(').substringBefore('[').trim()

private fun millis(duration: Duration): Int = duration.inWholeMilliseconds.also {
    require(it in 0..Int.MAX_VALUE) { "a board takes 0 ms or more, not $duration" }
}.toInt()
