package javino.serial

import javino.Line
import javino.LineSettings
import javino.TransportContract

internal class SerialTransportSpec : TransportContract(Terminals.available, {
    val terminals = Terminals.open()
    val line = LineSettings(115_200)
    Line(SerialTransport.open(terminals.computer, line), SerialTransport.open(terminals.board, line), terminals::unplug, terminals::close)
})
