package experiment.delegation

import experiment.JSON
import experiment.Settings
import experiment.program
import experiment.report.Provenance
import experiment.report.Source
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import jason.asSyntax.ASSyntax
import javino.LineClock
import java.io.PrintWriter
import java.io.StringWriter
import java.time.Instant
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.math.ln
import kotlin.random.Random

class DelegationSpec : FunSpec({
    val settings = Settings(DelegationPlan.QUICK, seed = 3, slowdown = 5.0, computer = "of a test")

    fun made(plan: DelegationPlan = DelegationPlan.QUICK, ms: (DelegationRun) -> Double) =
        plan.runs(7).map { Measured(it, DelegationResult(listOf(ms(it) - 1, ms(it), ms(it) + 1), 0, busy = 0.5, lateMs = 2.0)) }

    context("the plan") {
        test("each block has each combination once, in an order of its own that the seed decides") {
            val runs = DelegationPlan.FULL.runs(1)
            val blocks = runs.chunked(144)
            blocks shouldHaveSize 5
            blocks.map { block -> block.map { it.load to it.design }.toSet().size } shouldBe List(5) { 144 }
            blocks.map { block -> block.map { it.load to it.design } }.distinct() shouldHaveSize 5
            runs.map { it.id }.distinct() shouldHaveSize runs.size
            DelegationPlan.FULL.runs(1) shouldBe runs
        }

        test("a name of a run is an atom, and all but the last plan of a percept ask a belief") {
            DelegationPlan.FULL.runs(1).forEach { ASSyntax.parseTerm(it.id).isAtom shouldBe true }
            plansFor("dist", 3) shouldBe
                listOf("+dist(_, N) : alarm1(Limit) & N < Limit.", "+dist(_, N) : alarm2(Limit) & N < Limit.", "+dist(_, _).")
            plansFor("dist", 3).forEach { ASSyntax.parsePlan(it).trigger.literal.functor shouldBe "dist" }
        }
    }

    context("the stimuli") {
        class Clock(var now: Long = 0) : LineClock {
            override fun nanos() = now

            fun advance(ms: Long) = apply { now += ms * 1_000_000 }
        }

        fun near(readings: List<String>) =
            readings.filter { it.startsWith("dist") }.map { it.substringAfter(',').removeSuffix(")").toInt() }.filter { it < 40 }

        test("a sensor comes near after a pause, and is clear again when the robot has stopped for it") {
            val clock = Clock()
            val stimuli = Stimuli(12, clock, Random(1))
            near(stimuli.read(KINDS)).shouldBeEmpty()
            clock.advance(150)
            near(stimuli.read(KINDS)) shouldBe listOf(1)
            stimuli.stop(2)
            near(stimuli.read(KINDS)) shouldBe listOf(1)
            stimuli.stop(1)
            near(stimuli.read(KINDS)).shouldBeEmpty()
            val reaction = stimuli.reactions.single()
            reaction.ms.shouldNotBeNull() shouldBe ((clock.now - reaction.at) / 1e6 plusOrMinus 1e-9)
            stimuli.stop(1)
            stimuli.reactions shouldHaveSize 1
            stimuli.areOver(clock.now) shouldBe true
            clock.advance(150)
            stimuli.areOver(clock.now) shouldBe false
            near(stimuli.read(KINDS)) shouldBe listOf(2)
        }

        test("a stimulus that nobody reacts to ends after two seconds, without a time") {
            val clock = Clock()
            val stimuli = Stimuli(12, clock, Random(1))
            clock.advance(2_140)
            stimuli.read(KINDS)
            stimuli.reactions.map { it.ms } shouldBe listOf(null)
            DelegationResult(listOf(30.0, 10.0), missed = 1, busy = 0.0, lateMs = 0.0).times shouldBe listOf(10.0, 30.0, 2000.0)
        }

        test("each board reads its kinds, and each reading differs from the one before") {
            val stimuli = Stimuli(12, Clock(), Random(1))
            val readings = List(2) { stimuli.read(listOf("light", "temp")) }
            readings.first().map { it.substringBefore(',') } shouldBe
                listOf("light(0", "temp(0", "light(1", "temp(1", "light(2", "temp(2", "light(3", "temp(3")
            readings[0].zip(readings[1]).none { (one, other) -> one == other } shouldBe true
        }

        test("only the board with the motors has the command to stop, and an unknown one is refused") {
            val stimuli = Stimuli(12, Clock(), Random(1))
            KindSketch(stimuli, KINDS, motors = true).act("stop(3)") shouldBe true
            KindSketch(stimuli, KINDS, motors = true).act("halt") shouldBe false
            KindSketch(stimuli, KINDS, motors = false).act("stop(3)") shouldBe false
        }
    }

    context("the comparison") {
        test("a ratio is that within the blocks, whatever a block as a whole is slowed by") {
            val runs = made { run -> 10.0 * run.block * (if (run.design == Design.DELEGATES) 2 else 1) }
            val comparison = Comparison(runs, DelegationPlan.QUICK)
            val ratio = comparison.ratio(Design.DELEGATES, DelegationPlan.QUICK.loads)
            ratio.value shouldBe (2.0 plusOrMinus 1e-9)
            ratio.interval.shouldNotBeNull().let { it.high - it.low } shouldBe (0.0 plusOrMinus 1e-9)
            comparison.reaction(DelegationPlan.QUICK.loads.first(), Design.ONE) shouldBe 20.0
        }

        test("its interval is Student's, of the logarithms") {
            val (value, interval) = ratio(listOf(ln(1.0), ln(2.0), ln(4.0)))
            value shouldBe (2.0 plusOrMinus 1e-9)
            // 4.3027 is t with two degrees of freedom
            ln(interval.shouldNotBeNull().high / 2) shouldBe (4.3027 * ln(2.0) / 1.7321 plusOrMinus 1e-3)
            ratio(listOf(ln(3.0))).interval shouldBe null
        }

        test("the share of the only factor with an effect is the whole variation") {
            val comparison = Comparison(made { if (it.design == Design.ONE) 10.0 else 20.0 }, DelegationPlan.QUICK)
            comparison.allocation(processors = 1, interval = 20).share(Source.A) shouldBe (1.0 plusOrMinus 1e-9)
        }
    }

    context("the records") {
        test("each run is in a file of its own, and one that was cut off is made anew") {
            val archive = delegationArchive(tempdir().toPath().resolve("x")).apply { open(settings) }
            val runs = made { 10.0 }.take(2)
            runs.forEach { archive.file(it.run.id).writeText(JSON.encodeToString(Measured.serializer(), it)) }
            archive.finished() shouldContainExactlyInAnyOrder runs
            archive.file(runs[1].run.id).writeText("{\"run\":{\"blo")
            archive.finished() shouldBe runs.take(1)
            archive.unusable() shouldBe 1
            delegationArchive(archive.directory).settings() shouldBe settings
            archive.close()
        }
    }

    listOf(
        "--quick delegation" to "options of the experiment on delegation stand behind its name, not --quick",
        "delegation --jobs 0" to "--jobs is from 1 to 256, not 0",
        "delegation --slowdown 0.5" to "--slowdown is from 1 to 1000, not 0.5",
        "delegation --slowdown 2 --out /dev/null" to "cannot be written to",
        "delegation --out PRESENT --seed 4" to "the seed is 3 there and 4 was asked for",
    ).forEach { (arguments, why) ->
        test("$arguments is refused in words") {
            val present = tempdir().toPath().also { directory -> delegationArchive(directory).use { it.open(settings) } }
            val printed = StringWriter()
            val words = arguments.replace("PRESENT", "$present --quick").split(' ').toTypedArray()
            PrintWriter(printed, true).let { program().setOut(it).setErr(it).execute(*words) } shouldBe 2
            "$printed" shouldContain why
        }
    }

    test("the report has each load, numbers its tables and asks nothing of the network") {
        val directory = tempdir().toPath()
        val runs = made { if (it.design == Design.DELEGATES) 40.0 else 20.0 + it.block }
        val page = writeDelegationReport(
            directory, settings, runs + runs.first().copy(result = runs.first().result.copy(lateMs = 99.0)),
            Provenance("0.1.0, commit abc", Instant.parse("2026-11-22T10:15:30Z"), "a machine"),
        ).readText()
        page shouldNotContain Regex("""(src|href|srcset)="(?!data:)""")
        Regex("<caption>Table (\\d+)\\.").findAll(page).map { it.groupValues[1].toInt() }.toList() shouldBe (1..4).toList()
        page shouldContain "Made with ARGO 0.1.0, commit abc on 2026-11-22T10:15:00Z."
        page shouldContain "In 1 of 97 runs it was more than 15 ms late, 99 ms at most"
        page shouldContain "<td class=\"n\">1.00 (1.00 to 1.00)</td>"
    }
})
