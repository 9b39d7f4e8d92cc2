package experiment.delegation

import argo.tools.command.counted
import experiment.report.Shades
import experiment.report.dressed
import experiment.report.median
import org.jetbrains.letsPlot.facet.facetGrid
import org.jetbrains.letsPlot.geom.geomLine
import org.jetbrains.letsPlot.geom.geomPoint
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.label.labs
import org.jetbrains.letsPlot.letsPlot
import org.jetbrains.letsPlot.scale.scaleColorManual
import org.jetbrains.letsPlot.scale.scaleXDiscrete
import org.jetbrains.letsPlot.scale.scaleYLog10

/** Plots the reactions of all runs at the sensing [interval], with a line through the medians of each design. */
internal fun reactionsFigure(comparison: Comparison, interval: Int, shades: Shades): Plot {
    val loads = comparison.plan.loads.filter { it.interval == interval }
    val cells = loads.flatMap { load -> Design.entries.map { load to it } }
    val runs = cells.flatMap { (load, design) -> comparison.results(load, design).map { Triple(load, design, median(it.times)) } }
    val points = columns(runs.map { it.first to it.second }) + ("ms" to runs.map { it.third })
    val lines = columns(cells) + ("ms" to cells.map { (load, design) -> comparison.reaction(load, design) })
    return (
        letsPlot(lines) { x = "sensors"; y = "ms"; color = "design"; group = "design" } + geomLine(size = 1.2) +
            geomPoint(data = points, size = 3.0, alpha = 0.6) { x = "sensors"; y = "ms"; color = "design" } +
            facetGrid(x = "plans", y = "processors") + scaleYLog10(breaks = TICKS_MS, labels = TICKS_MS.map { "${it.toInt()}" }) +
            scaleXDiscrete(limits = comparison.plan.sensors.map { "$it" }) +
            scaleColorManual(values = shades.sources.drop(1), limits = Design.entries.map { it.title }, name = "") +
            labs(x = "sensors", y = "time from stimulus to command in ms")
        ).dressed(shades, 320 * comparison.plan.plans.size, 120 + 260 * comparison.plan.processors.size)
}

private fun columns(cells: List<Pair<Load, Design>>) = mapOf(
    "sensors" to cells.map { "${it.first.sensors}" },
    "plans" to cells.map { counted(it.first.plans, "plan") + " a percept" },
    "processors" to cells.map { counted(it.first.processors, "processor") },
    "design" to cells.map { it.second.title },
)

private val TICKS_MS = listOf(5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0)
