package javino

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.throwables.shouldThrowAny
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeInstanceOf
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.time.Duration.Companion.seconds

/** Two ends of one line, and a function that unplugs it. */
internal class Line(
    val computer: Transport, val board: Transport, val unplug: () -> Unit, private val release: () -> Unit,
) : AutoCloseable {
    override fun close() {
        computer.close()
        board.close()
        release()
    }
}

private const val LONG_MILLIS = 60_000

/** The contract of every transport. A subclass supplies the line. */
internal abstract class TransportContract(available: Enabled, open: () -> Line) : FunSpec({
    fun contract(name: String, body: Line.() -> Unit) =
        test(name).config(enabledOrReasonIf = { available }, timeout = 60.seconds, blockingTest = true) { open().use(body) }

    contract("bytes arrive at the other end, as they are and in their order") {
        val bytes = ByteArray(256) { it.toByte() }
        computer.write(bytes, 0, bytes.size, LONG_MILLIS)
        board.readFully(256) shouldBe bytes
        board.write(bytes, 10, 20, LONG_MILLIS)
        computer.readFully(20) shouldBe bytes.copyOfRange(10, 30)
    }

    contract("a read fills the array from its offset, and takes no more than was asked for") {
        board.write("abcdef".toByteArray(), 0, 6, LONG_MILLIS)
        val array = "......".toByteArray()
        var filled = 0
        while (filled < 3) filled += computer.read(array, 2 + filled, 3 - filled, LONG_MILLIS)
        array.decodeToString() shouldBe "..abc."
        computer.readFully(3).decodeToString() shouldBe "def"
    }

    contract("a read of a silent line returns 0 when its time is over") {
        for (timeout in listOf(0, 1, 30, 120)) {
            val start = System.nanoTime()
            computer.read(ByteArray(8), 0, 8, timeout) shouldBe 0
            check(System.nanoTime() - start >= TimeUnit.MILLISECONDS.toNanos(timeout.toLong())) { "returned before $timeout ms were over" }
        }
    }

    contract("a read that waits returns as soon as a byte arrives") {
        val reader = async { computer.readFully(1).decodeToString() }
        board.write("x".toByteArray(), 0, 1, LONG_MILLIS)
        reader.get(20, TimeUnit.SECONDS) shouldBe "x"
    }

    contract("one thread reads while another writes") {
        val echo = async { repeat(50) { board.write(board.readFully(4), 0, 4, LONG_MILLIS) } }
        val reader = async { computer.readFully(200) }
        val sent = ByteArray(200) { it.toByte() }
        for (start in sent.indices step 4) computer.write(sent, start, 4, LONG_MILLIS)
        reader.get(20, TimeUnit.SECONDS) shouldBe sent
        echo.get(20, TimeUnit.SECONDS)
    }

    contract("a read that waits ends when the plug is pulled") {
        val reader = async { computer.read(ByteArray(8), 0, 8, LONG_MILLIS) }
        unplug()
        reader.failure().shouldBeInstanceOf<PortGoneException>().message shouldContain "gone"
    }

    contract("once the plug is pulled, reads and writes throw") {
        unplug()
        shouldThrow<PortGoneException> { computer.read(ByteArray(8), 0, 8, LONG_MILLIS) }.port() shouldBe computer.name()
        shouldThrow<PortGoneException> { computer.read(ByteArray(8), 0, 8, 0) }
        shouldThrow<PortGoneException> { computer.write(ByteArray(8), 0, 8, LONG_MILLIS) }
    }

    contract("a write has a time limit when the far end does not read, and says so") {
        val block = ByteArray(4096)
        val timeout = shouldThrow<PortTimeoutException> { repeat(100) { computer.write(block, 0, block.size, 50) } }
        timeout.message shouldContain "50 ms"
    }

    contract("a write that waits ends when the plug is pulled") {
        val writer = async { repeat(100) { computer.write(ByteArray(4096), 0, 4096, LONG_MILLIS) } }
        board.readFully(1)
        unplug()
        writer.failure().shouldBeInstanceOf<PortGoneException>()
    }

    contract("a write that waits ends when the line is closed") {
        val writer = async { repeat(100) { computer.write(ByteArray(4096), 0, 4096, LONG_MILLIS) } }
        board.readFully(1)
        computer.close()
        writer.failure().shouldBeInstanceOf<PortGoneException>()
    }

    contract("a read that waits ends when the line is closed") {
        val started = CompletableFuture<Unit>()
        val reader = async {
            started.complete(Unit)
            computer.read(ByteArray(8), 0, 8, LONG_MILLIS)
        }
        started.get()
        computer.close()
        reader.failure().shouldBeInstanceOf<PortGoneException>().message shouldContain "closed"
    }

    contract("after closing, which may be done twice, reads and writes throw") {
        computer.close()
        computer.close()
        shouldThrow<PortGoneException> { computer.read(ByteArray(8), 0, 8, 0) }
        shouldThrow<PortGoneException> { computer.write(ByteArray(8), 0, 8, 10) }
    }

    contract("an interrupted read throws, and the thread stays interrupted") {
        val interrupted = CompletableFuture<Boolean>()
        val failure = CompletableFuture<Throwable>()
        val reader = thread(isDaemon = true) {
            failure.complete(shouldThrowAny { computer.read(ByteArray(8), 0, 8, LONG_MILLIS) })
            interrupted.complete(Thread.currentThread().isInterrupted)
        }
        reader.interrupt()
        failure.get(20, TimeUnit.SECONDS).shouldBeInstanceOf<PortInterruptedException>()
        interrupted.get(20, TimeUnit.SECONDS) shouldBe true
        board.write("x".toByteArray(), 0, 1, LONG_MILLIS)
        computer.readFully(1).decodeToString() shouldBe "x"
    }
})

internal fun Transport.readFully(count: Int): ByteArray {
    val bytes = ByteArray(count)
    var filled = 0
    while (filled < count) {
        val read = read(bytes, filled, count - filled, LONG_MILLIS)
        check(read > 0) { "nothing came" }
        filled += read
    }
    return bytes
}

internal fun <T> async(work: () -> T): CompletableFuture<T> {
    val result = CompletableFuture<T>()
    thread(isDaemon = true) { runCatching(work).fold(result::complete, result::completeExceptionally) }
    return result
}

internal fun CompletableFuture<*>.failure(): Throwable =
    checkNotNull(shouldThrow<ExecutionException> { get(20, TimeUnit.SECONDS) }.cause)
