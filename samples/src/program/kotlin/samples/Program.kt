package samples

import java.nio.file.Path
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/** A program in another process. Programs in Java run in the Java of the tests. */
internal class Program private constructor(private val process: Process) : AutoCloseable {
    data class Ended(val status: Int, val printed: String)

    private val unread = LinkedBlockingQueue<String>()
    private val printed = StringBuffer()
    private val reader = thread(isDaemon = true) {
        process.inputStream.bufferedReader().forEachLine {
            printed.append(it).append('\n')
            unread.put(it)
        }
    }

    fun awaitLine(text: String): String {
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DEADLINE_S)
        while (true) {
            val line = unread.poll(deadline - System.nanoTime(), TimeUnit.NANOSECONDS)
                ?: throw AssertionError("no line with \"$text\" within $DEADLINE_S s in:\n$printed")
            if (text in line) return line
        }
    }

    fun awaitEnd(): Ended {
        if (!process.waitFor(DEADLINE_S, TimeUnit.SECONDS)) throw AssertionError("it still runs after $DEADLINE_S s; it printed:\n$printed")
        reader.join()
        return Ended(process.exitValue(), printed.toString().trimEnd())
    }

    fun enter() = process.outputStream.run {
        write('\n'.code)
        flush()
    }

    /** Ends the program like Ctrl-C, and waits for its end. */
    fun interrupt(): Ended {
        process.toHandle().destroy() // process.destroy() would also close the output
        return awaitEnd()
    }

    fun children(): List<ProcessHandle> = process.toHandle().descendants().toList()

    override fun close() {
        process.destroyForcibly().waitFor()
    }

    companion object {
        private const val DEADLINE_S = 300L

        /** The Java of the tests. Short programs do not profit from an optimizing compiler. */
        private val java =
            listOf("${Path.of(System.getProperty("java.home"), "bin", "java")}", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC")

        fun start(folder: Path, vararg arguments: String) =
            start(ProcessBuilder(java + arguments).directory(folder.toAbsolutePath().toFile()))

        /** Starts [mainClass] with the class path of the tests. */
        fun start(mainClass: String, vararg arguments: String, directory: Path = Path.of("")) =
            start(directory, "-cp", System.getProperty("java.class.path"), mainClass, *arguments)

        private fun start(command: ProcessBuilder) = Program(command.redirectErrorStream(true).start())

        /** Starts the sample program with [arguments]. The program's environment variable `TERM` is [term]. */
        fun inTerminal(term: String, vararg arguments: String): Program {
            val command = "${java.joinToString(" ")} samples.MainKt ${arguments.joinToString(" ")}"
            val builder = ProcessBuilder("socat", "-", "EXEC:\"$command\",pty,setsid,ctty,stderr")
            builder.environment().run {
                putAll(mapOf("CLASSPATH" to System.getProperty("java.class.path"), "TERM" to term))
                remove("CI")
            }
            return start(builder)
        }

        fun samples(vararg arguments: String) = start("samples.MainKt", *arguments)

        fun run(vararg arguments: String): Ended = samples(*arguments).use { it.awaitEnd() }

        fun run(folder: Path, vararg arguments: String): Ended = start(folder, *arguments).use { it.awaitEnd() }

        fun run(command: ProcessBuilder): Ended = start(command).use { it.awaitEnd() }

        /** Starts the project [name] as a plain Jason project, without ARGO's own programs. */
        fun jason(name: String) =
            start("jason.infra.local.RunLocalMAS", "$name.mas2j", "--no-net", directory = Path.of(name))
    }
}
