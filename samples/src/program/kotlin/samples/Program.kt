package samples

import java.nio.file.Path
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/** A Java program in another process, with the class path of the tests. */
internal class Program private constructor(private val process: Process) : AutoCloseable {
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

    fun awaitEnd(): Pair<Int, String> {
        if (!process.waitFor(DEADLINE_S, TimeUnit.SECONDS)) throw AssertionError("it still runs after $DEADLINE_S s; it printed:\n$printed")
        reader.join()
        return process.exitValue() to printed.toString().trimEnd()
    }

    fun enter() = process.outputStream.run {
        write('\n'.code)
        flush()
    }

    /** Ends the program like Ctrl-C. */
    fun interrupt() = process.destroy()

    override fun close() {
        process.destroyForcibly().waitFor()
    }

    companion object {
        private const val DEADLINE_S = 300L

        /** The Java of the tests. Short programs do not profit from an optimizing compiler. */
        private val java =
            listOf("${Path.of(System.getProperty("java.home"), "bin", "java")}", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC")

        fun start(mainClass: String, vararg arguments: String, directory: Path = Path.of("")): Program {
            val command = java + listOf("-cp", System.getProperty("java.class.path"), mainClass) + arguments
            return Program(ProcessBuilder(command).directory(directory.toAbsolutePath().toFile()).redirectErrorStream(true).start())
        }

        /** Starts the sample program with [arguments]. The program's environment variable `TERM` is [term]. */
        fun inTerminal(term: String, vararg arguments: String): Program {
            val command = "${java.joinToString(" ")} samples.MainKt ${arguments.joinToString(" ")}"
            val builder = ProcessBuilder("socat", "-", "EXEC:\"$command\",pty,setsid,ctty,stderr").redirectErrorStream(true)
            builder.environment().run {
                putAll(mapOf("CLASSPATH" to System.getProperty("java.class.path"), "TERM" to term))
                remove("CI")
            }
            return Program(builder.start())
        }

        fun samples(vararg arguments: String) = start("samples.MainKt", *arguments)

        fun run(vararg arguments: String): Pair<Int, String> = samples(*arguments).use { it.awaitEnd() }

        /** Starts the project [name] as a plain Jason project, without ARGO's own programs. */
        fun jason(name: String) =
            start("jason.infra.local.RunLocalMAS", "$name.mas2j", "--no-net", directory = Path.of(name))
    }
}
