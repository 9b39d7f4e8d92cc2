package javino

internal class SerialTransportSpec : TransportContract(Terminals.available, {
    val terminals = Terminals.open()
    val line = LineSettings(115_200)
    Line(SerialTransport.open(terminals.computer, line), SerialTransport.open(terminals.board, line), terminals::unplug, terminals::close)
})
