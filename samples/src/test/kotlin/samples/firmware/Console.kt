package samples.firmware

import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/** A program with simulated keyboard input. Collects its output and errors. */
internal class Console(vararg command: String, environment: (MutableMap<String, String>) -> Unit = {}) : AutoCloseable {
    private val process = ProcessBuilder(*command).redirectErrorStream(true)
        .also { it.environment()["TERM"] = "xterm"; environment(it.environment()) }.start()
    private val arriving = LinkedBlockingQueue<Int>()
    private val printed = StringBuilder()
    private var awaited = 0

    init {
        thread(isDaemon = true) {
            process.inputStream.reader().use { reader ->
                do {
                    val next = reader.read()
                    arriving += next
                } while (next >= 0)
            }
        }
    }

    fun type(text: String, end: String = "\n") {
        process.outputStream.apply { write((text + end).toByteArray()); flush() }
    }

    /** Waits until the program has printed [text] behind the last awaited text. */
    fun await(text: String) {
        while (printed.indexOf(text, awaited) < 0) {
            val next = arriving.poll(LIMIT_S, TimeUnit.SECONDS) ?: -1
            if (next < 0) error("\"$text\" is not in: $printed")
            printed.append(next.toChar())
        }
        awaited = printed.indexOf(text, awaited) + text.length
    }

    fun status(): Int = if (process.waitFor(LIMIT_S, TimeUnit.SECONDS)) process.exitValue() else error("it does not end: $printed")

    override fun close() {
        process.destroy()
    }

    private companion object {
        const val LIMIT_S = 180L
    }
}
