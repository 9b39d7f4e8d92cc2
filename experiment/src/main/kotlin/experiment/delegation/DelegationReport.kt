package experiment.delegation

import argo.tools.command.counted
import experiment.MAX_TRIES
import experiment.Settings
import experiment.report.Figures
import experiment.report.Provenance
import experiment.report.Source
import experiment.report.escaped
import experiment.report.method
import experiment.report.one
import experiment.report.page
import experiment.report.rounded
import experiment.report.shareIntervals
import experiment.report.table
import experiment.report.whole
import experiment.report.words
import java.nio.file.Files
import java.nio.file.Path
import java.time.temporal.ChronoUnit

/**
 * Writes the report on [measured], all runs of an experiment, to `report.html` and `figures/` in [directory]. Returns the file of the page.
 */
internal fun writeDelegationReport(
    directory: Path, settings: Settings<DelegationPlan>, measured: List<Measured>, made: Provenance,
): Path {
    val report = DelegationReport(Figures(directory.resolve("figures")), settings, measured, made)
    return Files.writeString(directory.resolve("report.html"), page("One agent or several", report.body()))
}

private class DelegationReport(
    private val figures: Figures,
    private val settings: Settings<DelegationPlan>,
    private val measured: List<Measured>,
    private val made: Provenance,
) {
    private val plan = settings.plan
    private val comparison = Comparison(measured, plan)
    private val others = Design.entries - Design.ONE
    private var tables = 0

    private fun nextTable() = "Table ${++tables}"

    fun body() = listOf(head(), reactions(), everyLoad(), work(), shares(), method(settings, measured, made)).joinToString("\n")

    private fun head() = """<h1>One agent or several</h1>
<p>Does one agent with all sensors react faster, or do several agents that share the work? C. E. Pantoja, M. F. Stabile Jr., N. M. Lazarin
and J. S. Sichman asked this at the end of “ARGO: An Extended Jason Architecture that Facilitates Embedded Robotic Agents Programming”,
EMAS 2016. The reaction is the time from a sensor's change to the command that it causes. A ratio below 1 means that a design reacts faster
than one agent with one board.</p>
<p>Made with ARGO ${escaped(made.build)} on ${made.at.truncatedTo(ChronoUnit.MINUTES)}. All runs are in <code>runs</code>.</p>
${late()}""" + table(
        "${nextTable()}. Reaction as a ratio to that of one agent in the same block: the geometric mean over all loads, with its 95 % " +
            "interval.",
        listOf("processors") + others.map { it.title },
        plan.processors.map { count ->
            listOf("$count") + others.map { design -> text(comparison.ratio(design, plan.loads.filter { it.processors == count })) }
        },
    )

    private fun late(): String {
        val late = measured.filter { it.result.isLate }.ifEmpty { return "" }
        return "<p><strong>The machine was busy.</strong> In ${late.size} of ${measured.size} runs it was more than " +
            "${whole(DelegationResult.MAX_LATE_MS)} ms late, ${whole(late.maxOf { it.result.lateMs })} ms at most, although each of them " +
            "was made $MAX_TRIES times. They count all the same.</p>\n"
    }

    private fun reactions() = "<h2>Reactions</h2>\n" + plan.intervals.joinToString("") { interval ->
        figures.write(
            "reactions-$interval",
            "A sensing interval of $interval ms. Each dot is the median reaction of a run, a line leads through the medians of " +
                "${plan.blocks} blocks.",
            "A plot of the reactions of all designs by sensors, plans and processors. The next table has the medians and ratios.",
        ) { reactionsFigure(comparison, interval, it) }
    }

    private fun everyLoad() = table(
        "${nextTable()}. The median reaction of one agent, and the others' as a ratio to it with its 95 % interval.",
        HEADS + listOf("one agent, ms") + others.map { it.title },
        plan.loads.map { load ->
            heads(load) + one(comparison.reaction(load, Design.ONE)) + others.map { text(comparison.ratio(it, listOf(load))) }
        },
        words = 0,
    )

    private fun work() = "<h2>Work</h2>\n" + table(
        "${nextTable()}. Processors at work for the agents on average, and in brackets the share of stimuli in % without a reaction " +
            "within ${Stimuli.LIMIT_MS / 1000} s, if any.",
        HEADS + Design.entries.map { it.title },
        plan.loads.map { load -> heads(load) + Design.entries.map { work(comparison.results(load, it)) } },
        words = 0,
    )

    private fun work(results: List<DelegationResult>): String {
        val missed = results.sumOf { it.missed }
        val share = 100.0 * missed / results.sumOf { it.times.size }
        return rounded(results.map { it.busy }.average(), 2) + if (missed > 0) " (${one(share)})" else ""
    }

    private fun shares(): String {
        if (plan.sensors.size < 2 || plan.plans.size < 2) return ""
        val columns = plan.processors.flatMap { p -> plan.intervals.map { p to it } }
        val analyses = columns.map { (processors, interval) -> comparison.allocation(processors, interval) }
        val intervals = analyses.map { shareIntervals(it, settings.seed) }
        val rows = Source.entries.map { source ->
            listOf(words(source, FACTORS)) + analyses.zip(intervals) { analysis, all ->
                percent(analysis.share(source)) +
                    all?.sources?.getValue(source)?.let { " (${percent(it.low)} to ${percent(it.high)})" }.orEmpty()
            }
        }
        return ALLOCATION + table(
            "${nextTable()}. Shares in the variation in percent, with their 95 % intervals.",
            listOf("share") + columns.map { (p, i) -> "${counted(p, "processor")}, $i ms" },
            rows + listOf(listOf("error") + analyses.map { percent(it.errorShare) }),
        )
    }

    private fun heads(load: Load) = load.run { listOf("$processors", "$interval", "$sensors", "$plans") }

    private fun text(ratio: Ratio) =
        rounded(ratio.value, 2) + ratio.interval?.let { " (${rounded(it.low, 2)} to ${rounded(it.high, 2)})" }.orEmpty()

    private fun percent(share: Double) = one(100 * share)

    private companion object {
        val HEADS = listOf("processors", "interval, ms", "sensors", "plans a percept")
        val FACTORS = listOf("D", "S", "P")
        const val ALLOCATION = """<h2>Allocation of variation</h2>
<p>The shares of design D, sensors S, plans P and their interactions in the variation of the reaction's logarithm, by R. Jain's method, with
generalized confidence intervals as in the report on the collision experiment. Differences between blocks are part of the error.</p>
"""
    }
}

/** Describes the method of the experiment as items of an HTML list. Uses its [settings] and its [measured] runs. */
internal fun method(settings: Settings<DelegationPlan>, measured: List<Measured>, made: Provenance): String {
    val plan = settings.plan
    return method(
        DESIGN + listOf(
            "Load" to "all readings change with each message. ${plan.sensors.joinToString()} sensors, a third of each kind; " +
                "${plan.plans.joinToString()} plans a percept, of which all but the last ask a belief and do not apply; intervals of " +
                "${plan.intervals.joinToString()} ms.",
            "Computer" to "the reasoning of the agents, not their sensing threads, is slowed ${settings.slowdown} times: " +
                "${escaped(settings.computer)}. A reasoning cycle holds one of ${plan.processors.joinToString(" or ")} processors, and " +
                "takes the processor time that it takes here, times the slowdown. So this machine, which is idle most of the time, " +
                "stands for computers with more processors and fewer.",
            "Runs" to "${plan.blocks} blocks, each with all ${plan.loads.size * Design.entries.size} combinations once, in random order, " +
                "seed ${settings.seed}. A run is measured for ${DelegationLaboratory.MEASURED_MS} ms, after " +
                "${DelegationLaboratory.WARM_UP_MS} ms. Its reaction is the median of its reactions. ${escaped(made.machine)}",
            "Intervals" to "Student's t of the logarithms of the ratios within the blocks. One in twenty misses its ratio.",
            "Time" to "real. A thread wakes every 5 ms; its largest delay in a run was ${one(measured.maxOf { it.result.lateMs })} ms. " +
                "A run with a delay above ${whole(DelegationResult.MAX_LATE_MS)} ms was repeated, until it was made $MAX_TRIES times.",
        ),
    )
}

private val DESIGN = listOf(
    "Designs" to "<em>${Design.ONE.title}</em> with one board. <em>${Design.BOARDS.title}</em>, one for each kind of sensor. " +
        "<em>${Design.KINDS_APART.title}</em> of sensor, each an ARGO agent with a board, as in section 5.3 of the paper. " +
        "<em>${Design.DELEGATES.title}</em>: an ARGO agent tells and untells each percept to a common agent for its kind, which " +
        "asks the ARGO agent to act. The programs are in <code>experiment/agent/delegation</code>.",
    "Stimuli" to "from time to time something comes near one of the distance sensors, drawn by seed, and stays until the robot has " +
        "stopped for it, ${Stimuli.LIMIT_MS} ms at most; the next comes 50 to 150 ms later. The reaction begins when it comes, and ends " +
        "when the board carries out the command. A stimulus without a reaction counts as ${Stimuli.LIMIT_MS} ms.",
    "Boards" to "simulated, version 2 of Javino, ${Society.BAUD} baud; each byte takes its ten bit times.",
)
