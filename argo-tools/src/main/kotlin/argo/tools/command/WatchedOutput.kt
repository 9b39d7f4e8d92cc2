package argo.tools.command

import java.io.FilterOutputStream
import java.io.IOException
import java.io.OutputStream

/** Records why a write to [target] failed. Neither a [java.io.PrintWriter] nor `System.out` reports the reason. */
internal class WatchedOutput(private val target: OutputStream) : FilterOutputStream(target) {
    /** The first failure; null: none. */
    var trouble: IOException? = null
        private set

    /** True if the reader has gone, as in `monitor PORT | head`. The system's message then contains "pipe". */
    val hasReaderGone: Boolean get() = trouble?.message.orEmpty().contains("pipe", ignoreCase = true)

    override fun write(byte: Int) = watched { target.write(byte) }

    override fun write(bytes: ByteArray, offset: Int, length: Int) = watched { target.write(bytes, offset, length) }

    override fun flush() = watched { target.flush() }

    private fun watched(work: () -> Unit) = try {
        work()
    } catch (failure: IOException) {
        if (trouble == null) trouble = failure
        throw failure
    }
}
