package argo.jason

import io.kotest.core.test.Enabled
import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/** Enabled if there is Python, and its module for pseudo-terminals works. */
internal val withPython: Enabled = run {
    val works = try {
        ProcessBuilder("python3", "-c", "import pty").start().waitFor() == 0
    } catch (_: IOException) {
        false
    }
    if (works) Enabled.enabled else Enabled.disabled("needs python3 on a POSIX system")
}

/**
 * The board of `javino-python/tests/boards/echo.py` in its own process, at a pseudo-terminal. [link] leads to the terminal. With a [seed],
 * one byte in 200 is damaged in both directions.
 */
internal class PythonBoard(link: Path, seed: Int? = null) : AutoCloseable {
    private val folder = Path.of("../javino-python").toRealPath()
    private val started = CompletableFuture<Unit>()
    private val process = ProcessBuilder(
        listOf("python3", "$folder/tests/boards/echo.py", "$folder", "pty:$link") + listOfNotNull(seed?.toString()),
    ).start()

    /** The actions that the board has carried out, in their order. `lost` means that the computer was silent. */
    val carriedOut = CopyOnWriteArrayList<String>()

    init {
        thread(isDaemon = true) {
            process.errorStream.bufferedReader().forEachLine { if (it.startsWith("line ")) started.complete(Unit) else carriedOut += it }
        }
        started.get(20, TimeUnit.SECONDS)
    }

    override fun close() {
        process.destroyForcibly().waitFor(20, TimeUnit.SECONDS)
    }
}
