package argo.jason

import javino.LineSettings
import javino.PortException
import javino.Transports
import javino.sim.FakeBoard
import java.util.concurrent.TimeUnit

/** A board in its own process, at the far end of a pseudo-terminal. The board counts the requests for its percepts. */
internal class BoardProcess(device: String) : AutoCloseable {
    private val process = ProcessBuilder(
        ProcessHandle.current().info().command().orElse("java"),
        "-cp", System.getProperty("java.class.path"), "argo.jason.BoardProcessKt", device,
    ).redirectErrorStream(true).start()

    init {
        check(process.inputReader().readLine() == STARTED) { "the board's process did not start" }
    }

    /** Pauses the process by a signal. */
    fun stop() = signal("STOP")

    fun goOn() = signal("CONT")

    private fun signal(name: String) = ProcessBuilder("kill", "-$name", "${process.pid()}").start().waitFor().let {
        check(it == 0) { "kill -$name failed" }
    }

    override fun close() {
        process.destroyForcibly().waitFor(20, TimeUnit.SECONDS)
    }
}

private const val STARTED = "the board runs"

/** The board's program. The argument is the device of the serial line. */
fun main(arguments: Array<String>) {
    val board = FakeBoard.plugIn("process").lenient()
    var count = 0
    board.whenAsked("getPercepts").answer { "count(${++count});" }
    Transports.open(arguments.single(), LineSettings(115_200)).use {
        println(STARTED)
        try {
            board.program().run(it)
        } catch (_: PortException) {
            // the line has gone, so the process ends
        }
    }
}
