package benchmarks.boards

import benchmarks.SensorBoard
import benchmarks.programApart
import javino.DriverTransport
import javino.LineSettings
import javino.PortException
import javino.PortGoneException
import javino.Protocol
import javino.Transport
import javino.Transports
import java.io.File
import java.io.IOException
import java.net.InetAddress
import java.net.ServerSocket
import java.net.Socket
import java.net.SocketTimeoutException
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong
import kotlin.concurrent.thread

/** Runs boards in another process. The boards' work then does not count for the agent's process. */
internal class BoardHost private constructor(private val process: Process) : AutoCloseable {
    private val commands = process.outputWriter()
    private val answers = process.inputReader()

    /** The ports of the boards, as an agent names them. For boards on devices, these are the devices at the boards' ends. */
    val ports: List<String> = words()

    fun answered(): List<Long> = ask("answered").map(String::toLong)

    fun openLines(): Int = ask("open").single().toInt()

    private fun ask(question: String): List<String> {
        commands.write("$question\n")
        commands.flush()
        return words()
    }

    private fun words(): List<String> = checkNotNull(answers.readLine()) { "the boards' process has ended" }.split(' ')

    override fun close() {
        commands.close() // the process ends when its input ends
        process.waitFor()
    }

    companion object {
        /** Starts a board on each of [devices]. Each board has [percepts] percepts, and all change in each answer. */
        fun onDevices(devices: List<File>, percepts: Int) =
            BoardHost(programApart(BOARD_HOST, "$percepts", *devices.map { "$it" }.toTypedArray()))

        fun onNetwork(boards: Int, percepts: Int) = BoardHost(programApart(BOARD_HOST, "$percepts", *Array(boards) { NETWORK }))
    }
}

internal const val BOARD_HOST = "board-host"

private const val NETWORK = "tcp"
private const val BAUD = 115_200

/** The program of [BoardHost]. The arguments are the number of percepts, and for each board a device or `tcp`. */
internal fun hostBoards(arguments: List<String>) {
    val percepts = arguments.first().toInt()
    val boards = arguments.drop(1).map { if (it == NETWORK) onNetwork(percepts) else onDevice(it, percepts) }
    println(boards.joinToString(" ") { it.port })
    while (true) when (readlnOrNull()) {
        "answered" -> println(boards.joinToString(" ") { "${it.answered}" })
        "open" -> println(boards.sumOf { it.open })
        else -> return
    }
}

/** A board at [port]. [work] serves its lines, on a thread of the board. */
private class HostedBoard(val port: String, private val percepts: Int, work: HostedBoard.() -> Unit) {
    private val answers = AtomicLong()
    private val lines = AtomicInteger()

    val answered: Long get() = answers.get()
    val open: Int get() = lines.get()

    init {
        thread(isDaemon = true, name = "board $port") { work() }
    }

    fun serve(line: Transport) {
        lines.incrementAndGet()
        try {
            line.use { SensorBoard(Protocol.AUTO, ::message, { _, _, _ -> answers.incrementAndGet() }).run(it) }
        } catch (_: PortGoneException) {
            // the agent has closed the line
        } finally {
            lines.decrementAndGet()
        }
    }

    private fun message(n: Int) = SensorBoard.robot(n).split(';').take(percepts).joinToString(";", postfix = ";")
}

private fun onDevice(device: String, percepts: Int): HostedBoard {
    val line = Transports.open(device, LineSettings(BAUD))
    return HostedBoard(device, percepts) {
        try {
            serve(line)
        } catch (trouble: PortException) {
            System.err.println("board $port: ${trouble.message}")
        }
    }
}

private fun onNetwork(percepts: Int): HostedBoard {
    val server = ServerSocket(0, 1, InetAddress.getLoopbackAddress())
    return HostedBoard("tcp://127.0.0.1:${server.localPort}", percepts) { while (true) serve(SocketLine(port, server.accept())) }
}

private class SocketLine(name: String, private val socket: Socket) : DriverTransport(name, LineSettings(BAUD)) {
    init {
        socket.tcpNoDelay = true
    }

    override fun readFromDriver(b: ByteArray, off: Int, len: Int, nanos: Long): Int = try {
        socket.soTimeout = (1 + TimeUnit.NANOSECONDS.toMillis(maxOf(0, nanos))).toInt()
        socket.getInputStream().read(b, off, len).also { if (it < 0) throw lost("the agent closed it") }
    } catch (_: SocketTimeoutException) {
        0
    } catch (broken: IOException) {
        throw lost("${broken.message}")
    }

    override fun writeToDriver(bytes: ByteArray): Int = try {
        socket.getOutputStream().write(bytes)
        bytes.size
    } catch (broken: IOException) {
        lost("${broken.message}")
        -1
    }

    override fun lossWhenRefused() = "the connection broke"

    override fun closeDriver() = socket.close()
}
