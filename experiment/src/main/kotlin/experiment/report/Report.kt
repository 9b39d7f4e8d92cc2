package experiment.report

import experiment.Condition
import experiment.Finished
import experiment.Outcome
import experiment.Plan
import experiment.Settings
import experiment.View
import experiment.isLate
import experiment.maxLateMs
import org.jetbrains.letsPlot.intern.Plot
import java.nio.file.Files
import java.nio.file.Path
import java.time.temporal.ChronoUnit

/**
 * Writes the report on the [finished] runs. The report is the page `report.html`, the figures as SVG and PNG in `figures/`, and all runs in
 * `runs.csv`. Returns the file of the page.
 */
internal fun writeReport(
    directory: Path, settings: Settings<Plan>, finished: List<Finished>, made: Provenance, draw: (Plot) -> String = ::svg,
): Path {
    val report = Report(Figures(directory.resolve("figures"), draw), settings, finished, made)
    Files.writeString(directory.resolve("runs.csv"), csv(finished, settings.seed, made.build))
    val page = directory.resolve("report.html")
    Files.writeString(page, page("The collision experiment", report.body()))
    return page
}

private class Report(
    private val figures: Figures, private val settings: Settings<Plan>, finished: List<Finished>, private val made: Provenance,
) {
    private val plan = settings.plan
    private var tables = 0
    private val failed = finished.filter { !it.isMeasured && !it.trial.isScaled }
    private val runs = finished.filter { it.isMeasured && !it.trial.isScaled }.sortedBy { it.trial.condition }
    private val scaled = finished.filter { it.trial.isScaled }
    private val analyses: Map<Response, Map<Condition, Factorial>> = Response.entries.associateWith { response ->
        Condition.entries.mapNotNull { condition -> analysis(finished, plan, condition, response)?.let { condition to it } }.toMap()
    }

    fun body(): String =
        listOf(head(), claims(), distances(), times(), allocation(), scaling(), method(settings, runs, failed, made)).joinToString("\n")

    private fun head(): String {
        val counts = table(
            "${nextTable()}. Runs that stopped before the wall, for each limit and filter over all intervals; in brackets the 95 % " +
                "interval of their share (Wilson), in %.",
            listOf("condition", "limit, cm") + View.entries.map(::words),
            runs.groupBy { it.trial.condition to it.trial.limit }.toSortedMap(compareBy({ it.first }, { it.second }))
                .map { (row, own) ->
                    val (condition, limit) = row
                    listOf("(${condition.letter}) ${condition.title}", "$limit") +
                        View.entries.map { view -> proportion(own.filter { it.trial.view == view }) }
                },
        )
        return """<h1>The collision experiment</h1>
<p>A robot with twelve sensors stands 2 m from a wall and drives towards it at 10 cm/s; its agent must stop it when the front distance
falls below a limit.
It is the case study of C. E. Pantoja, M. F. Stabile Jr., N. M. Lazarin and J. S. Sichman, “ARGO: An Extended Jason Architecture that
Facilitates Embedded Robotic
Agents Programming”, EMAS 2016, repeated on ${if (settings.port == null) "a simulated robot in real time" else "a real robot"}. Three
factors, each with its levels:
the distance limit L (${plan.limits.joinToString()} cm), the perception interval I (${plan.intervals.joinToString()} ms), the filter F
(none, front side, front distance);
${plan.replications} replications of each of the ${plan.limits.size * plan.intervals.size * View.entries.size} combinations.</p>
<p>Made with ARGO ${escaped(made.build)} on ${made.at.truncatedTo(ChronoUnit.MINUTES)}. All runs are in <code>runs.csv</code>.</p>
${busyMachine(runs + scaled)}${leftOut()}$counts"""
    }

    private fun nextTable() = "Table ${++tables}"

    private fun proportion(runs: List<Finished>): String = if (runs.isEmpty()) "–"
    else proportionInterval(stopped(runs), runs.size).let {
        "${stopped(runs)} of ${runs.size} (${whole(100 * it.low)} to ${whole(100 * it.high)})"
    }

    /** Lists the parts of the published plan that a shorter plan lacks. */
    private fun leftOut(): String {
        val limits = (Plan.FULL.limits - plan.limits.toSet()).map { "the limit of $it cm" }
        val intervals = (Plan.FULL.intervals - plan.intervals.toSet()).map { "the interval of $it ms" }
        val fewer = Plan.FULL.replications - plan.replications
        val missing = limits + intervals + listOfNotNull("$fewer of ${Plan.FULL.replications} replications".takeIf { fewer > 0 })
        if (missing.isEmpty()) return ""
        return "<p><strong>This is a shorter plan than the published one.</strong> It leaves out ${missing.joinToString()}. " +
            "The published results about these are not tested here, and intervals are wider than with all replications.</p>\n"
    }

    private fun stopped(runs: List<Finished>) = runs.count { it.result.outcome == Outcome.STOPPED }

    private fun claims(): String {
        val published = publishedClaims(runs, plan, analyses.getValue(Response.PERCEIVED_TIME)[Condition.PUBLISHED])
        val own = (Condition.entries - Condition.PUBLISHED).mapNotNull { promise(runs, it) }
        return "<h2>Published results, found here or not</h2>\n" + published.joinToString("\n", transform = ::section) +
            (if (own.isEmpty()) "" else "<h3>This project's own conditions</h3>\n" + own.joinToString("\n", transform = ::section))
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

    private fun times(): String {
        val scale = TimeScale.of(runs.map { it.result.sinceLimitMs / 1000 })
        return """<h2>Response times</h2>
<p>Two times end when the robot stops. One begins when the robot crosses the limit. The other, which is the published one, begins when the
agent perceives the wall: when it first believes a front distance at or below the limit. The first includes the noise of the reading and
the time that the reading takes on its way to the agent. The second is negative if the board stopped the robot before its agent perceived
the wall.</p>
""" + figure(
            "times",
            "From crossing the limit to stopping, on a logarithmic axis (n = ${runs.size}). A cross is a robot that ran into the wall, " +
                "at the time that its limit left: its agent needed longer. Boxes are quartiles of all runs, those at the wall too.",
            "A plot of the response times of all runs, by filter and condition; the table below has their median and range.",
        ) { timesFigure(runs, scale, it) } + timesTable(Response.LIMIT_TIME) + timesTable(Response.PERCEIVED_TIME)
    }

    private fun timesTable(response: Response): String {
        val scale = TimeScale.of(runs.map { response.of(it.result, plan) })
        return table(
            "${nextTable()}. ${response.title.replaceFirstChar(Char::uppercase)} of the runs that stopped, over all limits and " +
                "intervals: the median with its 95 % interval (order statistics; – for fewer than six).",
            listOf("condition", "filter", "stopped") + listOf("median", "95 % interval", "least", "most").map { "$it, ${scale.unit}" },
            runs.groupBy { it.trial.condition to it.trial.view }.toSortedMap(compareBy({ it.first }, { it.second })).values
                .map { timesRow(it, response, scale) },
            words = 2,
        )
    }

    private fun timesRow(cell: List<Finished>, response: Response, scale: TimeScale): List<String> {
        val seconds = cell.filter { it.result.outcome == Outcome.STOPPED }.map { response.of(it.result, plan) }.sorted()
        val interval = medianInterval(seconds)
        val decimals = interval?.let(scale::decimals) ?: scale.fewDecimals
        val figures = if (seconds.isEmpty()) listOf("–", "–", "–", "–")
        else listOf(
            scale.text(median(seconds), decimals), interval?.let(scale::text) ?: "–",
            scale.text(seconds.first(), decimals), scale.text(seconds.last(), decimals),
        )
        val late = cell.count { it.isLate }
        return listOf(
            cell.first().trial.condition.let { "(${it.letter})" }, words(cell.first().trial.view),
            "${seconds.size} of ${cell.size}" + if (late > 0) ", $late late" else "",
        ) + figures
    }

    private fun allocation(): String {
        val time = analyses.getValue(Response.PERCEIVED_TIME)
        if (time.isEmpty()) return "<h2>Allocation of variation</h2>\n<p>Not all runs of a condition are made, so there is nothing to " +
            "analyse yet.</p>"
        return "<h2>Allocation of variation</h2>\n" + ALLOCATION_METHOD + Response.entries.joinToString("", transform = ::shares) +
            time.entries.joinToString("\n") { (condition, analysis) -> effects(nextTable(), condition, analysis, plan) }
    }

    private fun shares(response: Response): String {
        val columns = analyses.getValue(response).filterKeys { !isRepeated(response, it) }
        if (columns.isEmpty()) return ""
        val allocation = Allocation(response, columns, settings.seed)
        val shares = allocation.heading() + allocation.shares(nextTable())
        val figure = if (response != Response.PERCEIVED_TIME) ""
        else figure("shares", "The shares of Table $tables.", "A bar chart of the table above.") { sharesFigure(columns, it) }
        return shares + figure + allocation.intervals(nextTable())
    }

    /** Returns true if [response] equals the published time in all runs of [condition]. A table of [response] would then be a copy. */
    private fun isRepeated(response: Response, condition: Condition) = response == Response.LEAST_PERCEIVED_TIME &&
        runs.none { it.trial.condition == condition && it.result.outcome == Outcome.COLLIDED }

    private fun scaling(): String {
        if (scaled.isEmpty()) return ""
        val all = scaled + runs.filter { run ->
            run.trial.replication == 1 && scaled.any { it.trial.copy(baud = run.trial.baud, sensors = run.trial.sensors) == run.trial }
        }
        val scaling = Scaling(all)
        return "<h2>Beyond the paper: more sensors, other lines</h2>\n" + scaling.introduction() + figure(
            "scaling",
            "Green: fast. Orange: slow. Red: no stop. ${scaling.explained()}",
            "A map of the outcomes for each number of sensors and each baud rate; the table below says the same.",
        ) { scalingFigure(all, scaling.scale, it) } + "<h3>Slowest lines of each condition</h3>\n" + scaling.table(nextTable())
    }

    private fun figure(name: String, caption: String, instead: String, plot: (Shades) -> Plot): String =
        if (runs.isEmpty() && scaled.isEmpty()) "<p>There are no runs yet.</p>" else figures.write(name, caption, instead, plot)
}

/**
 * Writes [runs] as comma-separated values (RFC 4180). The first line has the column names, and each other line a run.
 *
 * @param seed the seed for the order of the runs
 * @param build the version and the commit of ARGO, in words
 */
internal fun csv(runs: List<Finished>, seed: Long, build: String): String {
    val heads = "run,condition,filter,limit_cm,interval_ms,replication,baud,sensors,outcome,since_limit_ms,since_perceiving_ms," +
        "distance_cm,commands,frames,late_ms,late_limit_ms,reason,seed,argo"
    val lines = runs.sortedBy { it.trial.id }.map { "${line(it)},$seed,${quoted(build)}" }
    return (listOf(heads) + lines).joinToString("") { "$it\r\n" }
}

private fun line(run: Finished): String = run.let { (trial, result) ->
    listOf(
        trial.id, trial.condition.letter, trial.view.word, trial.limit, trial.interval, trial.replication, trial.baud, trial.sensors,
        result.outcome.name.lowercase(), three(result.sinceLimitMs), result.sincePerceivingMs?.let(::three).orEmpty(),
        three(result.distance), result.commands, result.frames, three(result.lateMs), three(maxLateMs(trial.condition)),
        quoted(result.reason.orEmpty()),
    ).joinToString(",")
}

private fun quoted(text: String) = if (text.any { it in ",\"\r\n" }) "\"${text.replace("\"", "\"\"")}\"" else text
