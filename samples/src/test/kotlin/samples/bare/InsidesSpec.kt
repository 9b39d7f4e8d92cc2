package samples.bare

import argo.insides.Insides
import argo.insides.WaitEvents
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.io.File

/** The private members that ARGO uses by reflection exist in each supported Jason version. */
class InsidesSpec : FunSpec({
    val recentJava: EnabledOrReasonIf = {
        if (newestJava().feature >= 21) Enabled.enabled
        else Enabled.disabled("Jason 3.3.0 needs Java 21 or newer, the newest here is ${newestJava().feature}")
    }

    test("in Jason 3.2.1") {
        Insides.all.size shouldBeGreaterThan 30
        missingInsides().shouldBeEmpty()
    }

    test("in Jason 3.3.0, on Java 21 or newer").config(enabledOrReasonIf = recentJava) {
        val others = System.getProperty("java.class.path").split(File.pathSeparator).filterNot { "jason-interpreter" in it }
        val path = (listOf(System.getProperty("newest.jason.jar")) + others).joinToString(File.pathSeparator)
        val process = ProcessBuilder(newestJava().program, "-cp", path, "samples.bare.InsidesSpecKt").redirectErrorStream(true).start()
        process.inputReader().readText().trim() shouldBe "3.3.0, missing: []"
    }
})

private fun missingInsides(): List<String> =
    Insides.all.filterNot { it.isThere }.map { "$it" } + listOf("WaitEvents").filterNot { WaitEvents.isThere }

/** Prints the Jason version on the class path and its missing members. */
fun main() = println("${jason.util.Config.get().jasonVersion}, missing: ${missingInsides()}")
