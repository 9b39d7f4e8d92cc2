package argo.filters

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FreeSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.jetbrains.kotlin.cli.common.ExitCode
import org.jetbrains.kotlin.cli.jvm.K2JVMCompiler
import java.io.ByteArrayOutputStream
import java.io.PrintStream

/** What the compiler makes of [statements] in a filter over a distance with a side and centimetres. */
private fun FreeSpec.compile(statements: String): Pair<ExitCode, String> {
    val directory = tempdir()
    val source = directory.resolve("Snippet.kt")
    source.writeText(
        """
        import argo.filters.*

        object Distance : PerceptType("distance") {
            val side by atom()
            val cm by number()
            val label by string()
        }

        fun snippet() {
            $statements
        }
        """.trimIndent(),
    )
    val messages = ByteArrayOutputStream()
    val classPath = System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")
    val exit = K2JVMCompiler().exec(PrintStream(messages), "-no-stdlib", "-no-reflect", "-classpath", classPath, "-jvm-target", "17", "-d", directory.resolve("out").path, source.path)
    return exit to messages.toString()
}

class TypeSafetySpec : FreeSpec({
    "what makes sense compiles" {
        val (exit, messages) = compile(
            """
            perceptionFilter("near") { drop(Distance) { side ne "front"; cm gt 200; label matches "a.*" }; drop("light") { argument(0) gt 3 } }
            keepingFilter("far") { keep(Distance) { cm ge 200.5 }; keep("light") }
            """,
        )
        withClue(messages) { exit shouldBe ExitCode.OK }
    }

    "what makes no sense does not compile" - {
        listOf(
            "a side is not compared with a number" to """perceptionFilter("x") { drop(Distance) { side gt 3 } }""",
            "a side does not equal a number" to """perceptionFilter("x") { drop(Distance) { side eq 3 } }""",
            "a side is in no list of numbers" to """perceptionFilter("x") { drop(Distance) { side isIn listOf(1, 2) } }""",
            "centimetres do not equal a side" to """perceptionFilter("x") { drop(Distance) { cm eq "front" } }""",
            "a number matches no pattern" to """perceptionFilter("x") { drop(Distance) { cm matches "1.*" } }""",
            "a string has no order" to """perceptionFilter("x") { drop(Distance) { label lt "b" } }""",
            "a side has no deadband" to """perceptionFilter("x") { drop(Distance) { side deadband 3 } }""",
            "an argument that is not declared" to """perceptionFilter("x") { drop(Distance) { speed gt 3 } }""",
            "a rule in a rule" to """perceptionFilter("x") { drop("a") { drop("b") } }""",
            "a rule in a typed rule" to """perceptionFilter("x") { drop(Distance) { drop("b") } }""",
            "an argument outside a rule" to """perceptionFilter("x") { argument(0) eq 1 }""",
            "a typed argument outside a rule" to """perceptionFilter("x") { Distance.cm eq 1 }""",
            "an argument by number in a typed rule" to """perceptionFilter("x") { drop(Distance) { argument(0) eq 1 } }""",
            "keep in a filter that drops" to """perceptionFilter("x") { keep("a") }""",
            "drop in a filter that keeps" to """keepingFilter("x") { drop("a") }""",
            "an annotation's test outside an annotation" to """perceptionFilter("x") { drop("a") { gt(1) } }""",
            "a condition of the rule in an annotation's tests" to """perceptionFilter("x") { drop("a") { annotation("q") { everyMs(1) } } }""",
            "an argument declared outside its type" to """Distance.atom()""",
        ).forEach { (what, statements) ->
            what {
                val (exit, messages) = compile(statements)
                withClue(messages) {
                    exit shouldBe ExitCode.COMPILATION_ERROR
                    messages shouldContain "Snippet.kt:10:"
                }
            }
        }
    }
})
