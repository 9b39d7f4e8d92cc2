package samples.experiment.report

import org.jetbrains.letsPlot.intern.Plot
import samples.experiment.Condition
import samples.experiment.Finished
import samples.experiment.Outcome
import samples.experiment.Settings
import samples.experiment.View
import samples.experiment.analysis.Factorial
import samples.experiment.analysis.Published
import samples.experiment.analysis.Response
import samples.experiment.analysis.Source
import samples.experiment.analysis.analysis
import samples.experiment.analysis.words
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64

/**
 * Writes the report on the [finished] runs as one page, `report.html`, and its figures as SVG and PNG in `figures/`.
 *
 * @param machine what they were made on, in words
 * @return where the page is
 */
internal fun writeReport(directory: Path, settings: Settings, finished: List<Finished>, machine: String): Path {
    Files.createDirectories(directory.resolve("figures"))
    val page = directory.resolve("report.html")
    Files.writeString(page, page("The collision experiment", Report(directory.resolve("figures"), settings, finished, machine).body()))
    return page
}

private const val CONFIDENCE = 0.95

private class Report(private val figures: Path, private val settings: Settings, finished: List<Finished>, private val machine: String) {
    private val plan = settings.plan
    private val failed = finished.filter { !it.isMeasured && !it.trial.isScaled }
    private val runs = finished.filter { it.isMeasured && !it.trial.isScaled }.sortedBy { it.trial.condition }
    private val scaled = finished.filter { it.trial.isScaled }
    private val analyses: Map<Response, Map<Condition, Factorial>> = Response.entries.associateWith { response ->
        Condition.entries.mapNotNull { condition -> analysis(finished, plan, condition, response)?.let { condition to it } }.toMap()
    }

    fun body(): String =
        listOf(head(), claims(), distances(), times(), allocation(), scaling(), method(settings, runs, failed, machine)).joinToString("\n")

    private fun head(): String {
        val counts = table(
            listOf("condition", "runs", "stopped") + View.entries.map(::words),
            Condition.entries.filter { condition -> runs.any { it.trial.condition == condition } }.map { condition ->
                val own = runs.filter { it.trial.condition == condition }
                listOf("(${condition.letter}) ${condition.title}", "${own.size}", "${stopped(own)}") +
                    View.entries.map { view -> own.filter { it.trial.view == view }.let { "${stopped(it)} of ${it.size}" } }
            },
        )
        return """<h1>The collision experiment</h1>
<p>A robot with twelve sensors stands 2 m from a wall and drives towards it at 10 cm/s; its agent must stop it when the front distance
falls below a limit.
It is the case study of C. E. Pantoja, M. F. Stabile Jr., N. M. Lazarin and J. S. Sichman, “ARGO: An Extended Jason Architecture that
Facilitates Embedded Robotic
Agents Programming”, EMAS 2016, made anew on ${if (settings.port == null) "a simulated robot in real time" else "a real robot"}. Three
factors, each with its levels:
the distance limit L (${plan.limits.joinToString()} cm), the perception interval I (${plan.intervals.joinToString()} ms), the filter F
(none, front side, front distance);
${plan.replications} replications of each of the ${plan.limits.size * plan.intervals.size * View.entries.size} combinations.</p>
<p>Runs that stopped before the wall:</p>
$counts"""
    }

    private fun stopped(runs: List<Finished>) = runs.count { it.result.outcome == Outcome.STOPPED }

    private fun claims(): String {
        val published = publishedClaims(runs, plan, analyses.getValue(Response.TIME)[Condition.PUBLISHED])
        val own = (Condition.entries - Condition.PUBLISHED).mapNotNull { promise(runs, it) }
        return "<h2>What was reproduced, what was not, and why</h2>\n" + published.joinToString("\n", transform = ::section) +
            (if (own.isEmpty()) "" else "<h3>And this project's own conditions</h3>\n" + own.joinToString("\n", transform = ::section))
    }

    private fun section(claim: Claim) = """<section class="claim"><p><strong>${escaped(claim.claim)}</strong>
<span class="${claim.finding.word.replace(' ', '-')}">${claim.finding.word}</span></p>
<p>${escaped(claim.seen)}</p><p class="soft">${escaped(claim.why)}</p></section>"""

    private fun distances() = "<h2>Stopping distances</h2>\n" +
        figure(
            "distances",
            "Each dot is a run (n = ${runs.size}, ${plan.replications} of each combination in each condition); a cross at 0 is a robot " +
                "that ran into the wall. The dashed line is the limit.",
            "A plot of the distance from the wall at which each robot stopped, by limit, interval, filter and condition. How many " +
                "stopped is in the table above.",
        ) { distancesFigure(runs, plan, it) }

    private fun times() = "<h2>Response times</h2>\n" + figure(
        "times",
        "From crossing the limit to stopping, on a logarithmic axis (n = ${runs.size}). A cross is a robot that ran into the wall, at " +
            "the time that its limit left: its agent needed longer. " +
            "Boxes are quartiles of all runs, those at the wall too.",
        "A plot of the response times of all runs, by filter and condition; the table below has their median and range.",
    ) { timesFigure(runs, it) } + table(
        listOf("condition", "filter", "stopped", "median, s", "least, s", "most, s"),
        Condition.entries.flatMap { condition ->
            View.entries.map { view -> runs.filter { it.trial.condition == condition && it.trial.view == view } }
        }
            .filter { it.isNotEmpty() }.map(::timesRow),
        words = 2,
    )

    private fun timesRow(cell: List<Finished>): List<String> {
        val seconds = cell.filter { it.result.outcome == Outcome.STOPPED }.map { it.result.responseMs / 1000 }.sorted()
        val figures = if (seconds.isEmpty()) listOf("–", "–", "–")
        else listOf(median(seconds), seconds.first(), seconds.last()).map(::three)
        return listOf(
            cell.first().trial.condition.let { "(${it.letter})" }, words(cell.first().trial.view), "${seconds.size} of ${cell.size}",
        ) + figures
    }

    private fun allocation(): String {
        val time = analyses.getValue(Response.TIME)
        if (time.isEmpty()) return "<h2>Allocation of variation</h2>\n<p>Not all runs of a condition are made, so there is nothing to " +
            "analyse yet.</p>"
        return """<h2>Allocation of variation</h2>
<p>By the method of R. Jain, <em>The Art of Computer Systems Performance Analysis</em>: the share of each factor and interaction in the
variation of a response, as sums of squares
of the effects over the total one.</p>
""" + shares(Response.TIME, published = true) +
            figure("shares", "The shares of the table above.", "A bar chart of the table above.") { sharesFigure(time, it) } +
            shares(Response.LEAST_TIME, published = true) + shares(Response.DISTANCE, published = false) + effects(time)
    }

    private fun shares(response: Response, published: Boolean): String {
        val columns = analyses.getValue(response)
        val rows = Source.entries.map { source ->
            listOf(words(source)) + (if (published) listOf("${Published.percent[source]}") else emptyList()) +
                columns.values.map { three(100 * it.share(source)) }
        } + listOf(
            listOf("error") + (if (published) listOf("${Published.ERROR_PERCENT}") else emptyList()) +
                columns.values.map { three(100 * it.errorShare) },
        )
        val deviation = listOf(
            listOf("variance") + (if (published) listOf("–") else emptyList()) + columns.values.map { three(it.total / (it.count - 1)) },
        )
        return "<h3>${response.title.replaceFirstChar(Char::uppercase)}</h3>\n<p>In percent. A robot that ran into the wall enters " +
            "${escaped(response.collisions)}. " +
            "The last row is the variance of what is divided up, in ${response.unit}².</p>\n" +
            table(
                listOf("share") + (if (published) listOf("published") else emptyList()) + columns.keys.map { "(${it.letter})" },
                rows + deviation,
            )
    }

    private fun effects(analyses: Map<Condition, Factorial>): String = analyses.entries.joinToString("\n") { (condition, analysis) ->
        val rows = listOf(Source.A, Source.B, Source.C).flatMap { source ->
            analysis.effects(source, CONFIDENCE).map {
                listOf(
                    words(source), level(source, it.levels.single()), three(it.value), interval(it.low, it.high),
                    if (it.isSignificant) "yes" else "no",
                )
            }
        }
        "<details><summary>Effects on the response time, (${condition.letter}) ${escaped(condition.title)}: mean " +
            "${three(analysis.mean)} s</summary>\n" +
            table(listOf("factor", "level", "effect, s", "95 % interval, s", "differs from 0"), rows, words = 2) + "</details>"
    }

    private fun interval(low: Double, high: Double) =
        if (low.isInfinite()) "unknown: one replication" else "${three(low)} to ${three(high)}"

    private fun level(source: Source, level: Int) = when (source) {
        Source.A -> "${plan.limits[level]} cm"
        Source.B -> "${plan.intervals[level]} ms"
        else -> words(View.entries[level])
    }

    private fun scaling(): String {
        if (scaled.isEmpty()) return ""
        val all = scaled + runs.filter { run ->
            run.trial.replication == 1 && scaled.any { it.trial.copy(baud = run.trial.baud, sensors = run.trial.sensors) == run.trial }
        }
        val scaling = Scaling(all)
        return "<h2>Beyond the paper: more sensors, other lines</h2>\n" + scaling.introduction() + figure(
            "scaling",
            "Seconds from the limit to the stop. Green: fast. Orange: slow. Red: no stop. ${Scaling.EXPLAINED}",
            "A map of what became of the robot for each number of sensors and each baud rate; the table below says the same.",
        ) { scalingFigure(all, it) } + "<h3>Where each condition begins to fail</h3>\n" + scaling.table()
    }

    /**
     * Writes the figure [name] as SVG and PNG, and shows it in the page in the colours of the reader; [instead] is its text for screen
     * readers.
     */
    private fun figure(name: String, caption: String, instead: String, plot: (Shades) -> Plot): String {
        if (runs.isEmpty() && scaled.isEmpty()) return "<p>There are no runs yet.</p>"
        val light = svg(plot(Shades.LIGHT))
        Files.writeString(figures.resolve("$name.svg"), light)
        Files.write(figures.resolve("$name.png"), png(light))
        return """<figure><div class="wide" tabindex="0" role="group" aria-label="figure"><picture>
<source media="(prefers-color-scheme: dark)" srcset="${data(svg(plot(Shades.DARK)))}">
<img alt="${escaped(instead)}" src="${data(light)}"></picture></div>
<figcaption>${escaped(caption)}</figcaption></figure>
"""
    }

    private fun data(svg: String) = "data:image/svg+xml;base64," + Base64.getEncoder().encodeToString(svg.toByteArray())
}
