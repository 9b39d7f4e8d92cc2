package argo.tools

import java.io.PrintWriter
import java.io.StringWriter

internal data class Output(val status: Int, val out: String, val err: String)

internal fun argo(vararg arguments: String): Output {
    val out = StringWriter()
    val err = StringWriter()
    val status = tools().setOut(PrintWriter(out, true)).setErr(PrintWriter(err, true)).execute(*arguments)
    return Output(status, "$out", "$err")
}
