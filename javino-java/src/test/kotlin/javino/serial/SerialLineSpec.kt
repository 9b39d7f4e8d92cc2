package javino.serial

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.NamedTag
import io.kotest.core.Tag
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.LineSettings
import javino.PortBusyException
import javino.PortGoneException
import javino.PortInterruptedException
import javino.async
import javino.failure
import javino.link.Link
import javino.link.LinkSettings
import javino.readFully
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.time.Duration.Companion.seconds

private const val LONG_MILLIS = 20_000
private const val CLOSINGS = 30

private val descriptors: Path = Path.of("/proc/self/fd")
private val withProc: Enabled = when {
    !Files.isDirectory(descriptors) -> Enabled.disabled("needs /proc to see what is open")
    else -> Terminals.available
}

private fun openDescriptors(): Int = Files.list(descriptors).use { it.count().toInt() }

private fun liveThreads(): Int = Thread.getAllStackTraces().size

/** Behaviour of serial devices beyond the contract of every transport. */
class SerialLineSpec : FunSpec({
    val settings = LinkSettings.defaults().withBaud(115_200)

    fun onTerminals(name: String, enabled: Enabled = Terminals.available, tags: Set<Tag> = emptySet(), body: (Terminals) -> Unit) =
        test(name).config(tags = tags, enabledOrReasonIf = { enabled }, timeout = 120.seconds, blockingTest = true) {
            Terminals.open().use(body)
        }

    onTerminals("a device has one owner, whichever of its names is used") { terminals ->
        val device = Path.of(terminals.computer).toRealPath().toString()
        Link.open(terminals.computer, settings, "agent bob").use {
            shouldThrow<PortBusyException> { Link.open(device, settings, "agent alice") }.owner() shouldBe "agent bob"
            shouldThrow<PortBusyException> { Link.open("serial:$device", settings, "agent alice") }
            Link.ownerOf(device).get() shouldBe "agent bob"
        }
        Link.open(device, settings, "agent alice").close()
    }

    onTerminals("a device that another program has locked is told with its process", withProc) { terminals ->
        val locker = ProcessBuilder("flock", "-x", terminals.computer, "sh", "-c", "echo locked; exec cat").start()
        try {
            locker.inputReader().readLine() shouldBe "locked"
            val busy = shouldThrow<PortBusyException> { SerialTransport.open(terminals.computer, settings.line()) }
            busy.owner() shouldContain "process"
            busy.owner() shouldContain locker.pid().toString()
        } finally {
            locker.descendants().forEach(ProcessHandle::destroyForcibly)
            locker.destroyForcibly().waitFor()
        }
    }

    onTerminals("a device that a transport of this program has open is busy") { terminals ->
        SerialTransport.open(terminals.computer, settings.line()).use {
            shouldThrow<PortBusyException> { SerialTransport.open(terminals.computer, settings.line()) }.owner() shouldContain
                "this program"
        }
    }

    onTerminals("an interrupt ends a read that waits for the driver to come back") { terminals ->
        SerialTransport.open(terminals.computer, settings.line()).use { line ->
            line.reading.lock() // a close with a hanging driver holds this lock
            try {
                val end = CompletableFuture<Boolean>()
                val reader = thread(isDaemon = true) {
                    val interrupted = runCatching { line.read(ByteArray(1), 0, 1, 0) }.exceptionOrNull() is PortInterruptedException
                    end.complete(interrupted && Thread.currentThread().isInterrupted)
                }
                reader.interrupt()
                end.get(LONG_MILLIS.toLong(), TimeUnit.MILLISECONDS) shouldBe true
            } finally {
                line.reading.unlock()
            }
        }
    }

    onTerminals("a line can have any rate") { terminals ->
        for (baud in listOf(300, 9_600, 31_250, 57_600, 115_200, 250_000, 1_000_000)) {
            SerialTransport.open(terminals.computer, LineSettings(baud)).use { it.line().baud() shouldBe baud }
        }
    }

    onTerminals("a port that is plugged in again under its old name can be opened again") { terminals ->
        val link = Link.open(terminals.computer, settings.withBootMillis(0), "the test")
        terminals.unplug()
        shouldThrow<PortGoneException> { link.listen(LONG_MILLIS).text() }
        Terminals.open().use { again ->
            Files.createDirectories(Path.of(terminals.computer).parent)
            Files.createSymbolicLink(Path.of(terminals.computer), Path.of(again.computer).toRealPath())
            Link.open(terminals.computer, settings, "the test").close()
        }
        link.close()
    }

    onTerminals("what was written right before a port is closed is not dropped with it") { terminals ->
        SerialTransport.open(terminals.board, settings.line()).use { end ->
            val arrived = (1..CLOSINGS).count { round ->
                SerialTransport.open(terminals.computer, settings.line()).use { it.write(byteArrayOf(round.toByte()), 0, 1, LONG_MILLIS) }
                val byte = ByteArray(1)
                end.read(byte, 0, 1, 500) == 1 && byte[0] == round.toByte()
            }
            arrived shouldBeGreaterThan CLOSINGS - 4 // a busy machine may move bytes after the close has given up
        }
    }

    onTerminals("opening and closing fifty times leaves no thread and no descriptor behind", withProc, thorough) { terminals ->
        fun cycle() {
            SerialTransport.open(terminals.board, settings.line()).use { end ->
                Link.open(terminals.computer, settings.withBootMillis(0), "the test").use { link ->
                    val listener = async { link.listen(LONG_MILLIS).text() }
                    link.sendAndAwait("ledOn", LONG_MILLIS)
                    end.readFully("fffe05ledOn".length)
                    link.close()
                    listener.failure()
                }
            }
        }
        cycle() // loads classes and the native library
        val threads = liveThreads()
        val open = openDescriptors()
        repeat(50) { cycle() }
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(20)
        while ((liveThreads() > threads || openDescriptors() > open) && System.nanoTime() < deadline) Thread.onSpinWait()
        liveThreads() shouldBeLessThan threads + 5
        openDescriptors() shouldBeLessThan open + 5
    }
})

private val thorough = setOf(NamedTag("Thorough"))
