package argo.sensing

import argo.connecting.OpenPort
import argo.connecting.PortOptions
import argo.links.BoardLink
import argo.links.BoardMessage
import argo.links.JavinoLink
import argo.platform.Platform
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import jason.asSyntax.ASSyntax
import jason.asSyntax.Term
import javino.LineClock
import javino.LineSettings
import javino.PortException
import javino.PortTimeoutException
import javino.Protocol
import javino.Transport
import javino.interleavings.concurrently
import javino.interleavings.inEachInterleaving
import javino.link.Link
import javino.link.LinkSettings
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.Condition

/** Thrown when the board is asked for its percepts, to end the sensing thread. */
private class Asked : Error()

/** The time and the threads of one port's sensing. A wait of 50 ms or more ends only by a signal, so that the test finds a lost signal. */
private class SensingTime : Platform, LineClock {
    @Volatile
    private var now = 0L
    lateinit var run: () -> Unit
        private set

    override val clock get() = this

    override fun nanos() = now

    override fun await(condition: Condition, nanos: Long) =
        if (nanos < TimeUnit.MILLISECONDS.toNanos(50)) pass(nanos) else condition.await()

    fun pass(nanos: Long) {
        now += nanos
    }

    override fun start(name: String, run: () -> Unit): Thread {
        this.run = run
        return Thread.currentThread()
    }

    override fun later(delayMs: Long, action: () -> Unit) = error("nothing is timed")

    override fun open(port: String, settings: LinkSettings, owner: String): BoardLink =
        JavinoLink(Link.over(SilentLine(this), settings, this))
}

private class SilentLine(private val time: SensingTime) : Transport {
    override fun name() = "silent"

    override fun line() = LineSettings(115_200)

    override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int {
        time.pass(TimeUnit.MILLISECONDS.toNanos(timeoutMillis.toLong()))
        return 0
    }

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) = throw Asked()

    override fun close() = Unit
}

private class Wishes : SensingListener {
    @Volatile
    var isPerceiving = false

    @Volatile
    var isInUse = false
    override val intervalMs get() = 50

    override fun isSensed(port: OpenPort) = isPerceiving && isInUse

    override fun request(port: OpenPort) = "getPercepts"

    override fun mayReport(port: OpenPort) = false

    override fun received(port: OpenPort, message: BoardMessage, askedNanos: Long) = error("the board is silent")

    override fun unanswered(port: OpenPort, trouble: PortTimeoutException) = error("unanswered")

    override fun answeredAgain(port: OpenPort) = error("the board is silent")

    override fun lost(port: OpenPort, trouble: PortException): Unit = throw trouble.cause as? Asked ?: error("lost: $trouble")
}

@Tags("Thorough")
class SensingInterleavingsSpec : FunSpec({
    val names = mapOf<Term, String>(ASSyntax.createAtom("p") to "silent")
    val options = PortOptions(LinkSettings.defaults().withProtocol(Protocol.V1))

    test("a board is asked once its agent perceives and its port is in use, whichever thread sees to which and last") {
        inEachInterleaving {
            val time = SensingTime()
            val wishes = Wishes()
            val port = OpenPort(names, time.open("silent", options.link, "agent"), options, 0, 0) { AutoCloseable { } }
            val sensing = Sensing(port, "agent", wishes, time)
            sensing.start()
            concurrently(
                {
                    wishes.isPerceiving = true
                    sensing.wake()
                },
                {
                    wishes.isInUse = true
                    sensing.wake()
                },
                {
                    try {
                        time.run()
                    } catch (_: Asked) {
                        // the expected request has come
                    }
                },
            )
        }
    }
})
