package samples.turtle

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.ASSyntax.parseLiteral
import samples.Program
import samples.project.MasRun
import samples.project.SampleProject
import java.util.concurrent.TimeUnit

private const val LIMIT_S = 60L

class TurtleSpec : FunSpec({
    test("the turtle drives to the one that turtlesim has spawned for it") {
        Program.samples("turtle").use { program ->
            listOf("[turtle] goes to turtle2", "[turtle] is there").forEach(program::awaitLine)
            program.awaitEnd().status shouldBe 0
        }
    }

    test("a robot that is not there ends the sample with the reason") {
        val (status, printed) = Program.run("turtle", "--port", "ros://127.0.0.1:1#turtle/turtle")
        printed shouldContain "nothing listens at 127.0.0.1:1"
        status shouldBe 1
    }

    test("the agent of the sample collision stops it, unchanged but for its port") {
        TurtleBridge().use { bridge ->
            val project = SampleProject("collision").apply {
                val beliefs = listOf("board(\"${bridge.port}#turtle/collision\", [])", "value(40)", "interval(20)", "view(none)")
                believe("robot", *beliefs.map(::parseLiteral).toTypedArray())
            }
            val mas = MasRun(project)
            mas.begin()
            try {
                val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(LIMIT_S)
                while (bridge.turtle.pose.let { it.x < Turtle.WINDOW - 2 || it.speed != 0.0 }) {
                    check(System.nanoTime() < deadline) { "it is at ${bridge.turtle.pose}" }
                    Thread.sleep(1)
                }
                bridge.turtle.pose.x shouldBeLessThan Turtle.WINDOW
            } finally {
                mas.end()
            }
        }
    }
})
