package argo.tools.board

import argo.mcap.McapWriter
import argo.recording.FORMAT
import argo.tools.Output
import argo.tools.argo
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.engine.spec.tempdir
import io.kotest.engine.spec.tempfile
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldBeEmpty
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import javino.LineSettings
import javino.PerceptDescription
import javino.PerceptKind
import javino.Protocol
import javino.Transports
import javino.link.Link
import javino.link.LinkSettings
import javino.sim.FakeBoard
import javino.sim.LineRecording
import javino.sim.PseudoTerminals
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.channels.FileChannel
import java.nio.file.StandardOpenOption
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicReference
import kotlin.concurrent.thread

class BoardCommandsSpec : FunSpec({
    val pairs: EnabledOrReasonIf = {
        if (PseudoTerminals.available()) Enabled.enabled else Enabled.disabled("there is no socat for a pseudo-terminal")
    }

    test("request prints the answer, and what could command a terminal as text") {
        board { it.whenAsked("getPercepts").answer("dist(f,3);say(\"\u001B[2J\");") }.with { port ->
            argo("request", port, "getPercepts") shouldBe Output(0, "dist(f,3);say(\"\\x1B[2J\");\n", "")
            val json = Json.parseToJsonElement(argo("request", port, "getPercepts", "--json").out).jsonObject
            json.getValue("answer").jsonPrimitive.content shouldBe "dist(f,3);say(\"\u001B[2J\");"
            json.getValue("protocol").jsonPrimitive.content shouldBe "version 1"
        }
    }

    test("a board that does not answer is told from one that is not there") {
        board { it.whenAsked("getPercepts").staySilent() }.with { port ->
            val said = argo("request", port, "getPercepts", "--boot", "0", "--timeout", "50")
            said.status shouldBe 1
            said.err shouldContain "gave no answer to \"getPercepts\" within 50 ms"
        }
        argo("request", "sim:tools-missing", "getPercepts").err shouldContain "there is no simulated board"
    }

    test("a port that somebody has is told with who has it") {
        board { }.with { port ->
            Link.open(port, LinkSettings.defaults(), "agent bob").use {
                val said = argo("send", port, "ledOn")
                said.status shouldBe 1
                said.err shouldContain "in use by agent bob"
            }
        }
    }

    test("send says what is known of the outcome") {
        board { it.whenAsked("ledOn") }.with { port ->
            argo("send", port, "ledOn", "--boot", "0").out shouldContain "does not report whether it acted"
        }
        board { it.version2().whenAsked("fly").refuse().also { _ -> it.whenAsked("ledOn") } }.with { port ->
            val taken = "the board has taken the command; it lists no actions, so nobody knows whether it acted or has ignored it\n"
            argo("send", port, "ledOn", "--protocol", "2") shouldBe Output(0, taken, "")
            argo("send", port, "ledOn", "--protocol", "2", "--json").out shouldContain "\"taken\":true,\"acted\":null"
            val refused = argo("send", port, "fly", "--protocol", "auto")
            refused.status shouldBe 1
            refused.err shouldContain "refuses \"fly\""
            refused.err shouldContain "; \"ports --describe $port\" shows what the board can do\n"
        }
        board { it.version2().knows("ledOn").whenAsked("ledOn") }.with { port ->
            argo("send", port, "ledOn", "--protocol", "2") shouldBe Output(0, "the board has acted\n", "")
            argo("send", port, "ledOn", "--protocol", "2", "--json").out shouldContain "\"taken\":true,\"acted\":true"
        }
    }

    test("request says of a command that is not answered that the board has taken it") {
        board { it.version2().whenAsked("ping") }.with { port ->
            val said = argo("request", port, "ping", "--protocol", "2", "--timeout", "100")
            said.status shouldBe 1
            said.err shouldContain "gave no answer to \"ping\" within 100 ms; the board has taken it as a command"
        }
    }

    test("a request for something else than percepts is a command to a board that turns out to speak version 2") {
        board { it.version2().whenAsked("getLight").answer("light(3);") }.with { port ->
            argo("request", port, "getLight") shouldBe Output(0, "light(3);\n", "")
        }
    }

    test("a message that fits into no frame is refused with the reason") {
        board { }.with { port ->
            val said = argo("send", port, "x".repeat(256))
            said.status shouldBe 1
            said.err shouldContain "at most 255 bytes"
        }
    }

    test("monitor shows what comes, and at the end how often each came") {
        board { it.whenAsked("getPercepts").answer("dist(f,3);light(1);", "dist(f,4);light(1);") }.with { port ->
            val said = argo("monitor", port, "--count", "3", "--interval", "0")
            said.status shouldBe 0
            said.err.shouldBeEmpty()
            said.out.lines().filter { " s " in it && "dist(f," in it && "last" !in it }.size shouldBe 3
            said.out shouldContain "3 messages in "
            said.out shouldContain Regex("dist\\(f,_\\): 3(, .* a second)?, last dist\\(f,4\\)")
        }
    }

    test("monitor fails if nothing came, and says how often the board was silent") {
        board { it.whenAsked("getPercepts").staySilent() }.with { port ->
            val said = argo("monitor", port, "--seconds", "1", "--boot", "0", "--timeout", "100", "--protocol", "1")
            said.status shouldBe 1
            said.out shouldContain "gave no answer"
            said.out shouldContain Regex("\\d+ requests without an answer")
        }
    }

    test("monitor listens to a board that speaks unasked") {
        val file = tempfile(suffix = ".rec").apply { writeText("javino-recording 1\n0\tin\tdist(1);\n5\tin\tdist(2);\n") }
        argo("monitor", "replay:$file", "--mode", "listen", "--count", "1").out shouldContain "1 message in"
    }

    test("a recorded board that sent its percepts unasked is asked for none, and the error says what shows them") {
        val file = tempfile(suffix = ".rec").apply { writeText("javino-recording 1\n0\tin\tdist(1);\n5\tin\tdist(2);\n") }
        val port = "replay:$file"
        val monitor = arrayOf("monitor", port, "--seconds", "1")
        for (asking in listOf(monitor, arrayOf("describe", port, "$file.new"), arrayOf("request", port, "getPercepts"))) {
            val said = argo(*asking, "--boot", "0", "--timeout", "100")
            said.status shouldBe 1
            said.out + said.err shouldContain "$port gave no answer to \"getPercepts\" within 100 ms; the recorded board sent its " +
                "percepts unasked and answers no requests: listen to it, an agent with mode(listen), monitor with --mode listen"
        }
        argo("send", port, "stop", "--protocol", "2").status shouldBe 0
    }

    test("monitor that listens to a board which sends nothing unasked says so") {
        board { it.whenAsked("getPercepts").answer("dist(f,3);") }.with { port ->
            val said = argo("monitor", port, "--mode", "listen", "--seconds", "1", "--boot", "0", "--timeout", "100")
            said.status shouldBe 1
            said.err shouldContain "does the board send percepts unasked?"
        }
    }

    test("monitor prints JSON lines, the summary last") {
        board { it.whenAsked("getPercepts").answer("dist(f,3);") }.with { port ->
            val printed = argo("monitor", port, "--count", "2", "--interval", "0", "--json").out
            val lines = printed.trim().lines().map { Json.parseToJsonElement(it).jsonObject }
            val percepts = lines.dropLast(1).map { it.getValue("percepts").jsonArray.single().jsonPrimitive.content }
            percepts shouldContainExactly listOf("dist(f,3)", "dist(f,3)")
            lines.last().getValue("summary").jsonObject.getValue("messages").jsonPrimitive.content shouldBe "2"
        }
    }

    test("what monitor records can be replayed, and is not overwritten") {
        val file = tempdir().toPath().resolve("drive.rec")
        board { it.whenAsked("getPercepts").answer("dist(f,3);", "dist(f,4);") }.with { port ->
            argo("monitor", port, "--count", "2", "--interval", "0", "--record", "$file").status shouldBe 0
            val again = argo("monitor", port, "--count", "1", "--record", "$file")
            again.status shouldBe 1
            again.err shouldContain "$file exists already, and is not overwritten"
        }
        val recording = LineRecording.read(file)
        recording.received().map { it.message() } shouldContainExactly listOf("dist(f,3);", "dist(f,4);")
        recording.isOfRequests shouldBe true
        argo("request", "replay:$file", "getPercepts").out shouldBe "dist(f,3);\n"
    }

    test("a board that goes while it is monitored ends it with the reason, and the summary of what came") {
        FakeBoard.plugIn("tools").use { board ->
            var asked = 0
            board.whenAsked("getPercepts").answer { _ -> if (++asked == 3) board.unplug(); "dist(f,3);" }
            val said = argo("monitor", board.port(), "--interval", "0")
            said.status shouldBe 1
            said.err shouldContain "port sim:tools is gone"
            said.out shouldContain "2 messages in "
        }
    }

    test("ports says whether a board answers only when it is asked to") {
        board { it.version2().whenAsked("getPercepts").answer("a;") }.with { port ->
            argo("ports", port).err shouldContain "$port is no serial port, and nothing is known of it before it is opened"
            argo("ports", port, "--probe").out shouldContain "a Javino board of version 2"
        }
        board { it.whenAsked("getPercepts").answer("a;") }.with { port ->
            val json = Json.parseToJsonElement(argo("ports", port, "--probe", "--json").out).jsonArray.single().jsonObject
            json.getValue("answers").jsonPrimitive.content shouldBe "true"
            json.getValue("board").jsonPrimitive.content shouldBe "a Javino board of version 1"
        }
        val missing = argo("ports", "sim:tools-missing", "--probe")
        missing.status shouldBe 1
        missing.out shouldContain "there is no simulated board"
    }

    test("a board that prints text is told from a silent one, with the bytes and the likely cause").config(tags = thorough) {
        val cause = "\"dist(f,30);\\r\\n\", which is text without a frame: does the sketch use Serial.print"
        board { it.whenAsked("getPercepts").answerRaw("dist(f,30);\r\n") }.with { port ->
            argo("request", port, "getPercepts", "--boot", "0", "--timeout", "400", "--protocol", "1").err shouldContain cause
            argo("ports", port, "--probe").out shouldContain "no message at 9600 baud; "
            argo("monitor", port, "--seconds", "1", "--boot", "0", "--timeout", "400", "--protocol", "1").out shouldContain cause
        }
        board { it.whenAsked("getPercepts").staySilent() }.with { port ->
            argo("ports", port, "--probe").out shouldContain "no answer at 9600 baud"
        }
    }

    test("a serial port is probed at one rate after the other").config(tags = thorough, enabledOrReasonIf = pairs) {
        PseudoTerminals.open().use { pair ->
            Probe(listOf(9600, 115200)).of(pair.computer().path).result shouldBe "no answer at 9600 and 115200 baud"
        }
    }

    test("monitor --raw shows bytes as they come, sends nothing, and fails if none came").config(enabledOrReasonIf = pairs) {
        PseudoTerminals.open().use { pair ->
            Transports.open(pair.board().path, LineSettings.defaults()).use { board ->
                val bytes = "ready\r\n\u0000".toByteArray()
                val sketch = thread { // repeats the bytes, since those sent before the port is open are lost
                    repeat(6) {
                        board.write(bytes, 0, bytes.size, 1000)
                        Thread.sleep(400)
                    }
                }
                val said = argo("monitor", pair.computer().path, "--raw", "--seconds", "3")
                sketch.join()
                said.status shouldBe 0
                said.out shouldContain "s  ready\\r\\n\n"
                said.out shouldContain "s  \\x00\n"
                said.out shouldContain Regex("\\d+ bytes in .* at 9600 baud")
                board.read(ByteArray(9), 0, 9, 100) shouldBe 0
            }
            argo("monitor", pair.computer().path, "--raw", "--seconds", "1").status shouldBe 1
        }
        argo("monitor", "sim:x", "--raw", "--json").err shouldContain "--raw goes with neither --record nor --json"
    }

    test("monitor marks percepts that no agent can read, and gives the reason once") {
        board { it.whenAsked("getPercepts").answer("Dist(1);light(2);") }.with { port ->
            val said = argo("monitor", port, "--count", "3", "--interval", "0").out
            said shouldContain "Dist(1) (!)  light(2)\n"
            said.split("no agent believes Dist(1): its name begins in upper case").size shouldBe 2
            val json = argo("monitor", port, "--count", "1", "--json").out.lines().first()
            Json.parseToJsonElement(json).jsonObject.getValue("unreadable").jsonArray.single().jsonPrimitive.content shouldBe "Dist(1)"
        }
    }

    test("monitor explains twenty of the percepts that no agent can read, and tells that it does not explain others") {
        board { it.whenAsked("getPercepts").answer((1..25).joinToString("") { n -> "Dist($n);" }) }.with { port ->
            val said = argo("monitor", port, "--count", "2", "--interval", "0").out
            said.split("no agent believes Dist(").size shouldBe 21
            said.split("further percepts with (!) are not explained").size shouldBe 2
        }
    }

    test("monitor shows units, and marks percepts that are not as the board describes them") {
        val kinds = arrayOf("dist(f|b, cm 0..400)", "temp(C -40..125)")
        board { it.version2().perceives(*kinds).whenAsked("getPercepts").answer("dist(f,401);temp(20);news(1);") }.with { port ->
            val said = argo("monitor", port, "--count", "3", "--interval", "0", "--protocol", "2").out
            said shouldContain "dist(f,401 cm) (!)  temp(20 C)  news(1) (!)\n"
            said.split("dist(f,401) is not as the board describes it: argument 2 is 401, more than 400").size shouldBe 2
            said shouldContain "news(1) is not as the board describes it: no news/1 is described"
            val json = argo("monitor", port, "--count", "1", "--json", "--protocol", "2").out.lines().first()
            val deviating = Json.parseToJsonElement(json).jsonObject.getValue("deviating").jsonArray.map { it.jsonPrimitive.content }
            deviating shouldBe listOf("dist(f,401)", "news(1)")
        }
    }

    test("describe writes the kinds of percepts that a board describes") {
        val file = tempdir().resolve("percepts")
        board { it.version2().perceives("dist(f|b, cm 0..400)", "ready").whenAsked("getPercepts").answer("dist(f,3);") }.with { port ->
            argo("describe", port, "$file", "--protocol", "2") shouldBe
                Output(0, "$file has 2 kinds of percepts, as it describes them\n", "")
            file.readText() shouldBe "# Percepts of the board at $port, as it describes them\ndist(f|b, cm 0..400)\nready\n"
            argo("describe", port, "$file").err shouldContain "$file exists already, and is not overwritten"
        }
    }

    test("describe writes the percepts that are observed of a board that describes none") {
        val file = tempdir().resolve("percepts")
        board { it.whenAsked("getPercepts").answer("dist(f,3);dist(b,40);") }.with { port ->
            argo("describe", port, "$file", "--seconds", "1", "--protocol", "1") shouldBe
                Output(0, "$file has 1 kind of percepts, as observed for 1 second\n", "")
            file.readText() shouldBe
                "# Percepts of the board at $port, as observed for 1 second\ndist(f|b, 3..40) # observed\n"
            PerceptKind.parseLines(file.readText()).single().toString() shouldBe "dist(f|b, 3..40)"
        }
    }

    test("describe takes what agents perceived from a recording, as observed") {
        val recording = tempfile(suffix = ".mcap").toPath()
        McapWriter(FileChannel.open(recording, StandardOpenOption.WRITE)).use { writer ->
            writer.metadata("argo.recording", mapOf("format" to FORMAT))
            writer.metadata("agent/robot", listOf("source", "agentClass", "archClass", "beliefBase", "isConditional").associateWith { "" })
            val cycles = writer.channel("/robot/cycle", writer.schema("argo.Cycle", "{}"))
            val snapshot = """{"port":"ttyACM0","receivedNs":1,"texts":["dist(f,3)","dist(b,70)","Bad(1)"]}"""
            writer.message(cycles, 1, 0, """{"index":1,"number":1,"ns":1,"input":{"snapshots":[$snapshot]}}""".encodeToByteArray())
        }
        val file = tempdir().resolve("percepts")
        val said = argo("describe", "$recording", "$file")
        said.status shouldBe 0
        said.out shouldContain "$file has 1 kind of percepts, as agents perceived them\n"
        said.out shouldContain "1 percept left out, which no agent can read, as Bad(1)"
        file.readText() shouldContain "\ndist(f|b, 3..70) # observed\n"
        argo("describe", "none.mcap", "$file.other").err shouldContain "there is no file none.mcap"
    }

    test("describe tells the percepts that it leaves out: those that no agent can read, and ARGO's own beliefs") {
        val file = tempdir().resolve("percepts")
        board { it.whenAsked("getPercepts").answer("Dist(3);x(Y);port(a,off);stale(a);a;") }.with { port ->
            val said = argo("describe", port, "$file", "--seconds", "1", "--protocol", "1")
            said.status shouldBe 0
            listOf("2 percepts left out, which no agent can read, as Dist(3): its", "left out: port/2, stale/1, of beliefs of").forEach {
                said.out shouldContain it
                file.readText() shouldContain "# $it"
            }
            PerceptKind.parseLines(file.readText()).map { "$it" } shouldBe listOf("a")
        }
    }

    test("describe leaves ARGO's own beliefs out of a board's description too, and says so") {
        val file = tempdir().resolve("percepts")
        board { it.version2().perceives("reflex(a, done)", "ready").whenAsked("getPercepts").answer("ready;") }.with { port ->
            argo("describe", port, "$file", "--protocol", "2").out shouldContain "left out: reflex/2, of beliefs of ARGO's own"
            PerceptKind.parseLines(file.readText()).map { "$it" } shouldBe listOf("ready")
        }
    }

    test("describe tells that a board has fallen silent, or has gone, and keeps what was observed") {
        val ends = mapOf<String, FakeBoard.() -> Unit>("and then gave no answer" to { stall() }, "is gone" to { unplug() })
        for ((end, stop) in ends) {
            val file = tempdir().resolve("percepts")
            var asked = 0
            board { it.whenAsked("getPercepts").answer { _ -> if (++asked == 3) it.stop(); "a;" } }.with { port ->
                val said = argo("describe", port, "$file", "--seconds", "3", "--protocol", "1", "--timeout", "200")
                said.status shouldBe if (end == "is gone") 1 else 0
                said.out shouldContain Regex("the board was heard for [0-9.]+ s only.*$end")
                PerceptKind.parseLines(file.readText()).map { "$it" } shouldBe listOf("a")
            }
        }
    }

    test("an interrupted describe writes what was observed until then, or says that nothing is written") {
        for ((request, written) in listOf(1 to false, 3 to true)) {
            val file = tempdir().resolve("percepts")
            val command = AtomicReference<Thread>()
            var asked = 0
            board { it.whenAsked("getPercepts").answer { _ -> if (++asked == request) command.get().interrupt(); "a;" } }.with { port ->
                val said = CompletableFuture<Output>()
                command.set(Thread { said.complete(argo("describe", port, "$file", "--protocol", "1")) })
                command.get().start()
                said.get(60, TimeUnit.SECONDS).status shouldBe if (written) 0 else 1
                if (written) said.get().out shouldContain "it was interrupted after "
                else said.get().err shouldContain "nothing was written to $file"
                file.exists() shouldBe written
            }
        }
    }

    test("a board that does not describe its percepts in time is told from one that describes none, by describe and ports") {
        val file = tempdir().resolve("percepts")
        var asked = 0
        board { it.version2().perceives("a").whenAsked("getPercepts").answer { _ -> if (++asked == 1) it.stall(); "a;" } }.with { port ->
            argo("describe", port, "$file", "--seconds", "1", "--protocol", "2", "--timeout", "200").out shouldContain
                "kinds of percepts: unknown; the board did not describe them in time"
        }
        fun line(kinds: DescribedKinds) = BoardDescription(Protocol.V2, emptyList(), 0, emptyList(), kinds, 0).lines()[3]
        line(DescribedKinds(null)) shouldBe "kinds of percepts: unknown; the board did not describe them in time"
        line(described("")) shouldBe "kinds of percepts: not described"
        line(described("?dist();")) shouldContain "kinds of percepts: none of the 1 that the board describes can be read: argument 1 of"
        line(described("?dist();?a;")) shouldContain "kinds of percepts: a; 1 more are left out: argument 1 of dist()"
    }

    test("monitor marks percepts that claim beliefs of ARGO's own") {
        board { it.whenAsked("getPercepts").answer("port(a,off);port(a,3);") }.with { port ->
            val said = argo("monitor", port, "--count", "2", "--interval", "0").out
            said shouldContain "port(a,off) (!)  port(a,3)\n"
            said.split("no agent believes port(a,off): port/2 with on or off or timeout is a belief of ARGO's own").size shouldBe 2
        }
    }

    test("ports --describe prints what a board of version 2 can do") {
        val actions = arrayOf("ledOn", "speed/1", "say/*")
        val kinds = arrayOf("dist(f|b, cm 0..400)", "light(0..1023)")
        board {
            it.version2().knows(*actions).perceives(*kinds).holdsRules(4).whenAsked("getPercepts").answer("dist(f,3);light(4);")
        }.with { port ->
            argo("ports", port, "--describe").out shouldBe """
                $port: a Javino board of version 2
                  actions: ledOn, speed/1, say/*
                  percepts: dist(f,3); light(4)
                  kinds of percepts: dist(f|b, cm 0..400); light(0..1023)
                  critical rules: up to 4 on the board
            """.trimIndent() + "\n"
            val json = Json.parseToJsonElement(argo("ports", port, "--describe", "--json").out).jsonArray.single().jsonObject
            json.getValue("actions").jsonArray.map { it.jsonPrimitive.content } shouldBe actions.toList()
            json.getValue("percepts").jsonArray.map { it.jsonPrimitive.content } shouldBe listOf("dist(f,3)", "light(4)")
            json.getValue("kinds").jsonArray.map { it.jsonPrimitive.content } shouldBe kinds.toList()
            json.getValue("rules").jsonPrimitive.content shouldBe "4"
        }
    }

    test("ports --describe says of a board without a table, of one of version 1, and of none, what is not known") {
        board { it.version2().whenAsked("getPercepts").answer("a;") }.with { port ->
            val said = argo("ports", port, "--describe").out
            said shouldContain "actions: unknown; its sketch has no table of actions"
            said shouldContain "kinds of percepts: not described"
            said shouldContain "critical rules: none on the board; the computer watches them"
        }
        board { it.whenAsked("getPercepts").answer("") }.with { port ->
            val said = argo("ports", port, "--describe").out
            said shouldContain "a Javino board of version 1"
            said shouldContain "actions: unknown; a board of version 1 does not describe itself"
            said shouldContain "percepts: none now"
            said shouldContain "kinds of percepts: unknown; a board of version 1 does not describe them"
        }
        val missing = argo("ports", "sim:tools-missing", "--describe")
        missing.status shouldBe 1
        missing.out shouldContain "sim:tools-missing: there is no simulated board"
    }

    test("a board's description says how many actions of its sketch found no room") {
        fun actions(lost: Int) = BoardDescription(Protocol.V2, listOf("ledOn", "speed/1"), lost, emptyList(), described(""), 0).lines()[1]
        actions(0) shouldBe "actions: ledOn, speed/1"
        actions(51) shouldContain "ledOn, speed/1; 51 more found no room (126 at most, fewer in little memory) and are refused"
    }

    test("ports tells who holds a port, and does not probe it").config(enabledOrReasonIf = pairs) {
        PseudoTerminals.open().use { pair ->
            val holder = ProcessBuilder("sleep", "600").redirectInput(pair.computer()).start()
            try {
                val said = argo("ports", pair.computer().path, "--probe")
                withClue(said) {
                    said.out shouldContain "process ${holder.pid()} ("
                    said.out shouldContain "not probed, because it is in use"
                }
            } finally {
                holder.destroyForcibly()
            }
        }
    }

    test("a recording that holds nothing a board said cannot be replayed") {
        val file = tempfile().apply { writeText("javino-recording 1\n") }
        argo("replay", "$file") shouldBe Output(1, "", "$file: the recording holds nothing that a board said\n")
        file.writeText("dist(1)\n")
        argo("replay", "$file").err shouldContain "$file:1: the first line of a recording"
        argo("replay", "no-such.rec").err shouldBe "there is no file no-such.rec\n"
    }
})

private fun described(answer: String) = DescribedKinds(PerceptDescription.read(answer))

private fun board(rules: (FakeBoard) -> Unit) = rules

private fun ((FakeBoard) -> Unit).with(use: (String) -> Unit) = FakeBoard.plugIn("tools").use { board ->
    board.lenient()
    this(board)
    use(board.port())
}

private val thorough = setOf(NamedTag("Thorough"))
