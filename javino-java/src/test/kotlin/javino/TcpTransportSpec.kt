package javino

import io.kotest.core.test.Enabled

/** A connection that the far end closes. */
internal class TcpTransportSpec : TransportContract(Enabled.enabled, {
    val server = Loopback()
    val computer = Transports.open(server.port, LineSettings.defaults())
    val board = TcpTransport.over(server.accept(), "the board's end", LineSettings.defaults())
    Line(computer, board, board::close, server::close)
})

/** A connection that breaks. */
internal class BrokenTcpTransportSpec : TransportContract(Enabled.enabled, {
    val server = Loopback()
    val computer = Transports.open(server.port, LineSettings.defaults())
    val board = TcpTransport.over(server.accept(breaks = true), "the board's end", LineSettings.defaults())
    Line(computer, board, board::close, server::close)
})
