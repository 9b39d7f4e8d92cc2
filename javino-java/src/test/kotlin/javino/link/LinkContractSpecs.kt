package javino.link

import io.kotest.core.test.Enabled
import javino.PortGoneException
import javino.Transport
import javino.Transports
import javino.async
import javino.serial.Terminals
import javino.sim.FakeBoard
import javino.tcp.Loopback
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger

private val boards = AtomicInteger()

internal class SimulatedLinkSpec : LinkContract(Enabled.enabled, {
    val board = FakeBoard.plugIn("contract${boards.incrementAndGet()}").lenient()
    Bench(board.port(), board, board::unplug, board::close)
})

/** The same, through the operating system: the fake board sits at the other end of a pseudo-terminal. */
internal class SerialLinkSpec : LinkContract(Terminals.available, {
    val terminals = Terminals.open()
    val board = FakeBoard.plugIn("contract${boards.incrementAndGet()}").lenient()
    val end = Transports.open(terminals.board, Bench.FAST.line())
    val running = async { board.program().run(end) }
    board.awaitOpen(10_000)
    Bench(terminals.computer, board, terminals::unplug) {
        end.close()
        running.handle { _, _ -> }.get(20, TimeUnit.SECONDS)
        terminals.close()
        board.close()
    }
})

/** The same, over a network: the fake board is a program that listens. */
internal class TcpLinkSpec : LinkContract(Enabled.enabled, {
    val server = Loopback()
    val board = FakeBoard.plugIn("contract${boards.incrementAndGet()}").lenient()
    val ends = ConcurrentLinkedQueue<Transport>()
    val running = async {
        while (true) server.accepted(Bench.FAST.line()).use { end ->
            ends += end
            try {
                board.program().run(end)
            } catch (_: PortGoneException) {
                // the next one may connect
            }
        }
    }
    Bench(server.port, board, { ends.forEach(Transport::close) }) {
        server.close()
        ends.forEach(Transport::close)
        running.handle { _, _ -> }.get(20, TimeUnit.SECONDS)
        board.close()
    }
})
