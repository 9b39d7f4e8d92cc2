package benchmarks.stops

import java.io.IOException
import java.nio.file.Path
import java.util.Locale

/**
 * A sketch on a simulated ATmega328P. The sketch's time advances only in [runTo]. Times are ns since power-on. Not safe for use by several
 * threads at once.
 *
 * @param simulator the program of `javino-arduino/simulator`
 * @param sketch an `.elf` or `.hex` file
 */
internal class SteppedUno(simulator: Path, sketch: Path) : AutoCloseable {
    private val process = ProcessBuilder("$simulator", "--stepped", "$sketch").redirectError(ProcessBuilder.Redirect.INHERIT).start()
    private val commands = process.outputWriter()
    private val answers = process.inputReader()
    private var reached = 0L

    /** Called with each byte from the board, and with the arrival time of its last bit. The time is at most one byte time ahead. */
    var sent: (Byte, Long) -> Unit = { _, _ -> }

    /** Called at each change of a watched pin, with the pin, its new level and the time. */
    var changed: (Int, Boolean, Long) -> Unit = { _, _, _ -> }

    /** Runs the sketch until [nanos]. Does nothing if it is already there. */
    fun runTo(nanos: Long) {
        if (nanos <= reached) return
        reached = nanos
        command("run ${cycle(nanos)}")
    }

    /** Sends [bytes] to the sketch, each in [byteNanos]. The first byte starts at [atNanos], which must not be before the sketch's time. */
    fun send(bytes: ByteArray, atNanos: Long, byteNanos: Long) =
        command("send ${cycle(atNanos)} ${cycle(byteNanos)} ${bytes.joinToString("") { "%02x".format(Locale.ROOT, it) }}")

    fun setMillivolts(input: String, millivolts: Int) = command("set $input $millivolts")

    fun watch(pin: Int) {
        write("watch $pin")
        read()
    }

    fun reset() = command("reset")

    private fun command(text: String) {
        write(text)
        while (true) {
            val words = read().split(' ')
            when (words[0]) {
                "ok" -> return
                "byte" -> sent(words[2].toInt(HEXADECIMAL).toByte(), nanos(words[1].toLong()))
                "pin" -> changed(words[1].toInt(), words[2] == "high", (words.last().toDouble() * NANOS_PER_MS).toLong())
                else -> throw IOException("the simulator answers \"$text\" with: ${words.joinToString(" ")}")
            }
        }
    }

    private fun write(text: String) {
        commands.write("$text\n")
        commands.flush()
    }

    private fun read(): String = answers.readLine() ?: throw IOException("the simulator has ended")

    override fun close() {
        process.destroyForcibly().waitFor()
    }

    private companion object {
        const val HEXADECIMAL = 16
        const val NANOS_PER_MS = 1e6

        fun cycle(nanos: Long) = nanos * 16 / 1000

        fun nanos(cycle: Long) = cycle * 1000 / 16
    }
}
