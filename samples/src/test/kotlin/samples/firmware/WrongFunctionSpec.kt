package samples.firmware

import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import samples.Program
import java.io.File

/** A sketch whose function does not fit an action does not compile. The compiler message tells the solution. */
@Tags("Thorough")
class WrongFunctionSpec : FunSpec({
    val library = File("../javino-arduino").canonicalFile
    val folder = tempdir()
    val compiler: EnabledOrReasonIf = {
        if (onPath("c++")) Enabled.enabled else Enabled.disabled("there is no c++: install g++ with your package manager")
    }

    fun compile(function: String, registration: String): Program.Ended {
        val sketch = folder.resolve("Sketch.cpp")
        sketch.writeText("#include <Javino.h>\nJavino javino;\n$function\nvoid setup() { $registration; }\nvoid loop() {}\n")
        return Program.run(ProcessBuilder("c++", "-std=c++11", "-Itests/stub", "-Isrc", "-fsyntax-only", "$sketch").directory(library))
    }

    mapOf(
        "void turn(int degrees) { (void)degrees; }" to
            listOf("act[\"turn\"] = turn", "act[F(\"turn\")] = turn", "onAction(\"turn\", turn)"),
        "void turn(JavinoArguments arguments) { (void)arguments; }" to listOf("act[\"turn\"] = turn", "onAction(\"turn\", turn, 1)"),
        "bool turn() { return true; }" to listOf("act[\"turn\"] = turn", "act[String(\"turn\")] = turn"),
    ).forEach { (function, registrations) ->
        registrations.forEach { registration ->
            test("$registration with $function").config(enabledOrReasonIf = compiler) {
                val compiled = compile(function, "javino.$registration")
                compiled.status shouldBe 1
                compiled.printed shouldContain "the function does not fit"
                compiled.printed shouldContain "onAction(\"name\", function)"
            }
        }
    }

    mapOf(
        "void turn() {}" to "act[\"turn\"] = turn",
        "void turn(JavinoBoard &board) { (void)board; }" to "act[F(\"turn\")] = turn",
        "bool turn() { return true; }" to "onAction(\"turn\", turn)",
        "void turn(const JavinoArguments &arguments) { (void)arguments; }" to "onAction(\"turn\", turn, 1)",
        "bool turn(JavinoBoard &, const JavinoArguments &) { return true; }" to "onAction(F(\"turn\"), turn)",
    ).forEach { (function, registration) ->
        test("$registration with $function compiles").config(enabledOrReasonIf = compiler) {
            val compiled = compile(function, "javino.$registration")
            withClue(compiled.printed) { compiled.status shouldBe 0 }
        }
    }
})
