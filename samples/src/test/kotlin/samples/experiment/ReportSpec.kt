package samples.experiment

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import samples.experiment.analysis.Response
import samples.experiment.analysis.Source
import samples.experiment.analysis.analysis
import samples.experiment.report.Finding
import samples.experiment.report.Scaling
import samples.experiment.report.fate
import samples.experiment.report.median
import samples.experiment.report.promise
import samples.experiment.report.publishedClaims
import samples.experiment.report.writeReport
import java.io.ByteArrayInputStream
import javax.imageio.ImageIO
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText

/** What the published pattern looks like, made up; other conditions stop at once. */
private fun pattern(trial: Trial): Entry.Result = when {
    trial.condition != Condition.PUBLISHED -> stopped(trial.limit - 5.0, 400.0 + 10 * trial.replication)
    trial.view == View.NONE -> Entry.Result(Outcome.COLLIDED, 0.0, trial.limit * 100.0, 9, 9, 0.0)
    trial.limit == 40 && trial.interval == 50 -> Entry.Result(Outcome.COLLIDED, 0.0, 4000.0, 9, 9, 0.0)
    trial.view == View.FRONT_SIDE && trial.replication > 1 -> Entry.Result(Outcome.COLLIDED, 0.0, trial.limit * 100.0, 9, 9, 0.0)
    trial.view == View.FRONT_SIDE -> stopped(10.0, trial.limit * 100.0 - 1000)
    else -> stopped(trial.limit - 5.0, 500.0 + 10 * trial.replication)
}

private fun made(vararg conditions: Condition) = conditions.flatMap { Plan.FULL.trials(it) }.map { Finished(it, pattern(it)) }

class ReportSpec : FunSpec({
    val settings = SETTINGS.copy(plan = Plan.FULL)

    test("the page is whole: it asks nothing of the network and shows each figure in light and dark") {
        val directory = tempdir().toPath()
        val scaled = Plan.FULL.scaling(Condition.DEFAULTS).map { Finished(it, pattern(it)) }
        val page = writeReport(directory, settings, made(Condition.PUBLISHED, Condition.DEFAULTS) + scaled, "a machine").readText()
        page shouldNotContain Regex("""(src|href|srcset)="(?!data:)""")
        Regex("<img ").findAll(page).count() shouldBe 4
        Regex("prefers-color-scheme: dark\\)\" srcset=\"data:image/svg").findAll(page).count() shouldBe 4
        page shouldContain "width=device-width"
        page shouldContain "88.965"
        page shouldContain "a machine"
    }

    test("each figure is there as SVG and as PNG") {
        val directory = tempdir().toPath()
        writeReport(directory, settings, made(Condition.PUBLISHED), "a machine")
        val files = directory.resolve("figures").listDirectoryEntries()
        files.map { it.name } shouldContainExactlyInAnyOrder listOf("distances", "times", "shares").flatMap { listOf("$it.svg", "$it.png") }
        files.filter { it.name.endsWith("png") }.forEach { ImageIO.read(ByteArrayInputStream(it.readBytes())).width shouldBe 1920 }
        files.filter { it.name.endsWith("svg") }.forEach { it.readText() shouldContain "</svg>" }
    }

    test("all conditions are in one report, each with its figures and its promise") {
        val page = writeReport(tempdir().toPath(), settings, made(*Condition.entries.toTypedArray()), "a machine").readText()
        Condition.entries.forEach { page shouldContain "<th scope=\"row\">(${it.letter}) ${it.title}</th>" }
        page shouldContain "<th scope=\"col\" class=\"n\">(d)</th>"
        page shouldContain "(d) version 2, reflex on the board: every run stops"
    }

    test("without any run there is a page that says so") {
        writeReport(tempdir().toPath(), settings, emptyList(), "a machine").readText() shouldContain "There are no runs yet"
    }

    test("a run that failed is named with its reason and not counted") {
        val runs = made(Condition.PUBLISHED)
        val failed = runs.first().let { it.copy(result = it.result.copy(outcome = Outcome.FAILED, reason = "port <x> is gone")) }
        val page = writeReport(tempdir().toPath(), settings, runs.drop(1) + failed, "a machine").readText()
        page shouldContain "port &lt;x&gt; is gone"
        page shouldContain "Not all runs of a condition are made"
    }

    test("the published pattern is found where it is") {
        val runs = made(Condition.PUBLISHED)
        val claims = publishedClaims(runs, Plan.FULL, analysis(runs, Plan.FULL, Condition.PUBLISHED, Response.TIME))
        claims.map { it.finding } shouldBe List(5) { Finding.YES }
    }

    test("and not where it is not") {
        val runs = Plan.FULL.trials(Condition.PUBLISHED).map { Finished(it, stopped(it.limit - 1.0, 100.0 + it.interval)) }
        val claims = publishedClaims(runs, Plan.FULL, analysis(runs, Plan.FULL, Condition.PUBLISHED, Response.TIME))
        claims.map { it.finding } shouldBe listOf(Finding.NO, Finding.YES, Finding.NO, Finding.NO, Finding.NO)
    }

    test("a promise is kept only if every run stops") {
        val runs = made(Condition.DEFAULTS)
        promise(runs, Condition.DEFAULTS)?.finding shouldBe Finding.YES
        val one = runs.first().let { it.copy(result = it.result.copy(outcome = Outcome.COLLIDED)) }
        promise(runs.drop(1) + one, Condition.DEFAULTS)?.finding shouldBe Finding.PARTLY
        promise(runs, Condition.VERSION_2) shouldBe null
    }

    test("all collisions enter the response time alike, and the least response time each with its own limit") {
        val runs = made(Condition.PUBLISHED)
        val wall = runs.first { it.trial.view == View.NONE && it.trial.limit == 40 }.result
        Response.TIME.of(wall, Plan.FULL) shouldBe 12.0
        Response.LEAST_TIME.of(wall, Plan.FULL) shouldBe 4.0
        Response.DISTANCE.of(wall, Plan.FULL) shouldBe 0.0
    }

    test("an experiment that lacks a run is not analysed, and the factors are in their places") {
        val runs = made(Condition.DEFAULTS)
        analysis(runs.drop(1), Plan.FULL, Condition.DEFAULTS, Response.TIME) shouldBe null
        val byInterval = runs.map { it.copy(result = stopped(responseMs = it.trial.interval * 10.0)) }
        analysis(byInterval, Plan.FULL, Condition.DEFAULTS, Response.TIME)?.share(Source.B).shouldNotBeNull() shouldBe
            (1.0 plusOrMinus 1e-9)
    }

    test("a real robot is not described as a simulated one") {
        val page = writeReport(tempdir().toPath(), settings.copy(port = "tty<0>"), made(Condition.DEFAULTS), "a machine").readText()
        page shouldContain "a real one, on the port <code>tty&lt;0&gt;</code>"
        page shouldNotContain "All 12 readings change"
        page shouldNotContain "is slowed"
        page shouldNotContain "woken late"
    }

    test("runs of which a whole filter has failed make a report without what cannot be said") {
        val runs = made(Condition.PUBLISHED, Condition.DEFAULTS)
        View.entries.forEach { lost ->
            val left = runs.map {
                if (it.trial.view == lost) it.copy(result = it.result.copy(outcome = Outcome.FAILED, reason = "lost")) else it
            }
            val page = writeReport(tempdir().toPath(), settings, left, "a machine").readText()
            page shouldContain "54 runs have failed"
            page.replace(Regex("base64,[^\"]*"), "") shouldNotContain "NaN"
        }
    }

    test("where the line alone takes longer than the limit leaves, a collision is said to be the line's") {
        val wall = Entry.Result(Outcome.COLLIDED, 0.0, 8000.0, 9, 9, 0.0)
        val slow = Trial(Condition.DEFAULTS, View.NONE, 80, 20, 1, sensors = 768)
        fate(Finished(slow, wall)) shouldBe "too slow"
        fate(Finished(slow.copy(baud = 115_200), wall)) shouldBe "wall"
        fate(Finished(slow, wall.copy(outcome = Outcome.IDLE))) shouldBe "idle"
        fate(Finished(slow, stopped(responseMs = 1234.0))) shouldBe "1.23"
    }

    test("the table of scaling says from which line on every robot stops") {
        val bauds = listOf(9_600, 38_400, 115_200, 250_000)
        val runs = bauds.map { Trial(Condition.DEFAULTS, View.NONE, 80, 20, 1, it, 48) }.map { trial ->
            Finished(trial, if (trial.baud == 38_400) stopped().copy(outcome = Outcome.COLLIDED) else stopped(responseMs = 500.0))
        }
        Scaling(runs).table() shouldContain "<td class=\"n\">0.50</td><td class=\"n\">wall</td><td class=\"n\">0.50</td><td " +
            "class=\"n\">0.50</td><td class=\"n\">115200 baud</td>"
        Scaling(runs.take(2)).table() shouldContain "<td class=\"n\">none</td><td class=\"n\">–</td>"
    }

    test("the median of an even number of runs is between the two in the middle") {
        median(listOf(4.0, 1.0, 2.0, 8.0)) shouldBe 3.0
        median(listOf(4.0, 1.0, 2.0)) shouldBe 2.0
    }
})
