package javino.sim

import io.kotest.core.test.Enabled
import javino.Line
import javino.LineSettings
import javino.TransportContract

internal class MemoryTransportSpec : TransportContract(Enabled.enabled, {
    val line = MemoryLine.unlimited("memory", LineSettings.defaults())
    Line(line.computer(), line.board(), line::unplug) { }
})

internal class PacedMemoryTransportSpec : TransportContract(Enabled.enabled, {
    val line = MemoryLine.paced("memory", LineSettings(115_200))
    Line(line.computer(), line.board(), line::unplug) { }
})
