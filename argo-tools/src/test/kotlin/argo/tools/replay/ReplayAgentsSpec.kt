package argo.tools.replay

import argo.mcap.McapWriter
import argo.testkit.TestAgent
import argo.testkit.agentOf
import argo.tools.Output
import argo.tools.argo
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldMatch
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.boolean
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import kotlinx.serialization.json.long
import java.io.File
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class ReplayAgentsSpec : FunSpec({
    val directory = tempdir().toPath()

    fun recorded(name: String, program: String, drive: TestAgent.() -> Unit): Path {
        val file = directory.resolve("$name.mcap")
        agentOf(program) { options("argo_record" to "$file") }.use(drive)
        return file
    }

    val drive = recorded(
        "drive",
        """
        far(50).
        !start.
        +!start <- argo.port(ttyACM0); argo.percepts(open); .wait(20); argo.act(forward).
        +dist(front,Cm) : far(Far) & Cm < Far <- argo.act(stop); +stopped(Cm).
        """.trimIndent(),
    ) {
        perceives("dist(front,80)")
        after(1.seconds)
        perceives("dist(front,30)")
        shouldSend("stop")
        after(1.seconds)
    }

    val chance = recorded("chance", "!start. +!start <- argo.tools.replay.ticks(T); argo.tools.replay.ticks(U); +drew(T,U).") {
        after(300.milliseconds)
    }

    fun made(
        name: String,
        program: String = "!start.",
        index: Int = 1,
        format: String = "1",
        agentClass: String = "jason.asSemantics.Agent",
        input: String = "{}",
    ): Path {
        val file = directory.resolve("$name.mcap")
        McapWriter(FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)).use { writer ->
            writer.metadata("argo.recording", mapOf("format" to format))
            val agent = mapOf(
                "source" to "program/bob/bob.asl", "agentClass" to agentClass, "archClass" to "argo.Arch",
                "beliefBase" to "jason.bb.DefaultBeliefBase", "isConditional" to "true",
            )
            writer.metadata("agent/bob", agent)
            writer.attachment("program/bob/bob.asl", "text/plain", program.encodeToByteArray())
            val cycles = writer.channel("/bob/cycle", writer.schema("argo.Cycle", "{}"))
            writer.message(cycles, 1, 0, """{"index":$index,"number":$index,"ns":1,"input":$input}""".encodeToByteArray())
        }
        return file
    }

    test("an agent that does the same again") {
        val said = argo("replay", "$drive", "--check")
        said.err shouldBe ""
        said.status shouldBe 0
        val lines = said.out.lines()
        lines[0] shouldBe "$drive: agent agent"
        lines[1] shouldMatch Regex("""\d+ cycles of \d+\.\d{3} s replayed in \d+\.\d{3} s, \d+ times real time""")
        lines.drop(2) shouldBe listOf(
            "identical: the same events, plans, steps, calls, actions and messages in each of them",
            "nothing in it gave another result",
            "",
        )
    }

    test("--until stops there, and shows what was believed") {
        val before = argo("replay", "$drive", "--until", "0.9").out
        before shouldContain "agent believes:\n"
        before shouldContain "  far(50)"
        before shouldContain "dist(front,80)"
        before shouldNotContain "stopped(30)"
        argo("replay", "$drive", "--of", "agent").out shouldContain "stopped(30)"
        argo("replay", "$drive", "--of", "eve").err shouldBe "$drive has no agent eve; those that it has: agent\n"
        argo("replay", "$drive", "--until", "-1").run {
            status shouldBe 2
            err shouldContain "-1 is no moment of a recording; 12.3 is a second, and c412 a cycle\n"
        }
        argo("replay", "$drive", "--until", "noon").err shouldContain "noon is no moment of a recording"
        argo("recording", "$drive", "--from", "noon").err shouldContain "noon is not a number\n"
    }

    test("--until says so where nothing is believed yet") {
        argo("replay", "$chance", "--until", "0").out.lines() shouldContain "agent believes nothing"
    }

    test("--from prints the cycles from there on, and --until takes a cycle too") {
        val stop = argo("replay", "$drive", "--from", "0.9", "--of", "agent").out.lines()
        val acting = stop.single { "sends stop" in it }
        acting shouldMatch Regex(""" +1\.\d{3} s  agent, cycle \d+: .*step argo\.act\(stop\) \(agent\.asl:4\), sends stop to ttyACM0""")
        stop.filter { "sends forward" in it } shouldBe emptyList()
        val cycle = acting.substringAfter("cycle ").substringBefore(':').toInt()
        argo("replay", "$drive", "--until", "c$cycle").out shouldNotContain "stopped(30)"
        argo("replay", "$drive", "--until", "c${cycle + 10}").out shouldContain "stopped(30)"
        argo("replay", "$drive", "--until", "c99999").run {
            status shouldBe 1
            err shouldContain "no agent has a cycle 99999"
        }
        argo("replay", "$drive", "--from", "99999") shouldBe Output(1, "", "$drive has no cycle in the time of --from and --until\n")
    }

    test("--json is data") {
        val json = Json.parseToJsonElement(argo("replay", "$drive", "--json", "--until", "0.9").out).jsonObject
        json.getValue("identical").jsonPrimitive.boolean shouldBe true
        json.getValue("cycles").jsonPrimitive.long shouldBeGreaterThan 3
        json.getValue("differences").jsonArray.size shouldBe 0
        val beliefs = json.getValue("beliefs").jsonObject.getValue("agent").jsonArray
        beliefs.map { it.jsonPrimitive.content.substringBefore("[") } shouldContain "far(50)"
    }

    test("--json is data, too, if an agent prints past its log") {
        val quiet = recorded("quiet", "!start. +!start <- .verbose(0); .print(hello).") { after(300.milliseconds) }
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val tool = listOf(java, "-cp", System.getProperty("java.class.path"), "argo.tools.MainKt")
        val process = ProcessBuilder(tool + listOf("replay", "$quiet", "--json")).start()
        val printed = process.inputReader().readText()
        process.errorReader().readText() shouldContain "hello"
        Json.parseToJsonElement(printed).jsonObject.getValue("identical").jsonPrimitive.boolean shouldBe true
    }

    test("an action of the project is not carried out again but by --check, which names one whose result is another each time") {
        val said = argo("replay", "$chance")
        said.status shouldBe 0
        said.out shouldContain "identical: "
        val checked = argo("replay", "$chance", "--check")
        checked.status shouldBe 1
        checked.out shouldContain "not deterministic, 2 times: agent agent, cycle "
        checked.out shouldContain "result of argo.tools.replay.ticks\n  recorded: "
        checked.out shouldContain "it reads a clock, chance, a file or data of a thread"
    }

    test("what an agent did that its program would not do is named, with cycle and time") {
        val said = argo("replay", "${made("other")}")
        said.status shouldBe 1
        said.out shouldContain "differs: agent bob, cycle 1, 0.000 s, event\n  recorded: nothing\n  now:      +!start"
    }

    test("a recording that was cut off is replayed as far as it goes") {
        val cut = directory.resolve("cut.mcap").apply { writeBytes(drive.readBytes().run { copyOf(size - 10) }) }
        val said = argo("replay", "$cut")
        said.status shouldBe 1
        said.out shouldContain "identical as far as it goes: "
        said.err shouldContain "$cut: the file was cut off behind byte"
    }

    test("what cannot be replayed is refused in words") {
        argo("replay", "${made("late", index = 7)}").run {
            status shouldBe 1
            err shouldContain "begins with its cycle 7, the agent's beliefs then are not known, and there is no key frame to begin with"
        }
        argo("replay", "${made("newer", format = "3")}").err shouldContain
            "has format 3 of agents' recordings, and this version of ARGO reads format 2"
        argo("replay", "${made("foreign", agentClass = "robot.Brain")}").run {
            status shouldBe 1
            err shouldBe "agent bob had the class robot.Brain, and a replay makes only jason.asSemantics.Agent\n"
        }
        argo("replay", "${made("unread", program = "!start. +!start <- ((.")}").err shouldStartWith
            "Jason cannot read the program of agent bob"
        val empty = directory.resolve("empty.mcap")
        McapWriter(FileChannel.open(empty, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)).close()
        argo("replay", "$empty") shouldBe Output(
            1, "", "$empty holds no agent; the option argo_record=\"FILE.mcap\" of an agent in the .mas2j records it\n",
        )
    }

    test("an action that is not on the class path is named") {
        val file = made(
            "absent", "!start. +!start <- robot.measure(X).",
            input = """{"calls":[{"name":"robot.measure","args":["X"],"answers":[{"0":"3"}],"isOfProject":true}]}""",
        )
        val said = argo("replay", "$file")
        said.status shouldBe 1
        said.out shouldContain "likely:   the project's class robot.measure is not on the class path; add it"
    }

    val program =
        """
        far(50).
        !start.
        +!start <- argo.port(ttyACM0); argo.percepts(open); .wait(20); argo.act(forward).
        +dist(front,Cm) : far(Far) & Cm < Far <- argo.act(stop); +stopped(Cm).
        """.trimIndent()

    fun program(name: String, text: String) = directory.resolve(name).apply { writeText(text) }

    test("another program that sends the same commands") {
        val other = program("other.asl", "$program\n+stopped(_) <- .print(stopped).")
        argo("replay", "$drive", "--agent", "$other") shouldBe
            Output(0, "agent agent with $other: 2 commands recorded, 2 now\nidentical: the same commands at the same times\n", "")
    }

    test("another program that sends another command, with the first one that differs") {
        val other = program("brakes.asl", program.replace("argo.act(stop)", "argo.act(brake(1))"))
        val said = argo("replay", "$drive", "--agent", "agent=$other")
        said.status shouldBe 1
        val lines = said.out.lines()
        lines[1] shouldMatch Regex("""differs, behind 1 equal command: 1\.\d{3} s, other""")
        lines[2] shouldMatch Regex("""  recorded: stop to ttyACM0 at 1\.\d{3} s, cycle \d+, agent\.asl:4""")
        lines[3] shouldMatch Regex("""  now:      brake\(1\) at 1\.\d{3} s, cycle \d+, brakes\.asl:4""")
        val json = Json.parseToJsonElement(argo("replay", "$drive", "--agent", "$other", "--json").out).jsonObject
        json.getValue("identical").jsonPrimitive.boolean shouldBe false
        val difference = json.getValue("agents").jsonArray.single().jsonObject.getValue("difference").jsonObject
        difference.getValue("kind").jsonPrimitive.content shouldBe "other"
        difference.getValue("now").jsonObject.getValue("text").jsonPrimitive.content shouldBe "brake(1)"
    }

    test("another filter, which drops what the agent stopped for") {
        fun filter(name: String, limit: Int) = program(
            name,
            """<PerceptionFilter><filter><predicate>dist</predicate><parameter operator="LT" id="1">$limit</parameter></filter></PerceptionFilter>""",
        )
        argo("replay", "$drive", "--filter", "${filter("few.xml", 10)}").run {
            status shouldBe 0
            out shouldContain "identical: the same commands at the same times"
        }
        argo("replay", "$drive", "--filter", "${filter("all.xml", 60)}").run {
            status shouldBe 1
            out shouldContain Regex(""", missing\n  recorded: stop to ttyACM0 at \d\.\d{3} s, cycle \d+, .*\n  now:      nothing""")
        }
        argo("replay", "$drive", "--filter", "absent.xml").status shouldBe 1
    }

    test("another program that cannot be run is refused in words") {
        argo("replay", "$drive", "--agent", "absent.asl").run {
            status shouldBe 1
            err shouldContain "absent.asl"
        }
        argo("replay", "$drive", "--agent", "${program("unread.asl", "!start.\n+!start <- ((.")}").err shouldBe
            "Jason cannot read the program of agent agent: \"(\" does not belong in line 2, column 12, or something before it is missing\n"
        argo("replay", "$drive", "--agent", "${program("cut.asl", "!start.\n+!start <- .print(a)")}").err shouldBe
            "Jason cannot read the program of agent agent: it ends in the middle, in line 2\n"
        argo("replay", "$drive", "--within", "5").run {
            status shouldBe 2
            err shouldStartWith "--within is for --agent and --filter"
        }
        argo("replay", "$drive", "--check", "--agent", "$drive").status shouldBe 2
    }

    test("a debugger that cannot reach the agents is refused, and one of other programs than the recorded") {
        argo("replay", "$drive", "--debug", "4711").run { // the debugging module is not on this class path
            status shouldBe 1
            err shouldBe "no debugger can reach agent agent at port 4711; the log says why\n"
        }
        argo("replay", "$drive", "--debug", "4711", "--agent", "$drive").run {
            status shouldBe 2
            err shouldStartWith "--check, --from, --until, --of and --debug are for the recorded program"
        }
    }

    test("options of boards and of agents exclude each other") {
        argo("replay", "$drive", "--loop").run {
            status shouldBe 2
            err shouldStartWith "--loop, --in-turn and --link are for a recording of a board"
        }
        val board = directory.resolve("board.rec").apply { writeBytes("javino-recording 1\n".encodeToByteArray()) }
        argo("replay", "$board", "--check").run {
            status shouldBe 2
            err shouldStartWith "--check, --from, --until, --of, --agent, --filter, --within, --debug, --class-path and --json "
        }
    }

    test("a class path runs it in a program of its own; its parts that do not exist are told") {
        argo("replay", "$drive", "--class-path", listOf("$directory", "no/*", "no.jar").joinToString(File.pathSeparator)).run {
            status shouldBe 0
            err.trim() shouldBe "of --class-path there is no no/* and no no.jar"
        }
    }
})
