package samples.bare

import java.nio.file.Path
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/** A program in a process of its own, with only the class path that it is given. */
internal class JarProgram private constructor(private val process: Process) : AutoCloseable {
    private val lines = LinkedBlockingQueue<String>()
    private val all = StringBuffer()
    private val reader = thread(isDaemon = true) {
        process.inputStream.bufferedReader().forEachLine {
            all.append(it).append('\n')
            lines.put(it)
        }
    }

    /** The exit status and the output of a program that has ended, errors included. */
    class Ended(val status: Int, val printed: String)

    /** Returns the next line that holds [text]. */
    fun awaitLine(text: String): String {
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(LIMIT_S)
        while (true) {
            val line = lines.poll(deadline - System.nanoTime(), TimeUnit.NANOSECONDS)
                ?: throw AssertionError("no line with \"$text\" in:\n$all")
            if (text in line) return line
        }
    }

    /** Ends it as Ctrl-C does, and waits for that. */
    fun interrupt(): Ended {
        process.toHandle().destroy() // process.destroy() would close its output too
        return ended()
    }

    /** Returns the programs that it has started and that still run. */
    fun children(): List<ProcessHandle> = process.toHandle().descendants().toList()

    /** Waits for its end. */
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

        /** A program that ends soon does not pay for an optimizing compiler. */
        private val java = listOf(thisJava().program, "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC")

        /** Starts Java with [arguments] in [folder]. */
        fun start(folder: Path, vararg arguments: String): JarProgram =
            start(ProcessBuilder(java + arguments).directory(folder.toAbsolutePath().toFile()))

        /** Runs Java with [arguments] in [folder] to its end. */
        fun run(folder: Path, vararg arguments: String): Ended = start(folder, *arguments).use { it.ended() }

        /** Runs [command] to its end. */
        fun run(command: ProcessBuilder): Ended = start(command).use { it.ended() }

        private fun start(command: ProcessBuilder) = JarProgram(command.redirectErrorStream(true).start())
    }
}
