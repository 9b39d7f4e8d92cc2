package argo.view.timeline

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import picocli.CommandLine
import java.io.PrintWriter
import java.io.StringWriter

/** `view` without anything to show. */
class ViewCommandSpec : FunSpec({
    test("a recording that is not there is a failure, as of the other tools, and no wrong argument") {
        val err = StringWriter()
        CommandLine(ViewCommand()).setErr(PrintWriter(err, true)).execute("no-such.mcap") shouldBe 1
        "$err" shouldBe "there is no file no-such.mcap${System.lineSeparator()}"
    }
})
