package argo.tools.command

import java.io.FilterOutputStream
import java.io.IOException
import java.io.OutputStream

/** Stores why a write to [target] failed. A [java.io.PrintWriter] and `System.out` only report that it failed. */
internal class WatchedOutput(private val target: OutputStream) : FilterOutputStream(target) {
    var trouble: IOException? = null
        private set

    /** True if the reader of the output has ended, as in `monitor PORT | head`. The operating system's message then contains "pipe". */
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
