package argo.jason

import argo.FussyProvider
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.Transport
import javino.sim.FakeBoard
import java.util.concurrent.atomic.AtomicReference

/** A line that throws [fault] once. If [reading] is true, the fault comes at a read, else at a write. */
private class FaultyLine(private val line: Transport, private val reading: Boolean, private val fault: AtomicReference<Throwable?>) :
    Transport by line {
    override fun isWritableNow(unread: Long) = line.isWritableNow(unread)

    override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int {
        if (reading) fault.getAndSet(null)?.let { throw it }
        return line.read(b, off, len, timeoutMillis)
    }

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) {
        if (!reading) fault.getAndSet(null)?.let { throw it }
        line.write(b, off, len, timeoutMillis)
    }
}

class FaultyLineSpec : FunSpec({
    afterTest { FussyProvider.opening = FussyProvider::openSimulated }

    for (isRead in listOf(true, false)) for (error in listOf(OutOfMemoryError("planted"), StackOverflowError("planted"))) {
        test("${error.javaClass.simpleName} in ${if (isRead) "reading" else "writing"} ends no thread: the agent perceives and acts") {
            val fault = AtomicReference<Throwable?>()
            FussyProvider.opening = { address, line -> FaultyLine(FussyProvider.openSimulated(address, line), isRead, fault) }
            FakeBoard.plugIn("robot").lenient().use { board ->
                var n = 0
                board.whenAsked("getPercepts").answer { "count(${++n});" }
                LocalMas().use { mas ->
                    mas.agent("bob", """
                        !start.
                        +!start <- argo.port("fussy:robot", [baud(1000000), boot(0)]); argo.limit(5); argo.percepts(open).
                        +count(N) <- argo.act(saw(N)).
                        -!G[error(E)] <- .print(E).
                    """)
                    eventually(LIMIT) { board.received().count { it.startsWith("saw") } shouldBeGreaterThan 5 }
                    repeat(3) {
                        fault.set(error)
                        eventually(LIMIT) { fault.get() shouldBe null }
                        val before = board.received().count { it.startsWith("saw") }
                        eventually(LIMIT) { board.received().count { it.startsWith("saw") } shouldBeGreaterThan before + 5 }
                    }
                    mas.awaitBelief("bob", "port(\"fussy:robot\",on)")
                    mas.log shouldContain "planted"
                }
            }
        }
    }
})
