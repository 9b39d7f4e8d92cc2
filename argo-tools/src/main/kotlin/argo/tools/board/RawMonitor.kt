package argo.tools.board

import argo.tools.command.ExitStatus
import argo.tools.command.Paint
import argo.tools.command.counted
import javino.PortInterruptedException
import javino.Transport
import java.io.PrintWriter
import java.util.concurrent.TimeUnit

/** Shows all bytes from [line]. Starts a new output line after each line of text and after each pause. */
internal class RawMonitor(private val line: Transport, private val out: PrintWriter, private val paint: Paint) {
    private val start = System.nanoTime()
    private val buffer = ByteArray(BUFFER)
    private val pending = StringBuilder()
    private var lines = 0
    private var bytes = 0L

    /** Runs until an interruption, for at most [count] lines and [seconds] s. Null means no limit. Returns the exit status. */
    fun run(count: Int?, seconds: Int?): Int {
        try {
            while (lines < (count ?: Int.MAX_VALUE) && (seconds == null || ms() < TimeUnit.SECONDS.toMillis(seconds.toLong()))) read()
        } catch (_: PortInterruptedException) {
            Thread.interrupted() // Ctrl-C must not interrupt the summary
        }
        print()
        out.println("${counted(bytes, "byte")} in ${Rates.seconds(ms())} s at ${line.line().baud()} baud")
        out.flush()
        return if (bytes == 0L) ExitStatus.FAILED else ExitStatus.DONE
    }

    private fun read() {
        val length = line.read(buffer, 0, BUFFER, PAUSE_MS)
        if (length == 0) return print()
        bytes += length
        for (i in 0 until length) {
            val octet = buffer[i].toInt() and 0xFF
            pending.append(shown(octet.toChar()))
            if (octet == '\n'.code || pending.length >= WIDTH) print()
        }
    }

    private fun print() {
        if (pending.isEmpty()) return
        out.println("${paint.aside("${Rates.seconds(ms()).padStart(TIME_WIDTH)} s")}  $pending")
        out.flush()
        pending.setLength(0)
        lines++
    }

    private fun shown(c: Char) = when (c) {
        '\n' -> "\\n"
        '\r' -> "\\r"
        in ' '..'~' -> "$c"
        else -> "\\x%02X".format(c.code)
    }

    private fun ms() = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - start)

    private companion object {
        const val BUFFER = 256
        const val PAUSE_MS = 200
        const val WIDTH = 100
        const val TIME_WIDTH = 8
    }
}
