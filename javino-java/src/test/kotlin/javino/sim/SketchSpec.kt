package javino.sim

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.Frame
import javino.FrameDecoder
import javino.LineClock
import javino.PerceptKind
import javino.PortException
import javino.Protocol
import javino.Transport
import javino.Transports
import javino.link.BoardListener
import javino.link.Link
import javino.link.LinkSettings
import javino.link.SendOptions
import javino.logged
import javino.wire.BoardAction
import javino.wire.BoardRule
import javino.wire.ReflexOutcome
import java.util.concurrent.atomic.AtomicInteger

private const val LIMIT_MS = 20_000
private val SETTINGS = LinkSettings.defaults().withBaud(1_000_000).withBootMillis(0)

/** Returns the given percepts, and records the commands that it knows. */
private class Wall(private val shown: () -> List<String>) : Sketch {
    val commands = ArrayList<String>()

    override fun percepts() = shown()

    override fun act(command: String) = (command == "stop").also { if (it) commands += command }
}

private fun plugged(sketch: SimulatedBoard, use: () -> Unit) {
    SimulatedBoards.plugIn("sketch", sketch)
    try {
        use()
    } finally {
        SimulatedBoards.unplug("sketch")
    }
}

private fun plugged(sketch: SimulatedBoard, protocol: Protocol, use: (Link) -> Unit) =
    plugged(sketch) { Link.open("sim:sketch", SETTINGS.withProtocol(protocol), "the test").use(use) }

private fun pluggedWithoutLink(sketch: Sketch, use: (Transport) -> Unit) =
    plugged(sketch) { Transports.open("sim:sketch", SETTINGS.line()).use(use) }

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

    test("it describes its percepts if it overrides perceptKinds") {
        val kinds = PerceptKind.parseLines("dist(front, cm 0..90)")
        val described = object : Sketch by Wall({ listOf("dist(front,9)") }) {
            override fun perceptKinds() = kinds
        }
        for ((sketch, expected) in listOf(described to kinds, Wall { listOf("dist(front,9)") } to emptyList())) {
            plugged(sketch, Protocol.V2) { it.perceptDescription(LIMIT_MS).kinds() shouldBe expected }
        }
    }

    test("it tells its actions, and watches a rule if it is run with room for one") {
        val cm = AtomicInteger(90)
        val wall = Wall { listOf("dist($cm)") }
        val sketch = object : Sketch by wall {
            override fun actions() = listOf(BoardAction("stop", 0))
        }
        val reports = ArrayList<String>()
        val listener = object : BoardListener {
            override fun critical(rule: Int, outcome: ReflexOutcome, percept: String, receivedNanos: Long) {
                reports += "$rule $outcome $percept"
            }

            override fun sessionBegan(rules: Int) = Unit
        }
        plugged(SimulatedBoard { sketch.run(it, LineClock.system(), 1) }, Protocol.V2) { link ->
            link.onBoardEvents(listener)
            while (link.vocabulary().isEmpty) link.request("getPercepts", LIMIT_MS)
            link.vocabulary().get() shouldBe sketch.actions()
            val near = BoardRule("dist", listOf(BoardRule.Condition(1, BoardRule.Operator.LESS, "40")), "stop")
            val set = link.sendRule(near.setting(1), SendOptions.defaults())
            while (!set.isDone) link.watch(10)
            set.join()
            cm.set(39)
            while (reports.isEmpty()) link.watch(10)
        }
        reports shouldContainExactly listOf("1 CARRIED_OUT dist(39);")
        wall.commands shouldContainExactly listOf("stop")
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

    test("a request for some functors is answered with those, negated ones too") {
        plugged(Wall { listOf("dist(front,9)", "light(3)", "~moving") }, Protocol.V2) { link ->
            link.request("getPercepts(light,moving)", LIMIT_MS).text() shouldBe "light(3);~moving;"
        }
    }

    test("more percepts than a message of version 1 holds are sent in several, none cut in two") {
        val many = List(60) { "sensor$it(1)" }
        val all = many.joinToString("") { "$it;" }
        plugged(Wall { many }, Protocol.V2) { it.request("getPercepts", LIMIT_MS).text() shouldBe all }
        val messages = ArrayList<String>()
        pluggedWithoutLink(Wall { many }) { line -> // a link takes only the newest of several messages
            val request = Frame.of("getPercepts").toBytes()
            line.write(request, 0, request.size, LIMIT_MS)
            val decoder = FrameDecoder(Long.MAX_VALUE) { messages += it.text() }
            val bytes = ByteArray(1024)
            while (messages.sumOf { it.length } < all.length) {
                val count = line.read(bytes, 0, bytes.size, LIMIT_MS)
                check(count > 0) { "nothing comes behind $messages" }
                repeat(count) { decoder.accept(bytes[it], 0) }
            }
        }
        messages.joinToString("") shouldBe all
        messages.size shouldBeGreaterThan 2
        messages.all { it.endsWith(";") } shouldBe true
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
