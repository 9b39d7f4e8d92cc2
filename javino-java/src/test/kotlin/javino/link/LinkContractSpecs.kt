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

/** The contract over a pseudo-terminal. The fake board is at its other end. */
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

/** The contract over TCP. The fake board's program listens on a socket. */
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
