package argo.build

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith

/** What `./argo` prints itself. */
class FrontDoorSpec : FunSpec({
    fun bash(vararg command: String): Pair<Int, String> {
        val process = ProcessBuilder("bash", *command).redirectErrorStream(true).start()
        val said = process.inputStream.readBytes().decodeToString()
        return process.waitFor() to said
    }

    test("a build shows its own modules, and none of the build before") {
        val logs = tempdir().toPath()
        val log = logs.resolve("build.log")
        fun building(module: String) = "echo '[INFO] Building $module 0.1.0 [1/4]'"
        // the shell opens the log for the build in the background at a time of its own, mostly early enough
        val rounds = """
            . ../argo; logs='$logs'
            mvn() { ${building("later")}; }
            tail() { printf '%s\\n' "$(<'$log')"; }
            for round in {1..60}; do ${building("earlier")} >'$log'; maven '$log'; done
        """
        bash("-c", rounds).second shouldNotContain "earlier"
    }

    mapOf("" to "formatting", "--check" to "checking the format").forEach { (option, work) ->
        test("./argo format $option says first what it does and how long that takes") {
            val folder = tempdir().toPath()
            val set = "touch '$folder/format.classpath'; printf '#!/bin/sh' >'$folder/java'; chmod +x '$folder/java'; PATH=$folder:\$PATH"
            bash("-c", "$set; . ../argo; logs='$folder'; format $option").second shouldStartWith "$work; takes about "
        }
    }

    listOf("bench", "bench a b", "bench latency soak", "bench fly").forEach { line ->
        test("./argo $line is refused before anything is built, with exit status 2") {
            val (status, said) = bash("../argo", *line.split(' ').toTypedArray())
            said shouldStartWith "./argo: bench takes one of latency, filters, realtime, stops, boards, bounds, faults and soak, not: "
            said shouldContain line.removePrefix("bench").trim().ifEmpty { "nothing" }
            status shouldBe 2
        }
    }
})
