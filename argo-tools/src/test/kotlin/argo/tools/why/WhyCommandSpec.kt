package argo.tools.why

import argo.testkit.agent
import argo.testkit.agentOf
import argo.testkit.mas
import argo.tools.argo
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.boolean
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import kotlin.io.path.createDirectories
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.seconds

class WhyCommandSpec : FunSpec({
    val directory = tempdir().toPath()
    val drive = directory.resolve("drive.mcap")
    agentOf(
        """
        !start.
        +!start <- argo.port(ttyACM0); argo.percepts(open); argo.act(forward).
        +dist(front,Cm) : Cm < 40 & not stopped <- +stopped; argo.act(stop).
        """.trimIndent(),
    ) { options("argo_record" to "$drive") }.use {
        it.perceives("dist(front,80)").after(1.seconds)
        it.perceives("dist(front,30)").shouldSend("stop").after(1.seconds)
    }

    test("sentences from the command to the frame") {
        val said = argo("why", "$drive", "stop")
        said.err shouldBe ""
        said.status shouldBe 0
        said.out shouldContain "agent agent sent stop to ttyACM0\n  because of the step argo.act(stop), agent.asl:3, carried out at"
        said.out shouldContain "    its context: Cm < 40, which was 30 < 40\n"
        said.out shouldContain ": dist(front,30);\n"
        said.out shouldContain "had the board sent dist(front,40) in place of dist(front,30) from"
        said.out shouldContain "it would not have sent stop, but nothing"
    }

    test("a message leads into the recording of its sender, if that is given") {
        val (base, scout) = listOf("base", "scout").map { directory.resolve("$it.mcap") }
        mas {
            agentOf("base", "+wall(D) <- argo.port(ttyACM0); argo.act(stop).") { options("argo_record" to "$base") }
            agentOf("scout", "!look.\n+!look <- .wait(500); !tell(3).\n+!tell(D) <- .send(base, tell, wall(D)).") {
                options("argo_record" to "$scout")
            }
        }.use { it["base"].shouldSend("stop").after(1.seconds) }
        argo("why", "$base", "stop").out shouldContain "because agent scout had sent tell wall(3), taken at"
        val said = argo("why", "$base", "$scout", "stop")
        said.err shouldBe ""
        said.out shouldContain "s of $scout  agent scout sent it, "
        said.out shouldContain "; compared with the first recording, its clock is 0.000 s ahead, but for the time that a message takes"
        said.out shouldContain "because of the step .send(base,tell,wall(D)), agent.asl:3, carried out at"
        said.out shouldContain "because the program begins with look (agent.asl:1); no percept began it"
        argo("why", "$scout", "$base", "stop", "--of", "base").out shouldBe said.out
        argo("why", "$scout", "$base", "stop", "--of", "bob").err shouldContain "has no agent bob; those that it has: scout, base"
    }

    test("in JSON a cycle has the number by which replay calls it") {
        val sent = argo("replay", "$drive", "--from", "0").out.lines().single { "sends stop" in it }
        val command = Json.parseToJsonElement(argo("why", "$drive", "stop", "--json").out).jsonObject.getValue("command").jsonObject
        command.getValue("cycle").jsonPrimitive.content shouldBe sent.substringAfter("cycle ").substringBefore(':')
        command.keys shouldBe setOf("agent", "number", "text", "port", "seconds", "cycle", "by", "sent")
    }

    test("a command by the number that the live view and the timeline give it") {
        argo("why", "$drive", "#2").out shouldContain "agent agent sent stop to ttyACM0\n"
        argo("why", "$drive", "#1").out shouldContain "agent agent sent forward to ttyACM0\n"
        argo("why", "$drive", "#3").err shouldContain "there is no command #3; those at the end: forward@"
    }

    test("a program of its own tells the same, or why it does not") {
        val program = WhyProgram(patienceS = 120)
        program.ask(listOf(drive), "agent", 2).run {
            trouble shouldBe ""
            lines.joinToString("") { "$it\n" } shouldBe argo("why", "$drive", "stop").out
        }
        program.ask(listOf(drive), "agent", 99).run {
            lines shouldBe emptyList()
            trouble shouldStartWith "there is no command #99"
        }
    }

    test("a reflex, which no plan sent") {
        val folder = directory.resolve("reflex").createDirectories()
        folder.resolve("careful.xml").writeText(
            """<PerceptionFilter><critical reflex="stop"><predicate>dist</predicate><parameter id="1" operator="LT">15</parameter></critical>
            </PerceptionFilter>""",
        )
        val program = folder.resolve("robot.asl").apply {
            writeText("!start. +!start <- argo.port(ttyACM0); argo.change_filter(careful); argo.percepts(open).")
        }
        val reflex = folder.resolve("reflex.mcap")
        agent(program) { options("argo_record" to "$reflex") }.use {
            it.perceives("dist(front,80)").after(1.seconds)
            it.perceives("dist(front,9)").shouldSend("stop").after(1.seconds)
        }
        val said = argo("why", "$reflex", "stop")
        said.err shouldBe ""
        said.out shouldContain "the computer of agent robot sent, before the agent reasoned, stop to ttyACM0\n"
        said.out shouldContain "  as the reflex of the critical rule on dist where argument 1 is less than 15; no plan did\n"
        said.out shouldContain "  because dist(front,9) was perceived from "
        said.out shouldContain "it matches critical rule 1"
        said.out shouldContain "whose last byte came at"
    }

    test("--had") {
        argo("why", "$drive", "stop", "--had", "dist(front,39)").out shouldContain "it would have sent stop all the same"
        argo("why", "$drive", "stop", "--had", "dist(front").run {
            status shouldBe 1
            err shouldBe "dist(front is no percept such as dist(front,41)\n"
        }
    }

    test("--not") {
        val said = argo("why", "$drive", "stop@1s", "--not")
        said.status shouldBe 0
        said.out shouldContain "it was not applicable\n"
        said.out shouldContain "its context: Cm < 40, which was 80 < 40; not true\n"
    }

    test("--json is data") {
        val json = Json.parseToJsonElement(argo("why", "$drive", "stop", "--json").out).jsonObject
        json.getValue("frame").jsonObject.getValue("texts").jsonArray.single().jsonPrimitive.content shouldBe "dist(front,30)"
        json.getValue("had").jsonArray.single().jsonObject.getValue("isSent").jsonPrimitive.boolean shouldBe false
        val not = Json.parseToJsonElement(argo("why", "$drive", "stop@1", "--not", "--json").out).jsonObject
        not.getValue("plans").jsonArray.single().jsonObject.getValue("verdict").jsonPrimitive.content shouldBe "NOT_APPLICABLE"
    }

    test("what cannot be answered is refused in words") {
        argo("why", "$drive", "stop@0.1s").run {
            status shouldBe 1
            err shouldStartWith "there is no command stop@0.1s; those around that time: forward@"
        }
        argo("why", "$drive", "turn", "--of", "bob").err shouldContain "has no agent bob; those that it has: agent"
        argo("why", "$drive", " ").status shouldBe 2
        argo("why", "$drive", "stop", "--not", "--had", "dist(front,3)").status shouldBe 2
        argo("why", "$drive", "stop#1", "--not").status shouldBe 2
        val text = directory.resolve("text.mcap").apply { writeText("hello") }
        argo("why", "$text", "stop").err shouldContain "is no recording of an agent"
        val empty = directory.resolve("empty.mcap").apply { writeText("") }
        listOf(listOf("why", "$empty", "stop"), listOf("replay", "$empty"), listOf("recording", "$empty")).forEach {
            argo(*it.toTypedArray()).err shouldContain "$empty is empty"
        }
    }

    test("a recording that was cut off is asked as far as it goes") {
        val cut = directory.resolve("cut.mcap").apply { writeBytes(drive.readBytes().run { copyOf(size - 10) }) }
        val said = argo("why", "$cut", "stop")
        said.status shouldBe 1
        said.out shouldContain "sent stop to ttyACM0"
        said.err shouldContain "the file was cut off"
    }
})
