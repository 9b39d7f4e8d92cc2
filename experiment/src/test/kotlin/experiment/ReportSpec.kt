package experiment

import experiment.report.Finding
import experiment.report.Provenance
import experiment.report.Response
import experiment.report.Scaling
import experiment.report.Source
import experiment.report.TimeScale
import experiment.report.analysis
import experiment.report.escaped
import experiment.report.fate
import experiment.report.median
import experiment.report.promise
import experiment.report.publishedClaims
import experiment.report.rounded
import experiment.report.svg
import experiment.report.time
import experiment.report.writeReport
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.intern.toSpec
import java.io.ByteArrayInputStream
import java.time.Instant
import javax.imageio.ImageIO
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText

/** Makes a result with the published pattern. Other conditions stop at once. */
private fun pattern(trial: Trial): Entry.Result = when {
    trial.condition != Condition.PUBLISHED -> stopped(trial.limit - 5.0, 400.0 + 10 * trial.replication)
    trial.view == View.NONE -> collided(trial.limit * 100.0)
    trial.limit == 40 && trial.interval == 50 -> collided(4000.0)
    trial.view == View.FRONT_SIDE && trial.replication > 1 -> collided(trial.limit * 100.0)
    trial.view == View.FRONT_SIDE -> stopped(10.0, trial.limit * 100.0 - 1000)
    else -> stopped(trial.limit - 5.0, 500.0 + 10 * trial.replication)
}

private fun made(vararg conditions: Condition) = conditions.flatMap { Plan.FULL.trials(it) }.map { Finished(it, pattern(it)) }

/** A figure for tests of the page's text, with its labels as a description: drawing takes most of a report's time. */
private fun undrawn(plot: Plot) =
    """<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><desc>${escaped("${plot.toSpec()}")}</desc></svg>"""

private val MADE = Provenance("0.1.0, commit abc", Instant.parse("2026-11-22T10:15:30Z"), "a machine")

class ReportSpec : FunSpec({
    val settings = SETTINGS.copy(plan = Plan.FULL)
    val reports = mutableMapOf<List<Condition>, String>()

    fun pageOf(runs: List<Finished>, of: Settings<Plan> = settings): String =
        writeReport(tempdir().toPath(), of, runs, MADE, ::undrawn).readText()

    fun report(vararg conditions: Condition): String = reports.getOrPut(conditions.toList()) { pageOf(made(*conditions)) }

    test("the page is whole: it asks nothing of the network, and each figure is light and dark, and there as SVG and PNG") {
        val directory = tempdir().toPath()
        val scaled = Plan.FULL.scaling(Condition.DEFAULTS).map { Finished(it, pattern(it)) }
        val page = writeReport(directory, settings, made(Condition.PUBLISHED, Condition.DEFAULTS) + scaled, MADE).readText()
        page shouldNotContain Regex("""(src|href|srcset)="(?!data:)""")
        Regex("<img ").findAll(page).count() shouldBe 4
        Regex("prefers-color-scheme: dark\\)\" srcset=\"data:image/svg").findAll(page).count() shouldBe 4
        page shouldContain "width=device-width"
        page shouldContain "88.965"
        page shouldContain "a machine"
        val files = directory.resolve("figures").listDirectoryEntries()
        files.map { it.name } shouldContainExactlyInAnyOrder
            listOf("distances", "times", "shares", "scaling").flatMap { listOf("$it.svg", "$it.png") }
        files.filter { it.name.endsWith("png") }.forEach {
            ImageIO.read(ByteArrayInputStream(it.readBytes())).width shouldBe if (it.name == "scaling.png") 2360 else 1920
        }
        files.filter { it.name.endsWith("svg") }.forEach { it.readText() shouldContain "</svg>" }
    }

    test("the report says by what and when it was made, and numbers its figures and tables") {
        val page = report(Condition.PUBLISHED, Condition.DEFAULTS)
        page shouldContain "Made with ARGO 0.1.0, commit abc on 2026-11-22T10:15:00Z."
        Regex("<caption>Table (\\d+)\\.").findAll(page).map { it.groupValues[1].toInt() }.toList() shouldBe (1..13).toList()
        Regex("<figcaption>Figure (\\d+)\\.").findAll(page).map { it.groupValues[1].toInt() }.toList() shouldBe (1..3).toList()
        page shouldContain "The shares of Table 4."
    }

    test("shares of runs and medians have their intervals, and few runs have none") {
        val page = report(Condition.DEFAULTS)
        page shouldContain "<td class=\"n\">40</td><td class=\"n\">9 of 9 (70 to 100)</td>"
        page shouldContain "<td class=\"n\">420</td><td class=\"n\">410 to 430</td><td class=\"n\">410</td>"
        val few = made(Condition.DEFAULTS).take(5)
        pageOf(few) shouldContain "<td class=\"n\">420</td><td class=\"n\">–</td>"
    }

    test("the share of runs that stop is told for each limit and filter, not for limits that differ together") {
        val page = report(Condition.PUBLISHED)
        val heading = "<th scope=\"row\">(a) as published</th>"
        page shouldContain "$heading<td class=\"n\">40</td><td class=\"n\">0 of 9 (0 to 30)</td><td class=\"n\">2 of 9 (6 to 55)</td>" +
            "<td class=\"n\">6 of 9 (35 to 88)</td>"
        page shouldContain "$heading<td class=\"n\">120</td><td class=\"n\">0 of 9 (0 to 30)</td><td class=\"n\">3 of 9 (12 to 65)</td>" +
            "<td class=\"n\">9 of 9 (70 to 100)</td>"
    }

    test("all figures of a row of times end at the same place") {
        val trials = Plan.FULL.trials(Condition.VERSION_2)
        val own = trials.mapIndexed { i, trial -> Finished(trial, stopped(sinceLimitMs = 65.0 + 2 * (i % 27))) }
        val page = pageOf(made(Condition.PUBLISHED) + own)
        page shouldContain listOf("0.091", "0.079 to 0.103", "0.065", "0.117").joinToString("") { "<td class=\"n\">$it</td>" }
    }

    test("both times have a table, and only the one from perceiving the wall stands beside the published shares") {
        val runs = Plan.FULL.trials(Condition.DEFAULTS).map { Finished(it, stopped(sinceLimitMs = 500.0, sincePerceivingMs = 300.0)) }
        val page = pageOf(runs)
        fun table(caption: String, of: String = page) = of.substringAfter(caption).substringBefore("</table>")
        table("Time from crossing the limit of the runs that stopped") shouldContain "<td class=\"n\">500.0<"
        table("Time from perceiving the wall of the runs that stopped") shouldContain "<td class=\"n\">300.0<"
        val all = report(Condition.PUBLISHED)
        Response.entries.filter { "published</th>" in table("Allocation of variation of the ${it.title}", all) } shouldBe
            listOf(Response.PERCEIVED_TIME, Response.LEAST_PERCEIVED_TIME)
        page shouldContain "which add up to 100.06 %"
        page shouldContain "500 ms after the limit and 300 ms after the agent perceived the wall (medians)"
    }

    test("a table has no condition whose shares would be those of a table before") {
        val page = report(Condition.PUBLISHED, Condition.DEFAULTS)
        fun heads(response: Response) = page.substringAfter("Allocation of variation of the ${response.title}").substringBefore("</thead>")
        heads(Response.PERCEIVED_TIME) shouldContain "(b)"
        heads(Response.LEAST_PERCEIVED_TIME) shouldContain "(a)"
        heads(Response.LEAST_PERCEIVED_TIME) shouldNotContain "(b)"
        page shouldContain "Conditions without such a robot are left out"
        report(Condition.DEFAULTS) shouldNotContain "least time from perceiving"
    }

    test("the time of a request and its answer is that of each condition without a filter") {
        val page = pageOf(made(Condition.PUBLISHED, Condition.VERSION_2).reversed())
        page shouldContain "A request and its answer of twelve percepts take (a) 168 ms, (c) 37 ms."
    }

    test("a machine that was busy is told at the top, and its runs are marked") {
        val runs = made(Condition.DEFAULTS, Condition.REFLEX)
        fun late(run: Finished, ms: Double) = if (run.trial.id == "d-none-40-20-1") run.copy(result = run.result.copy(lateMs = ms)) else run
        val directory = tempdir().toPath()
        val page = writeReport(directory, settings, runs.map { late(it, 40.0) }, MADE, ::undrawn).readText()
        val top = page.substringBefore("<caption>")
        top shouldContain "The machine was busy."
        top shouldContain "In 1 of 162 runs"
        top shouldContain "d-none-40-20-1 (40 ms)"
        top shouldNotContain "other lines" // there is no such table
        page shouldContain "<td class=\"n\">27 of 27, 1 late</td>"
        directory.resolve("figures/times.svg").readText() shouldContain "stopped, busy machine"
        writeReport(directory, settings, runs.map { late(it, 4.0) }, MADE, ::undrawn).readText() shouldNotContain "The machine was busy."
        directory.resolve("figures/times.svg").readText() shouldNotContain "busy machine"
    }

    test("a table is in milliseconds if all its times are below a second, and its figure with it") {
        val runs = made(Condition.PUBLISHED, Condition.REFLEX)
        val page = pageOf(runs)
        page shouldContain "<th scope=\"col\" class=\"n\">median, s</th>"
        page shouldContain "Effects on the time from perceiving the wall, (a) as published: mean 8.2 s</summary>"
        page shouldContain "Effects on the time from perceiving the wall, (d) version 2, reflex on the board: mean 420.0 ms</summary>"
        Regex("effect, (m?s)<").findAll(page).map { it.groupValues[1] }.toList() shouldBe listOf("s", "ms")
        val directory = tempdir().toPath()
        val own = writeReport(directory, settings, made(Condition.REFLEX), MADE, ::undrawn).readText()
        own shouldContain "<th scope=\"col\" class=\"n\">median, ms</th>"
        own shouldContain "<th scope=\"row\">variance, ms²</th>"
        directory.resolve("figures/times.svg").readText() shouldContain "time from crossing the limit in ms"
    }

    test("effects are as exact as their intervals, and small ones are not rounded to nought") {
        val runs = Plan.FULL.trials(Condition.REFLEX).map {
            Finished(it, stopped(sinceLimitMs = 50.0 + 3.2 * it.view.ordinal + 0.4 * it.replication + 0.1 * it.limit / 40))
        }
        val page = pageOf(runs)
        page shouldContain "<td>no filter</td><td class=\"n\">-3.2</td><td class=\"n\">-3.3 to -3.1</td><td class=\"n\">yes</td>"
        page shouldContain "<td>40 cm</td><td class=\"n\">-0.1</td><td class=\"n\">-0.2 to 0.0</td><td class=\"n\">no</td>"
    }

    test("a time in a sentence has its unit and two digits") {
        listOf(0.0583, 0.602, 10.89, 1.996).map(::time) shouldBe listOf("58 ms", "600 ms", "11 s", "2.0 s")
    }

    test("each table of shares is followed by the intervals of them") {
        val page = report(Condition.PUBLISHED, Condition.DEFAULTS)
        Regex("95 % intervals of the shares".replace(" %", "\u00a0%")).findAll(page).count() shouldBe 4
    }

    test("all runs are in one file of comma-separated values, each in a line, reasons in quotes") {
        val directory = tempdir().toPath()
        val runs = made(Condition.DEFAULTS)
        val failed = runs.last().let { it.copy(result = it.result.copy(outcome = Outcome.FAILED, reason = "port \"x\", gone")) }
        writeReport(directory, settings, runs.dropLast(1) + failed, MADE, ::undrawn)
        val lines = directory.resolve("runs.csv").readText().split("\r\n").dropLast(1)
        lines.size shouldBe 1 + runs.size
        lines.first() shouldStartWith "run,condition,filter,limit_cm,interval_ms,replication,"
        lines.single { it.startsWith("b-none-40-20-1,") } shouldBe
            "b-none-40-20-1,b,none,40,20,1,9600,12,stopped,410.000,410.000,35.000,2,4,0.000,56.250,,3,\"0.1.0, commit abc\""
        lines.single { "failed" in it } shouldContain ",\"port \"\"x\"\", gone\""
    }

    test("a shorter plan says what it leaves out, and what is not tested") {
        val runs = Plan.QUICK.trials(Condition.PUBLISHED).map { Finished(it, pattern(it)) }
        val page = pageOf(runs, SETTINGS.copy(plan = Plan.QUICK))
        page shouldContain "It leaves out the limit of 40 cm, the interval of 35 ms, 1 of 3 replications."
        page shouldContain "<span class=\"not-tested\">not tested</span>"
        report(Condition.PUBLISHED) shouldNotContain "It leaves out"
    }

    test("all conditions are in one report, each with its figures and its promise") {
        val page = report(*Condition.entries.toTypedArray())
        Condition.entries.forEach { page shouldContain "<th scope=\"row\">(${it.letter}) ${it.title}</th>" }
        page shouldContain "<th scope=\"col\" class=\"n\">(d)</th>"
        page shouldContain "(d) version 2, reflex on the board: every run stops"
    }

    test("without any run there is a page that says so") {
        pageOf(emptyList()) shouldContain "There are no runs yet"
    }

    test("a run that failed is named with its reason and not counted") {
        val runs = made(Condition.PUBLISHED)
        val failed = runs.first().let { it.copy(result = it.result.copy(outcome = Outcome.FAILED, reason = "port <x> is gone")) }
        val page = pageOf(runs.drop(1) + failed)
        page shouldContain "port &lt;x&gt; is gone"
        page shouldContain "Not all runs of a condition are made"
    }

    test("the published pattern is found where it is") {
        val runs = made(Condition.PUBLISHED)
        val claims = publishedClaims(runs, Plan.FULL, analysis(runs, Plan.FULL, Condition.PUBLISHED, Response.PERCEIVED_TIME))
        claims.map { it.finding } shouldBe List(5) { Finding.YES }
    }

    test("and not where it is not") {
        val runs = Plan.FULL.trials(Condition.PUBLISHED).map { Finished(it, stopped(it.limit - 1.0, 100.0 + it.interval)) }
        val claims = publishedClaims(runs, Plan.FULL, analysis(runs, Plan.FULL, Condition.PUBLISHED, Response.PERCEIVED_TIME))
        claims.map { it.finding } shouldBe listOf(Finding.NO, Finding.YES, Finding.NO, Finding.NO, Finding.NO)
        claims[3].claim shouldContain "40 cm and an interval of 50 ms neither filter avoids the wall (Figure 8 of the paper)"
        claims[4].why shouldContain "add up to 100.06 %"
    }

    test("a promise is kept only if every run stops") {
        val runs = made(Condition.DEFAULTS)
        promise(runs, Condition.DEFAULTS)?.finding shouldBe Finding.YES
        val one = runs.first().let { it.copy(result = it.result.copy(outcome = Outcome.COLLIDED)) }
        promise(runs.drop(1) + one, Condition.DEFAULTS)?.finding shouldBe Finding.PARTLY
        promise(runs, Condition.VERSION_2) shouldBe null
    }

    test("all collisions enter a time alike, and the least time each with what was left") {
        val runs = made(Condition.PUBLISHED)
        val wall = runs.first { it.trial.view == View.NONE && it.trial.limit == 40 }.result
        Response.PERCEIVED_TIME.of(wall, Plan.FULL) shouldBe 12.0
        Response.LIMIT_TIME.of(wall, Plan.FULL) shouldBe 12.0
        Response.LEAST_PERCEIVED_TIME.of(wall.copy(sincePerceivingMs = 3500.0), Plan.FULL) shouldBe 3.5
        Response.DISTANCE.of(wall, Plan.FULL) shouldBe 0.0
    }

    test("an experiment that lacks a run is not analysed, and the factors are in their places") {
        val runs = made(Condition.DEFAULTS)
        analysis(runs.drop(1), Plan.FULL, Condition.DEFAULTS, Response.PERCEIVED_TIME) shouldBe null
        val byInterval = runs.map { it.copy(result = stopped(sinceLimitMs = it.trial.interval * 10.0)) }
        analysis(byInterval, Plan.FULL, Condition.DEFAULTS, Response.PERCEIVED_TIME)?.share(Source.B).shouldNotBeNull() shouldBe
            (1.0 plusOrMinus 1e-9)
    }

    test("a real robot is not described as a simulated one") {
        val page = pageOf(made(Condition.DEFAULTS), settings.copy(port = "tty<0>"))
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
            val page = writeReport(tempdir().toPath(), settings, left, MADE, if (lost == View.NONE) ::svg else ::undrawn).readText()
            page shouldContain "Failed and left out (54 in all)"
            page.replace(Regex("base64,[^\"]*"), "") shouldNotContain "NaN"
        }
    }

    test("where the line alone takes longer than the limit leaves, a collision is said to be the line's") {
        val wall = collided(8000.0)
        val slow = Trial(Condition.DEFAULTS, View.NONE, 80, 20, 1, sensors = 768)
        val seconds = TimeScale.SECONDS
        fate(Finished(slow, wall), seconds) shouldBe "too slow"
        fate(Finished(slow.copy(baud = 115_200), wall), seconds) shouldBe "wall"
        fate(Finished(slow, wall.copy(outcome = Outcome.IDLE)), seconds) shouldBe "idle"
        fate(Finished(slow, stopped(sinceLimitMs = 1234.0)), seconds) shouldBe "1.23"
        fate(Finished(slow, stopped(sinceLimitMs = 234.0)), TimeScale.MILLISECONDS) shouldBe "234"
        fate(Finished(slow, stopped(sinceLimitMs = 234.0, lateMs = 99.0)), TimeScale.MILLISECONDS) shouldBe "234*"
    }

    test("the table of scaling says from which line on every robot stops") {
        val bauds = listOf(9_600, 38_400, 115_200, 250_000)
        val runs = bauds.map { Trial(Condition.DEFAULTS, View.NONE, 80, 20, 1, it, 48) }.map { trial ->
            Finished(trial, if (trial.baud == 38_400) stopped().copy(outcome = Outcome.COLLIDED) else stopped(sinceLimitMs = 1500.0))
        }
        Scaling(runs).table("Table 9") shouldContain "<td class=\"n\">1.50</td><td class=\"n\">wall</td><td class=\"n\">1.50</td><td " +
            "class=\"n\">1.50</td><td class=\"n\">115200 baud</td>"
        Scaling(runs.take(2)).table("Table 9") shouldContain "<td class=\"n\">none</td><td class=\"n\">–</td>"
    }

    test("what rounds to nought has no sign") {
        listOf(-0.04, -0.0, 0.04).map { rounded(it, 1) }.distinct() shouldBe listOf("0.0")
        rounded(-0.4, 0) shouldBe "0"
        rounded(-0.06, 1) shouldBe "-0.1"
    }

    test("the median of an even number of runs is between the two in the middle") {
        median(listOf(4.0, 1.0, 2.0, 8.0)) shouldBe 3.0
        median(listOf(4.0, 1.0, 2.0)) shouldBe 2.0
    }
})
