package argo.view.timeline

import argo.tools.command.refusingInWords
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import picocli.CommandLine
import java.io.PrintWriter
import java.io.StringWriter

class ViewCommandSpec : FunSpec({
    mapOf("no-such.mcap" to "there is no file no-such.mcap", "src" to "src is a folder, no file").forEach { (file, why) ->
        test("$file is a failure, as of the other tools, and no wrong argument") {
            val err = StringWriter()
            CommandLine(ViewCommand()).refusingInWords("command").setErr(PrintWriter(err, true)).execute(file) shouldBe 1
            "$err" shouldBe "$why${System.lineSeparator()}"
        }
    }
})
