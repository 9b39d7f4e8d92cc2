package samples.bare

import java.nio.file.Path
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

internal class JarProgram private constructor(private val process: Process) : AutoCloseable {
    private val lines = LinkedBlockingQueue<String>()
    private val all = StringBuffer()
    private val reader = thread(isDaemon = true) {
        process.inputStream.bufferedReader().forEachLine {
            all.append(it).append('\n')
            lines.put(it)
        }
    }

    class Ended(val status: Int, val printed: String)

    fun awaitLine(text: String): String {
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(LIMIT_S)
        while (true) {
            val line = lines.poll(deadline - System.nanoTime(), TimeUnit.NANOSECONDS)
                ?: throw AssertionError("no line with \"$text\" in:\n$all")
            if (text in line) return line
        }
    }

    /** Ends the program like Ctrl-C, and waits for its end. */
    fun interrupt(): Ended {
        process.toHandle().destroy() // process.destroy() would also close the output
        return ended()
    }

    fun children(): List<ProcessHandle> = process.toHandle().descendants().toList()

    fun ended(): Ended {
        if (!process.waitFor(LIMIT_S, TimeUnit.SECONDS)) throw AssertionError("it still runs; it printed:\n$all")
        reader.join()
        return Ended(process.exitValue(), "$all")
    }

    override fun close() {
        process.destroyForcibly().waitFor()
    }

    companion object {
        private const val LIMIT_S = 120L

        /** Short programs do not profit from an optimizing compiler. */
        private val java = listOf(thisJava().program, "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC")

        fun start(folder: Path, vararg arguments: String): JarProgram =
            start(ProcessBuilder(java + arguments).directory(folder.toAbsolutePath().toFile()))

        fun run(folder: Path, vararg arguments: String): Ended = start(folder, *arguments).use { it.ended() }

        fun run(command: ProcessBuilder): Ended = start(command).use { it.ended() }

        private fun start(command: ProcessBuilder) = JarProgram(command.redirectErrorStream(true).start())
    }
}
