package benchmarks

import org.jetbrains.letsPlot.Stat
import org.jetbrains.letsPlot.awt.plot.PlotSvgExport
import org.jetbrains.letsPlot.geom.geomBar
import org.jetbrains.letsPlot.geom.geomLine
import org.jetbrains.letsPlot.geom.geomPoint
import org.jetbrains.letsPlot.ggsize
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.intern.toSpec
import org.jetbrains.letsPlot.label.labs
import org.jetbrains.letsPlot.letsPlot
import org.jetbrains.letsPlot.pos.positionDodge
import org.jetbrains.letsPlot.scale.scaleXLog10
import org.jetbrains.letsPlot.themes.themeMinimal

private const val WIDTH = 640
private const val HEIGHT = 400

/** The ages of the snapshots on which intentions acted, with the number of [sensors], and of [plans] for each percept. */
internal class Ages(val sensors: Int, val plans: Int, val distribution: Distribution)

/** Plots the distribution of the ages in SVG: for each age, the share of actions at that age or below. */
internal fun agePlot(measured: List<Ages>): String {
    val points = measured.flatMap { ages -> SHARES.map { share -> Triple(ages, share, ages.distribution.ms(share)) } }
    val data = mapOf(
        "age" to points.map { it.third },
        "share" to points.map { it.second * 100 },
        "case" to points.map { "${it.first.sensors} × ${it.first.plans}" },
    )
    return svg(
        letsPlot(data) { x = "age"; y = "share"; color = "case" } + geomLine() + geomPoint(size = 2.0) + scaleXLog10() +
            labs(
                title = "Age of the snapshot that an intention acts on", x = "age at most, ms", y = "share of actions, %",
                color = "sensors × plans",
            ),
    )
}

/** Plots the share of the line's time for requests and answers, by baud rate and version, in SVG. */
internal fun lineUsePlot(shares: Map<Pair<Int, Int>, Double>): String {
    val data = mapOf(
        "baud" to shares.keys.map { "${it.first} baud" },
        "version" to shares.keys.map { "version ${it.second}" },
        "use" to shares.values.map { it * 100 },
    )
    return svg(
        letsPlot(data) { x = "baud"; y = "use"; fill = "version" } +
            geomBar(stat = Stat.identity, position = positionDodge(), width = 0.7) +
            labs(title = "Line use of an agent that senses with argo.limit(0)", x = "", y = "% of the line's time", fill = ""),
    )
}

private val SHARES = listOf(0.01, 0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 0.999, 1.0)

private fun svg(plot: Plot): String =
    PlotSvgExport.buildSvgImageFromRawSpecs((plot + ggsize(WIDTH, HEIGHT) + themeMinimal()).toSpec().toMutableMap())
