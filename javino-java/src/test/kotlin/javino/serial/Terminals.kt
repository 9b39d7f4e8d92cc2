package javino.serial

import io.kotest.core.test.Enabled
import javino.sim.PseudoTerminals

internal class Terminals private constructor(private val pair: PseudoTerminals) : AutoCloseable {
    val computer: String = pair.computer().path
    val board: String = pair.board().path

    /** Removes both terminals. For each end the other end is gone. */
    fun unplug() = pair.close()

    override fun close() = pair.close()

    companion object {
        val available: Enabled =
            if (PseudoTerminals.available()) Enabled.enabled
            else Enabled.disabled("needs pseudo-terminals, and socat, which makes them, is not installed")

        fun open() = Terminals(PseudoTerminals.open())
    }
}
