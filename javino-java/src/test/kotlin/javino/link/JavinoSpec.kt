package javino.link

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.FrameDecoder
import javino.Protocol
import javino.Transport
import javino.sim.FakeBoard
import javino.sim.SimulatedBoard
import javino.sim.SimulatedBoards
import javino.wire.WireDecoder
import java.util.concurrent.CopyOnWriteArrayList

/** A silent board that records the protocol versions of its messages. */
private class VersionsHeard(private val versions: MutableList<Int>) : SimulatedBoard {
    override fun run(line: Transport) {
        val version1 = FrameDecoder(Long.MAX_VALUE / 2) { versions += 1 }
        val version2 = WireDecoder(false, Long.MAX_VALUE / 2, { 0 }) { versions += 2 }
        val buffer = ByteArray(64)
        while (true) {
            val count = line.read(buffer, 0, buffer.size, 100)
            version1.accept(buffer, 0, count, 0)
            version2.accept(buffer, 0, count, 0)
        }
    }
}

class JavinoSpec : FunSpec({
    fun withBoard(name: String, work: (FakeBoard, Javino) -> Unit) =
        FakeBoard.plugIn(name).use { board ->
            Javino(LinkSettings.defaults().withBaud(1_000_000), 20_000).use { work(board, it) }
        }

    test("a command is sent, data is requested, and what the board says is heard") {
        withBoard("classic") { board, javino ->
            board.whenAsked("getPercepts").answer("dist(f,10);")
            javino.getData() shouldBe ""
            javino.sendCommand("sim:classic", "ledOn") shouldBe true
            board.awaitMessage("ledOn", 20_000)
            javino.requestData("sim:classic", "getPercepts") shouldBe true
            javino.getData() shouldBe "dist(f,10);"
            board.send("bump;")
            javino.listenHardware("sim:classic") shouldBe true
            javino.getData() shouldBe "bump;"
        }
    }

    test("version 1 is spoken, even with a board that reads both, unless version 2 is asked for") {
        for ((protocol, versions) in listOf(Protocol.AUTO to setOf(1), Protocol.V1 to setOf(1), Protocol.V2 to setOf(2))) {
            val heard = CopyOnWriteArrayList<Int>()
            val board = VersionsHeard(heard)
            SimulatedBoards.plugIn("versions", board)
            try {
                Javino(LinkSettings.defaults().withBootMillis(0).withProtocol(protocol), 50).use { javino ->
                    repeat(2) { javino.requestData("sim:versions", "getPercepts") }
                }
            } finally {
                SimulatedBoards.unplug("versions")
            }
            heard.toSet() shouldBe versions
        }
    }

    test("the port stays open between calls") {
        withBoard("kept") { board, javino ->
            javino.requestData("sim:kept", "getPercepts") shouldBe true
            Link.ownerOf("sim:kept").get() shouldBe "Javino"
            javino.requestData("sim:kept", "getPercepts") shouldBe true
            board.received().size shouldBe 2
        }
        Link.ownerOf("sim:kept").isPresent shouldBe false
    }

    test("what goes wrong is false, with the reason, and leaves the data") {
        withBoard("wrong") { _, javino ->
            javino.sendCommand("sim:missing", "ledOn") shouldBe false
            javino.lastError() shouldContain "sim:missing"
            javino.sendCommand("sim:wrong", "x".repeat(256)) shouldBe false
            javino.lastError() shouldContain "255"
            javino.getData() shouldBe ""
        }
    }

    test("a silent board is false") {
        FakeBoard.plugIn("mute").use { board ->
            board.whenAsked("getPercepts").staySilent()
            Javino(LinkSettings.defaults().withBaud(1_000_000).withBootMillis(0), 20).use { javino ->
                javino.requestData("sim:mute", "getPercepts") shouldBe false
                javino.lastError() shouldContain "20 ms"
            }
        }
    }

    test("a board that was unplugged and plugged in again is used again") {
        withBoard("replugged") { board, javino ->
            javino.requestData("sim:replugged", "getPercepts") shouldBe true
            board.unplug()
            javino.requestData("sim:replugged", "getPercepts") shouldBe false
            board.replug()
            javino.requestData("sim:replugged", "getPercepts") shouldBe true
        }
    }

    test("programs can put a class of their own in its place") {
        val fake = object : Javino() {
            override fun sendCommand(port: String, msg: String) = msg == "ledOn"
        }
        fake.sendCommand("none", "ledOn") shouldBe true
    }
})
