package argo.fleet

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldEndWith
import java.io.File
import kotlin.io.path.writeText

class MainSpec : FunSpec({
    test("Jason without its libraries is told in words") {
        val project = tempdir().toPath().resolve("garden.mas2j")
        project.writeText("MAS garden { infrastructure: Fleet agents: a at \"base\"; }")
        val path = System.getProperty("java.class.path").split(File.pathSeparator).filterNot { "javax.json" in it }
        val java = listOf(File(System.getProperty("java.home"), "bin/java").path, "-cp", path.joinToString(File.pathSeparator))
        val fleet = ProcessBuilder(java + listOf("argo.fleet.MainKt", "$project", "--at", "base")).redirectErrorStream(true).start()
        fleet.inputReader().readText() shouldEndWith "Jason runs without a class that it needs, javax.json.JsonValue: put all of Jason's " +
            "libraries beside jason-interpreter.jar, and name their folder, as --class-path 'lib/*'\n"
        fleet.waitFor() shouldBe 1
    }
})
