package samples.firmware

import javino.LineClock
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.Condition
import kotlin.concurrent.thread

/**
 * A sketch of `javino-arduino/` on a simulated ATmega328P, whose serial line is a pseudo-terminal.
 *
 * @param sketch the name of an example, which `./argo firmware` has compiled
 */
internal class SimulatedUno(sketch: String) : AutoCloseable {
    private val process = ProcessBuilder("$SIMULATOR", "${elf(sketch)}").redirectErrorStream(true).start()
    private val commands = process.outputWriter()
    private val lines = LinkedBlockingQueue<String>()
    private val reader = thread(isDaemon = true) { process.inputStream.bufferedReader().forEachLine(lines::put) }

    /** The device to open. */
    val port: String = awaitLine("port ").substringAfter(' ').trim()

    /** Applies a voltage to an analogue input such as `A0`. */
    fun setMillivolts(input: String, millivolts: Int) = command("set $input $millivolts")

    /** Reports each change of [pin] from now on to [awaitPin]. */
    fun watch(pin: Int) = command("watch $pin")

    /** Waits until [pin], which is watched, is `high` or `low`. */
    fun awaitPin(pin: Int, state: String) {
        awaitLine("pin $pin $state ")
    }

    /** The board's time, which stands still while the machine is too busy to simulate it. */
    val clock = object : LineClock {
        @Synchronized
        override fun nanos(): Long {
            command("time")
            return (awaitLine("ok ").substringAfter(' ').toDouble() * 1e6).toLong()
        }

        override fun await(condition: Condition, nanos: Long) {
            condition.awaitNanos(nanos)
        }
    }

    private fun command(text: String) = commands.run {
        write("$text\n")
        flush()
    }

    private fun awaitLine(start: String): String {
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DEADLINE_S)
        while (true) {
            val line = lines.poll(deadline - System.nanoTime(), TimeUnit.NANOSECONDS)
                ?: throw AssertionError("the simulated board did not say \"$start\" within $DEADLINE_S s")
            if (line.startsWith("error")) throw AssertionError("the simulated board: $line")
            if (line.startsWith(start)) return line
        }
    }

    override fun close() {
        process.destroyForcibly().waitFor()
        reader.join()
    }

    companion object {
        private const val DEADLINE_S = 60L
        private val BUILD: Path = Path.of("../javino-arduino/build").toAbsolutePath()
        private val SIMULATOR = BUILD.resolve("simulator")

        private fun elf(sketch: String) = BUILD.resolve("avr/uno/$sketch.elf")

        /** Whether the simulator and the sketches have been built. */
        fun isBuilt(): Boolean = Files.isExecutable(SIMULATOR) && listOf("Blink", "Robot4WD", "Field").all { Files.exists(elf(it)) }
    }
}
