package javino.tcp

import io.kotest.core.test.Enabled
import javino.Line
import javino.LineSettings
import javino.TransportContract
import javino.Transports

/** A connection that the far end closes. */
internal class TcpTransportSpec : TransportContract(Enabled.enabled, {
    val server = Loopback()
    val computer = Transports.open(server.port, LineSettings.defaults())
    val board = server.accepted()
    Line(computer, board, board::close, server::close)
})

/** A connection that breaks. */
internal class BrokenTcpTransportSpec : TransportContract(Enabled.enabled, {
    val server = Loopback()
    val computer = Transports.open(server.port, LineSettings.defaults())
    val board = server.accepted(breaks = true)
    Line(computer, board, board::close, server::close)
})
