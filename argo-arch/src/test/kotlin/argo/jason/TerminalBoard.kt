package argo.jason

import io.kotest.core.test.Enabled
import javino.LineSettings
import javino.PortException
import javino.Transports
import javino.sim.FakeBoard
import javino.sim.PseudoTerminals
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/** Enabled if this system has pseudo-terminals. */
internal val withTerminals: Enabled =
    if (PseudoTerminals.available()) Enabled.enabled
    else Enabled.disabled("needs pseudo-terminals, and socat, which makes them, is not installed")

/** A fake board at the far end of a pseudo-terminal. For the computer, closing it looks like a pulled cable. */
internal class TerminalBoard(board: FakeBoard) : AutoCloseable {
    private val terminals = PseudoTerminals.open()
    private val end = Transports.open(terminals.board().path, LineSettings(115_200))
    private val program = thread(isDaemon = true) {
        try {
            board.program().run(end)
        } catch (_: PortException) {
            // the cable was pulled
        }
    }

    /** The device itself, not a link to it. */
    val device: Path = terminals.computer().toPath().toRealPath()

    override fun close() {
        terminals.close()
        end.close()
        program.join(TimeUnit.SECONDS.toMillis(20))
    }
}

/** Makes this path a link to [device]. If [device] is null, only deletes the link. */
internal fun Path.pointTo(device: Path?) {
    Files.deleteIfExists(this)
    if (device != null) Files.createSymbolicLink(this, device)
}
