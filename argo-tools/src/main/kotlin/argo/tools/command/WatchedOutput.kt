package argo.tools.command

import java.io.FilterOutputStream
import java.io.IOException
import java.io.OutputStream

/** Remembers why nothing could be written to [target], which neither a [java.io.PrintWriter] on it nor `System.out` would tell. */
internal class WatchedOutput(private val target: OutputStream) : FilterOutputStream(target) {
    /** Why it could not be written to, the first time; null: it always could. */
    var trouble: IOException? = null
        private set

    /** Whether that was only since nobody reads on, as in `monitor PORT | head`; systems say so in their own words, of which this is one. */
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
