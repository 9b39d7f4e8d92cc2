package javino

import io.kotest.core.test.Enabled
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** A pair of pseudo-terminals that socat joins: what goes into one comes out of the other. The names are symbolic links. */
internal class PseudoTerminals private constructor(private val socat: Process, private val directory: Path) : AutoCloseable {
    val computer: String = directory.resolve(COMPUTER).toString()
    val board: String = directory.resolve(BOARD).toString()

    /** Ends socat, which is to both ends as if the other were pulled out. */
    fun unplug() {
        socat.destroyForcibly().waitFor()
    }

    override fun close() {
        unplug()
        directory.toFile().deleteRecursively()
    }

    companion object {
        private const val COMPUTER = "computer"
        private const val BOARD = "board"
        private const val START_SECONDS = 20L

        private val socatIsThere = System.getenv("PATH").orEmpty().split(':').any { Files.isExecutable(Path.of(it, "socat")) }

        /** Whether they can be had here. */
        val available: Enabled =
            if (socatIsThere) Enabled.enabled else Enabled.disabled("needs pseudo-terminals, and socat, which makes them, is not installed")

        fun open(): PseudoTerminals {
            val directory = Files.createTempDirectory("javino")
            val ends = listOf(COMPUTER, BOARD).map { directory.resolve(it) }
            val command = listOf("socat") + ends.map { "pty,raw,echo=0,link=$it" }
            val socat = ProcessBuilder(command).redirectErrorStream(true).redirectOutput(directory.resolve("log").toFile()).start()
            val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(START_SECONDS)
            while (!ends.all { Files.exists(it) }) {
                check(System.nanoTime() < deadline) { "socat made no pseudo-terminals: ${Files.readString(directory.resolve("log"))}" }
                Thread.onSpinWait()
            }
            return PseudoTerminals(socat, directory)
        }
    }
}
