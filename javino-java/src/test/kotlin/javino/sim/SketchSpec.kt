package javino.sim

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.Link
import javino.LinkSettings
import javino.PortException
import javino.Protocol
import javino.logged

private const val LIMIT_MS = 10_000
private val SETTINGS = LinkSettings.defaults().withBaud(1_000_000).withBootMillis(0)

/** Shows the percepts that it was given, and keeps the commands that it knows. */
private class Wall(private val shown: () -> List<String>) : Sketch {
    val commands = ArrayList<String>()

    override fun percepts() = shown()

    override fun act(command: String) = (command == "stop").also { if (it) commands += command }
}

private fun plugged(sketch: Sketch, protocol: Protocol, use: (Link) -> Unit) {
    SimulatedBoards.plugIn("sketch", sketch)
    try {
        Link.open("sim:sketch", SETTINGS.withProtocol(protocol), "the test").use(use)
    } finally {
        SimulatedBoards.unplug("sketch")
    }
}

class SketchSpec : FunSpec({
    for (protocol in listOf(Protocol.V1, Protocol.V2)) {
        test("its percepts answer each request, and its commands are carried out, in $protocol") {
            var cm = 90
            val wall = Wall { listOf("dist(front,${cm--})", "light(3)") }
            plugged(wall, protocol) { link ->
                List(2) { link.request("getPercepts", LIMIT_MS).text() } shouldContainExactly
                    listOf("dist(front,90);light(3);", "dist(front,89);light(3);")
                link.sendAndAwait("stop", LIMIT_MS)
                link.request("getPercepts", LIMIT_MS)
            }
            wall.commands shouldContainExactly listOf("stop")
        }
    }

    test("a command that it does not have is refused in version 2, and has no effect in version 1") {
        plugged(Wall { emptyList() }, Protocol.V2) { link ->
            shouldThrow<PortException> { link.sendAndAwait("fly", LIMIT_MS) }.message shouldContain "refuse"
        }
        plugged(Wall { emptyList() }, Protocol.V1) { link ->
            link.sendAndAwait("fly", LIMIT_MS)
            link.request("getPercepts", LIMIT_MS).text() shouldBe ""
        }
    }

    test("a percept too long for a message of version 1 is left out, with one line of log") {
        val warnings = logged("javino.sim.BoardLoop") {
            plugged(Wall { listOf("text(\"${"x".repeat(300)}\")", "light(3)") }, Protocol.V1) { link ->
                repeat(2) { link.request("getPercepts", LIMIT_MS).text() shouldBe "light(3);" }
            }
        }
        warnings.single() shouldContain "a percept of more than 255 bytes"
    }

    test("a request for some functors is answered with those") {
        plugged(Wall { listOf("dist(front,9)", "light(3)", "~moving") }, Protocol.V2) { link ->
            link.request("getPercepts(light,~moving)", LIMIT_MS).text() shouldBe "light(3);~moving;"
        }
    }

    test("more percepts than a message of version 1 holds are sent in several, none cut in two") {
        val many = List(40) { "sensor$it(1)" } // two messages: of several that wait, listening takes only the newest
        val all = many.joinToString("") { "$it;" }
        plugged(Wall { many }, Protocol.V2) { it.request("getPercepts", LIMIT_MS).text() shouldBe all }
        plugged(Wall { many }, Protocol.V1) { link ->
            val messages = listOf(link.request("getPercepts", LIMIT_MS).text(), link.listen(LIMIT_MS).text())
            messages.joinToString("") shouldBe all
            messages.all { it.endsWith(";") } shouldBe true
        }
    }

    test("what it throws ends its line, with the reason") {
        plugged(Wall { error("no sensor is there") }, Protocol.V2) { link ->
            shouldThrow<PortException> { link.request("getPercepts", LIMIT_MS) }.message shouldContain "no sensor is there"
        }
    }

    test("it is found as a service by its class's name") {
        Wall { emptyList() }.name() shouldBe "wall"
    }
})
