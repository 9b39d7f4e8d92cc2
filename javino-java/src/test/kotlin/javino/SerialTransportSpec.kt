package javino

internal class SerialTransportSpec : TransportContract(PseudoTerminals.available, {
    val terminals = PseudoTerminals.open()
    val line = LineSettings(115_200)
    Line(SerialTransport.open(terminals.computer, line), SerialTransport.open(terminals.board, line), terminals::unplug, terminals::close)
})
