package argo.recording.why

import argo.recording.recordingFile
import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.testkit.AgentSetUp
import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/** The reasons of reflexes. No plan sends a reflex, so a replay does not show its reason. */
class WhyReflexSpec : FunSpec({
    val near = """<critical reflex="stop"><predicate>dist</predicate><parameter id="1" operator="LT">15</parameter></critical>"""
    val dark = """<critical reflex="lamp"><predicate>light</predicate><parameter id="0" operator="LT">3</parameter></critical>"""

    fun start(options: String = "baud(115200)") = """
        !start.
        +!start <- argo.port(ttyACM0, [$options]); argo.limit(10); argo.change_filter(careful); argo.percepts(open).
        +light(_) : not begun <- +begun; argo.act(forward).
    """.trimIndent()

    fun <T> whyOf(
        program: String, setUp: AgentSetUp.() -> Unit = {}, drive: TestAgent.() -> Unit, rules: String = near + dark, ask: Why.() -> T,
    ): T {
        val file = recordingFile()
        file.parent.resolve("careful.xml").writeText("<PerceptionFilter>$rules</PerceptionFilter>")
        val source = file.parent.resolve("robot.asl").apply { writeText(program) }
        agent(source) {
            setUp()
            options("argo_record" to "$file")
        }.use { it.drive() }
        return Recording(file).use { recording -> Why(recording).use { it.ask() } }
    }

    fun TestAgent.approach() {
        for (cm in listOf(90, 12, 11, 80, 9)) {
            perceives("dist(front,$cm)", "light(7)")
            after(300.milliseconds)
        }
    }

    fun Why.answer(question: String) = answer(Question.of(question).shouldNotBeNull().find(commands))

    test("the computer's reflex: the rule, the percept that met it and its frame") {
        whyOf(start(), drive = { approach() }) {
            commands.map { it.text to it.by } shouldBe
                listOf("forward" to Sender.PLAN, "stop" to Sender.REFLEX, "stop" to Sender.REFLEX)
            val answer = answer("stop#1")
            answer.cause.shouldBeNull()
            answer.reflex.shouldNotBeNull().run {
                rule shouldBe "dist where argument 1 is less than 15"
                isByBoard shouldBe false
                percept.shouldNotBeNull().belief shouldBe "dist(front,12)"
                percept.shouldNotBeNull().filter.shouldNotBeNull() shouldContain "it matches critical rule 1"
            }
            answer.frame.shouldNotBeNull().texts shouldBe listOf("dist(front,12)", "light(7)")
            answer.frames shouldBe listOf(answer.frame)
            answer.had shouldBe emptyList()
            answer("stop#2").frame.shouldNotBeNull().texts.first() shouldBe "dist(front,9)"
        }
    }

    test("the reflex of a rule that is smoothed: the percept that stood") {
        val smooth = "<smooth annotate='true'><predicate>dist</predicate><parameter id='1' median='3'/></smooth>"
        whyOf(start(), drive = { approach() }, rules = smooth + near.replace("<critical", "<critical smoothed='true'")) {
            answer("stop#1").run {
                reflex.shouldNotBeNull().percept.shouldNotBeNull().belief shouldBe "dist(front,12)"
                frame.shouldNotBeNull().kept.shouldNotBeNull().first() shouldBe "dist(front,12)[smoothed]"
            }
        }
    }

    test("commands of plans are numbered past reflexes") {
        val program = start() + "\n+dist(front,Cm) : Cm < 10 <- argo.act(back(Cm))."
        whyOf(program, drive = { approach() }) {
            answer("back").cause.shouldNotBeNull().step shouldBe "argo.act(back(Cm))"
            answer("back").had.single().percept shouldBe "dist(front,10)"
            answer("#4").command.text shouldBe "back(9)"
        }
    }

    test("the board's reflex") {
        val board: AgentSetUp.() -> Unit = { board.version2().holdsRules(2) }
        whyOf(start("baud(115200), protocol(2)"), board, { approach() }) {
            commands.filter { it.text == "stop" }.size shouldBe 2
            val answer = answer("stop#1")
            answer.reflex.shouldNotBeNull().isByBoard shouldBe true
            answer.frame.shouldNotBeNull().texts.first() shouldBe "dist(front,12)"
        }
    }

    test("a reflex that failed, and what a person sent") {
        val refusing: AgentSetUp.() -> Unit = { board.version2().refuses("stop") }
        whyOf(start("baud(115200), protocol(2)"), refusing, { approach() }) {
            answer("stop#1").reflex.shouldNotBeNull().failure.shouldNotBeNull() shouldContain "refuses"
        }
    }

    test("each rule has its own frame, however many are met at once") {
        whyOf(start(), drive = {
            perceives("dist(front,90)", "light(7)").after(1.seconds)
            perceives("dist(front,90)", "light(2)").after(1.seconds)
            perceives("dist(front,9)", "light(2)").after(1.seconds)
        }) {
            answer("lamp").reflex.shouldNotBeNull().percept.shouldNotBeNull().belief shouldBe "light(2)"
            answer("lamp").frame.shouldNotBeNull().texts shouldBe listOf("dist(front,90)", "light(2)")
            answer("stop").frame.shouldNotBeNull().texts shouldBe listOf("dist(front,9)", "light(2)")
        }
    }

    test("what a reflex would have done with another percept is refused: no replay has it") {
        whyOf(start(), drive = { approach() }) {
            val stop = Question("stop", count = 1).find(commands)
            shouldThrow<RecordingException> { had(stop, "dist(front,20)") }.message shouldContain "stop was not sent by a plan"
        }
    }
})
