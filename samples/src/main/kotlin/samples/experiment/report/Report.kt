package samples.experiment.report

import org.jetbrains.letsPlot.intern.Plot
import samples.collision.Course
import samples.collision.Sensors
import samples.experiment.Campaign
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
import samples.experiment.frameNanos
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64

/**
 * Writes what there is to say of the [finished] runs as one page, `report.html`, and its figures as SVG and PNG in `figures/`.
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

    fun body(): String = listOf(head(), claims(), distances(), times(), allocation(), scaling(), method()).joinToString("\n")

    private fun head(): String {
        val counts = table(
            listOf("condition", "runs", "stopped", "no filter", "front side", "front distance"),
            Condition.entries.filter { condition -> runs.any { it.trial.condition == condition } }.map { condition ->
                val own = runs.filter { it.trial.condition == condition }
                listOf("(${condition.letter}) ${condition.title}", "${own.size}", "${stopped(own)}") +
                    View.entries.map { view -> own.filter { it.trial.view == view }.let { "${stopped(it)} of ${it.size}" } }
            },
        )
        return """<h1>The collision experiment</h1>
<p>A robot with twelve sensors stands 2 m from a wall and drives towards it at 10 cm/s; its agent must stop it when the front distance falls below a limit.
It is the case study of C. E. Pantoja, M. F. Stabile Jr., N. M. Lazarin and J. S. Sichman, “ARGO: An Extended Jason Architecture that Facilitates Embedded Robotic
Agents Programming”, EMAS 2016, made anew on ${if (settings.port == null) "a simulated robot in real time" else "a real robot"}. Three factors, each with its levels:
the distance limit L (${plan.limits.joinToString()} cm), the perception interval I (${plan.intervals.joinToString()} ms), the filter F (none, front side, front distance);
${plan.replications} replications of each of the ${plan.limits.size * plan.intervals.size * View.entries.size} combinations.</p>
<p>Runs that stopped before the wall:</p>
$counts"""
    }

    private fun stopped(runs: List<Finished>) = runs.count { it.result.outcome == Outcome.STOPPED }

    private fun claims(): String {
        val published = publishedClaims(runs, plan, analyses.getValue(Response.TIME)[Condition.PUBLISHED])
        val own = listOf(Condition.DEFAULTS, Condition.VERSION_2).mapNotNull { promise(runs, it) }
        return "<h2>What was reproduced, what was not, and why</h2>\n" + published.joinToString("\n", transform = ::section) +
            (if (own.isEmpty()) "" else "<h3>And this project's own conditions</h3>\n" + own.joinToString("\n", transform = ::section))
    }

    private fun section(claim: Claim) = """<section class="claim"><p><strong>${escaped(claim.claim)}</strong>
<span class="${claim.finding.word.replace(' ', '-')}">${claim.finding.word}</span></p>
<p>${escaped(claim.seen)}</p><p class="soft">${escaped(claim.why)}</p></section>"""

    private fun distances() = "<h2>Stopping distances</h2>\n" +
        figure("distances", "Each dot is a run; a cross at 0 is a robot that ran into the wall. The dashed line is the limit.") { distancesFigure(runs, plan, it) }

    private fun times() = "<h2>Response times</h2>\n" + figure(
        "times",
        "From crossing the limit to stopping, on a logarithmic axis. A cross is a robot that ran into the wall, at the time that its limit left: its agent needed longer.",
    ) { timesFigure(runs, it) } + table(
        listOf("condition", "filter", "stopped", "median s", "least s", "most s"),
        Condition.entries.flatMap { condition -> View.entries.map { view -> runs.filter { it.trial.condition == condition && it.trial.view == view } } }
            .filter { it.isNotEmpty() }.map(::timesRow),
        words = 2,
    )

    private fun timesRow(cell: List<Finished>): List<String> {
        val seconds = cell.filter { it.result.outcome == Outcome.STOPPED }.map { it.result.responseMs / 1000 }.sorted()
        val figures = if (seconds.isEmpty()) listOf("–", "–", "–") else listOf(seconds[seconds.size / 2], seconds.first(), seconds.last()).map(::two)
        return listOf(cell.first().trial.condition.let { "(${it.letter})" }, cell.first().trial.view.word, "${seconds.size} of ${cell.size}") + figures
    }

    private fun allocation(): String {
        val time = analyses.getValue(Response.TIME)
        if (time.isEmpty()) return "<h2>Allocation of variation</h2>\n<p>Not all runs of a condition are made, so there is nothing to analyse yet.</p>"
        return """<h2>Allocation of variation</h2>
<p>By the method of R. Jain, <em>The Art of Computer Systems Performance Analysis</em>: the share of each factor and interaction in the variation of a response, as sums of squares
of the effects over the total one.</p>
""" + shares(Response.TIME, published = true) + figure("shares", "The shares of the first table.") { sharesFigure(time, it) } +
            shares(Response.LEAST_TIME, published = true) + shares(Response.DISTANCE, published = false) + effects(time)
    }

    private fun shares(response: Response, published: Boolean): String {
        val columns = analyses.getValue(response)
        val rows = Source.entries.map { source ->
            listOf(words(source)) + (if (published) listOf("${Published.percent[source]}") else emptyList()) + columns.values.map { three(100 * it.share(source)) }
        } + listOf(listOf("error") + (if (published) listOf("${Published.ERROR_PERCENT}") else emptyList()) + columns.values.map { three(100 * it.errorShare) })
        val deviation = listOf(listOf("variance") + (if (published) listOf("–") else emptyList()) + columns.values.map { three(it.total / (it.count - 1)) })
        return "<h3>${response.title.replaceFirstChar(Char::uppercase)}</h3>\n<p>In percent. A robot that ran into the wall enters ${escaped(response.collisions)}. " +
            "The last row is the variance of what is divided up, in ${response.unit}².</p>\n" +
            table(listOf("share") + (if (published) listOf("published") else emptyList()) + columns.keys.map { "(${it.letter})" }, rows + deviation)
    }

    private fun effects(analyses: Map<Condition, Factorial>): String = analyses.entries.joinToString("\n") { (condition, analysis) ->
        val rows = listOf(Source.A, Source.B, Source.C).flatMap { source ->
            analysis.effects(source, CONFIDENCE).map {
                listOf(words(source), level(source, it.levels.single()), three(it.value), interval(it.low, it.high), if (it.isSignificant) "yes" else "no")
            }
        }
        "<details><summary>Effects on the response time, (${condition.letter}) ${escaped(condition.title)}: mean ${three(analysis.mean)} s</summary>\n" +
            table(listOf("factor", "level", "effect s", "95 % interval", "differs from 0"), rows, words = 2) + "</details>"
    }

    private fun interval(low: Double, high: Double) = if (low.isInfinite()) "unknown: one replication" else "${three(low)} to ${three(high)}"

    private fun level(source: Source, level: Int) = when (source) {
        Source.A -> "${plan.limits[level]} cm"
        Source.B -> "${plan.intervals[level]} ms"
        else -> View.entries[level].word
    }

    private fun scaling(): String {
        if (scaled.isEmpty()) return ""
        val all = scaled + runs.filter { run ->
            run.trial.replication == 1 && scaled.any { it.trial.copy(baud = run.trial.baud, sensors = run.trial.sensors) == run.trial }
        }
        return """<h2>Beyond the paper: more sensors, other lines</h2>
<p>A limit of ${all.first().trial.limit} cm, an interval of ${all.first().trial.interval} ms, one run for each field: seconds from the limit to the stop, or the wall.
More sensors are further sets of the twelve, each of which moves the agent to as much as the first. A version 1 message holds 255 bytes, about twenty percepts: a board with more
sends several, each of which is a snapshot of its own to the computer: an agent that sees the front in one of them misses it in the next. The first one is also taken for the end of the answer, so
commands and requests arrive while the board is still sending, and of those it keeps the last one only; where no command to drive arrives at all the robot never drives. Version 2 has no such bound.</p>
""" + figure("scaling", "Green: fast. Orange: slow. Red: into the wall, or idle: the robot never drove, or failed: the agent gave up.") { scalingFigure(all, it) } +
            "<h3>Where each condition begins to fail</h3>\n" + table(
            listOf("condition", "filter", "sensors", "stops from", "does not up to", "request and answer take, at the slowest that stops"),
            all.groupBy { Triple(it.trial.condition, it.trial.view, it.trial.sensors) }.toSortedMap(compareBy({ it.first }, { it.second }, { it.third })).values.map(::failureRow),
            words = 2,
        )
    }

    private fun failureRow(cell: List<Finished>): List<String> {
        val (stopped, not) = cell.partition { it.result.outcome == Outcome.STOPPED }
        val slowest = stopped.minByOrNull { it.trial.baud }
        return listOf(
            "(${cell.first().trial.condition.letter})", cell.first().trial.view.word, "${cell.first().trial.sensors}",
            slowest?.let { "${it.trial.baud} baud" } ?: "never", not.maxOfOrNull { it.trial.baud }?.let { "$it baud" } ?: "never",
            slowest?.let { "${frameNanos(it.trial) / 1_000_000} ms" } ?: "–",
        )
    }

    private fun method(): String {
        val late = runs.map { it.result.lateMs }.sorted()
        val lateness = if (late.isEmpty()) "" else "The most that a thread which asked to be woken every 5 ms was woken late in a run was ${one(late.last())} ms, the median over runs ${one(late[late.size / 2])} ms; " +
            "a run in which it was more than ${Campaign.MOST_LATE_MS.toInt()} ms was made anew, up to ${Campaign.MOST_TRIES} times, and ${late.count { it > Campaign.MOST_LATE_MS }} of ${late.size} that are counted here still were. A request and its answer take ${frameNanos(runs.first().trial) / 1_000_000} ms."
        return """<h2>How it was made</h2>
<ul>
<li><strong>Robot</strong>: it starts ${Course.START_CM.toInt()} cm from the wall, drives at ${Course.SPEED_CM_S.toInt()} cm/s and starts and stops at once; at 0 cm it has collided.</li>
<li><strong>Sensors</strong>: distance, light and temperature on four sides. All ${Sensors.PER_SET} readings change in each frame; a distance reading is the next whole centimetre or up to ${Sensors.DISTANCE_NOISE} cm more.</li>
<li><strong>Line</strong>: 9600 baud, each byte takes its ten bit times in each direction.</li>
<li><strong>Board</strong>, (a) and (b): version 1 of Javino, one message at a time; of several that arrive while it answers it handles the last one. (c): version 2 as the library in <code>javino-arduino</code> speaks it.</li>
<li><strong>Agent</strong>: the published one, plan for plan: <code>samples/experiment/robot.asl</code>. (a): <code>argo_sensing=in_cycle</code>, <code>protocol(1)</code>, commands unpaced. (b): no option but the baud rate and the time an answer may take. (c): <code>protocol(2)</code>, and filters that say what they keep, so that the board is asked for that.</li>
<li><strong>Computer</strong>: the reasoning of each agent, not its sensing thread, is slowed ${settings.slowdown} times: ${escaped(settings.computer)}. That compares whole-number division alone and stands for the
single-board computers of 2016; it is an assumption, set with <code>--slowdown</code>. The published figure for the Raspberry Pi 3 Model B+ (687.45 events a second at 1.4 GHz,
https://leoncode.co.uk/articles/raspberry-pi-benchmarks) is taken times 1.2/1.4 for the Model B of 2016, which has the same core.</li>
<li><strong>Time</strong>: real. ${escaped(lateness)}</li>
<li><strong>Order</strong>: random, all conditions mixed, seed ${settings.seed}. ${escaped(machine)}</li>
<li><strong>Records</strong>: <code>runs/*.jsonl</code>, one file a run: each frame, each command and each change of the believed front distance with its time.${if (failed.isEmpty()) "" else " ${failed.size} runs have failed and are left out: " + escaped(failed.joinToString("; ") { "${it.trial.id}: ${it.result.reason}" })}</li>
</ul>"""
    }

    /** Writes the figure [name] as SVG and PNG, and shows it in the page in the colours of the reader. */
    private fun figure(name: String, caption: String, plot: (Shades) -> Plot): String {
        if (runs.isEmpty() && scaled.isEmpty()) return "<p>There are no runs yet.</p>"
        val light = svg(plot(Shades.LIGHT))
        Files.writeString(figures.resolve("$name.svg"), light)
        Files.write(figures.resolve("$name.png"), png(light))
        return """<figure><div class="wide"><picture><source media="(prefers-color-scheme: dark)" srcset="${data(svg(plot(Shades.DARK)))}">
<img alt="${escaped(caption)}" src="${data(light)}"></picture></div>
<figcaption>${escaped(caption)}</figcaption></figure>
"""
    }

    private fun data(svg: String) = "data:image/svg+xml;base64," + Base64.getEncoder().encodeToString(svg.toByteArray())
}
