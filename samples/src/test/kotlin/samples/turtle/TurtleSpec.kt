package samples.turtle

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.ASSyntax.parseLiteral
import samples.Program
import samples.project.MasRun
import samples.project.SampleProject
import java.util.concurrent.TimeUnit

private const val LIMIT_S = 60L

class TurtleSpec : FunSpec({
    test("the turtle stops before the wall and comes home") {
        Program.samples("turtle").use { program ->
            listOf("[turtle] drives", "[turtle] stopped ", "[turtle] docked").forEach(program::awaitLine)
            program.awaitEnd().first shouldBe 0
        }
    }

    test("a robot that is not there ends the sample with the reason") {
        val (status, printed) = Program.run("turtle", "--port", "ros://127.0.0.1:1#turtle/turtle")
        printed shouldContain "nothing listens at 127.0.0.1:1"
        status shouldBe 1
    }

    test("the agent of the sample collision stops it, unchanged but for its port") {
        val turtle = Turtle(System::nanoTime)
        TurtleBridge(turtle).use { bridge ->
            val project = SampleProject("collision").apply {
                val beliefs = listOf("board(\"${bridge.port}#turtle/collision\", [])", "value(40)", "interval(20)", "view(none)")
                believe("robot", *beliefs.map(::parseLiteral).toTypedArray())
            }
            val mas = MasRun(project)
            mas.begin()
            try {
                val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(LIMIT_S)
                while (turtle.position == 0.0 || turtle.isDriving) {
                    check(System.nanoTime() < deadline) { "it drives ${turtle.isDriving}, at ${turtle.position} m" }
                    Thread.onSpinWait()
                }
                turtle.range shouldBeGreaterThan 0.0
            } finally {
                mas.end()
            }
        }
    }
})
