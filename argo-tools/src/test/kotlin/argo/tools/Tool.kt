package argo.tools

import java.io.PrintWriter
import java.io.StringWriter

/** What a command printed, and its exit status. */
internal data class Said(val status: Int, val out: String, val err: String)

/** Runs the tools in this program. */
internal fun argo(vararg arguments: String): Said {
    val out = StringWriter()
    val err = StringWriter()
    val status = tools().setOut(PrintWriter(out, true)).setErr(PrintWriter(err, true)).execute(*arguments)
    return Said(status, "$out", "$err")
}
