package samples.firmware

import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

private val ROOT: Path = Path.of("../javino-arduino").toAbsolutePath()

private val SIMULATOR: Path = ROOT.resolve("build/simulator")

/**
 * The kinds of boards that run programs of `javino-arduino/` here.
 *
 * @param folder the folder of the programs in the build directory
 * @param emulator the program that runs them, or null for this project's simulator
 */
internal enum class BoardKind(private val folder: String, private val emulator: String?) {
    UNO("avr/uno", null),
    CORTEX_M("cortex-m", "qemu-system-arm"),
    RISC_V("riscv", "qemu-system-riscv32"),
    ;

    private fun elf(program: String) = ROOT.resolve("build/$folder/$program.elf")

    fun command(program: String): List<String> =
        (if (emulator == null) listOf("$SIMULATOR") else listOf("python3", "$ROOT/tests/e2e/machine.py", folder)) + "${elf(program)}"

    fun isBuilt(vararg programs: String): Boolean =
        (if (emulator == null) Files.isExecutable(SIMULATOR) else onPath(emulator)) && programs.all { Files.exists(elf(it)) }
}

/**
 * A program of `javino-arduino/` on a simulated board. The board's serial line is a pseudo-terminal.
 *
 * @param program a sketch, or `robot` in C, that `./argo firmware` has compiled for this kind of board
 */
internal class SimulatedBoard(program: String, kind: BoardKind = BoardKind.UNO) : AutoCloseable {
    private val process = ProcessBuilder(kind.command(program)).redirectErrorStream(true).start()
    private val commands = process.outputWriter()
    private val lines = LinkedBlockingQueue<String>()
    private val reader = thread(isDaemon = true) { process.inputStream.bufferedReader().forEachLine(lines::put) }

    /** The device to open. */
    val port: String = awaitLine("port ").substringAfter(' ').trim()

    fun setMillivolts(input: String, millivolts: Int) = command("set $input $millivolts")

    /** Reports each change of [pin] to [awaitPin]. */
    fun watch(pin: Int) = command("watch $pin")

    fun awaitPin(pin: Int, state: String) {
        awaitLine("pin $pin $state ")
    }

    /** Returns the next change of a watched pin as printed, without its time. */
    fun awaitChange(): String = awaitLine("pin ").substringBeforeLast(' ')

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
    }
}
