package experiment.report

import experiment.Condition
import experiment.Finished
import experiment.Outcome
import experiment.Plan
import experiment.View
import experiment.isLate
import org.apache.batik.transcoder.TranscoderInput
import org.apache.batik.transcoder.TranscoderOutput
import org.apache.batik.transcoder.image.PNGTranscoder
import org.jetbrains.letsPlot.Stat
import org.jetbrains.letsPlot.awt.plot.PlotSvgExport
import org.jetbrains.letsPlot.coord.coordCartesian
import org.jetbrains.letsPlot.facet.facetGrid
import org.jetbrains.letsPlot.geom.geomBar
import org.jetbrains.letsPlot.geom.geomBoxplot
import org.jetbrains.letsPlot.geom.geomHLine
import org.jetbrains.letsPlot.geom.geomPoint
import org.jetbrains.letsPlot.geom.geomText
import org.jetbrains.letsPlot.geom.geomTile
import org.jetbrains.letsPlot.ggsize
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.intern.toSpec
import org.jetbrains.letsPlot.label.labs
import org.jetbrains.letsPlot.letsPlot
import org.jetbrains.letsPlot.pos.positionDodge
import org.jetbrains.letsPlot.scale.scaleColorManual
import org.jetbrains.letsPlot.scale.scaleFillGradient
import org.jetbrains.letsPlot.scale.scaleFillManual
import org.jetbrains.letsPlot.scale.scaleShapeManual
import org.jetbrains.letsPlot.scale.scaleXContinuous
import org.jetbrains.letsPlot.scale.scaleXDiscrete
import org.jetbrains.letsPlot.scale.scaleYDiscrete
import org.jetbrains.letsPlot.scale.scaleYLog10
import org.jetbrains.letsPlot.themes.elementLine
import org.jetbrains.letsPlot.themes.elementRect
import org.jetbrains.letsPlot.themes.elementText
import org.jetbrains.letsPlot.themes.theme
import org.jetbrains.letsPlot.themes.themeMinimal
import java.io.ByteArrayOutputStream
import java.io.StringReader
import java.math.BigDecimal

/**
 * The colours of a figure.
 *
 * @property filters a colour for each view, in this order: everything, the front side, the front distance
 * @property sources the colours of the published figures and of the conditions
 */
internal enum class Shades(val ink: String, val faint: String, val paper: String, val filters: List<String>, val sources: List<String>) {
    LIGHT(
        "#1f2328", "#d0d7de", "#ffffff", listOf("#b3261e", "#b26a00", "#0b6bcb"),
        listOf("#6e7781", "#b3261e", "#0b6bcb", "#1a7f37", "#8250df"),
    ),

    DARK(
        "#e6edf3", "#3d444d", "#0d1117", listOf("#ff8078", "#f0b040", "#6cb6ff"),
        listOf("#9198a1", "#ff8078", "#6cb6ff", "#57d364", "#d2a8ff"),
    ),
}

internal fun svg(plot: Plot): String = PlotSvgExport.buildSvgImageFromRawSpecs(plot.toSpec().toMutableMap())

/** Draws [svg] as a PNG, and returns its bytes. One unit of the SVG becomes [scale] pixels. */
internal fun png(svg: String, scale: Float = 2f): ByteArray {
    val width = checkNotNull(Regex("""width="([0-9.]+)"""").find(svg)) { "the figure has no width" }.groupValues[1].toFloat()
    val out = ByteArrayOutputStream()
    PNGTranscoder().apply {
        addTranscodingHint(PNGTranscoder.KEY_WIDTH, width * scale)
        transcode(TranscoderInput(StringReader(svg)), TranscoderOutput(out))
    }
    return out.toByteArray()
}

internal fun Plot.dressed(shades: Shades, width: Int, height: Int): Plot = this + ggsize(width, height) + themeMinimal() + theme(
    text = elementText(color = shades.ink, family = "sans-serif"),
    axisText = elementText(color = shades.ink, size = 12),
    axisTitle = elementText(color = shades.ink, size = 13),
    legendTitle = elementText(color = shades.ink, size = 12),
    legendText = elementText(color = shades.ink, size = 12),
    stripText = elementText(color = shades.ink, size = 13),
    panelGrid = elementLine(color = shades.faint),
    plotBackground = elementRect(fill = shades.paper, color = shades.paper),
    legendBackground = elementRect(fill = shades.paper, color = shades.paper),
).legendPositionBottom()

private fun title(condition: Condition) = "(${condition.letter}) ${condition.title}"

internal fun words(view: View) = when (view) {
    View.NONE -> "no filter"
    View.FRONT_SIDE -> "front side"
    View.FRONT_DISTANCE -> "front distance"
}

private val FILTERS = View.entries.map(::words)

/** The ends of a run, with their shapes in figures. A hollow shape means that the machine was late. */
private val ENDS = listOf("stopped" to 16, "ran into the wall" to 4, "stopped, busy machine" to 1, "wall, busy machine" to 13)

private fun end(run: Finished) = ENDS[(if (run.result.outcome == Outcome.COLLIDED) 1 else 0) + if (run.isLate) 2 else 0].first

private fun endShapes(runs: List<Finished>) = ENDS.take(if (runs.any { it.isLate }) ENDS.size else 2).let { ends ->
    scaleShapeManual(values = ends.map { it.second }, limits = ends.map { it.first }, name = "")
}

private const val MIN_S = 0.002
private const val MAX_S = 20.0
private val TIMES_S = listOf(0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)

private val HUES_S = listOf(0.01, 0.1, 1.0, 10.0)

/** Returns the shortest label of a tick at [seconds]. */
private fun TimeScale.label(seconds: Double) = BigDecimal("$seconds").multiply(BigDecimal(perSecond)).stripTrailingZeros().toPlainString()

private fun conditions(runs: List<Finished>) = runs.distinctBy { it.trial.condition }.size

/** Plots the robots' final distances in all combinations, as the published figure does. Each condition has a row. */
internal fun distancesFigure(runs: List<Finished>, plan: Plan, shades: Shades): Plot {
    val data = mapOf(
        "x" to
            runs.map { plan.intervals.indexOf(it.trial.interval) + 0.26 * (it.trial.view.ordinal - 1) + 0.06 * (it.trial.replication - 2) },
        "distance" to runs.map { it.result.distance },
        "filter" to runs.map { words(it.trial.view) },
        "end" to runs.map(::end),
        "limit" to runs.map { it.trial.limit },
        "condition" to runs.map { title(it.trial.condition) },
    )
    val conditions = runs.map { title(it.trial.condition) }.distinct()
    val limits = conditions.flatMap { condition -> plan.limits.map { condition to it } }
    val lines = mapOf("condition" to limits.map { it.first }, "limit" to limits.map { it.second }, "at" to limits.map { it.second })
    return (
        letsPlot(data) + geomHLine(data = lines, linetype = "dashed", color = shades.ink) { yintercept = "at" } +
            geomPoint(size = 4.0) { x = "x"; y = "distance"; color = "filter"; shape = "end" } +
            facetGrid(x = "limit", y = "condition", xFormat = "limit {d} cm") +
            scaleXContinuous(
                breaks = plan.intervals.indices.toList(), labels = plan.intervals.map { "$it" },
                limits = -0.5 to plan.intervals.size - 0.5,
            ) +
            filterColours(shades) + endShapes(runs) +
            labs(x = "sensing interval in ms", y = "distance from the wall in cm")
        ).dressed(shades, 960, 120 + 210 * conditions.size)
}

private fun filterColours(shades: Shades) = scaleColorManual(values = shades.filters, limits = FILTERS, name = "")

/** Plots the times from crossing the limit to the stop or the wall, in units of [scale]. */
internal fun timesFigure(runs: List<Finished>, scale: TimeScale, shades: Shades): Plot {
    val data = mapOf(
        "filter" to runs.map { words(it.trial.view) },
        "seconds" to runs.map { (it.result.sinceLimitMs / 1000).coerceIn(MIN_S, MAX_S) },
        "end" to runs.map(::end),
        "condition" to runs.map { title(it.trial.condition) },
    )
    return (
        letsPlot(data) { x = "filter"; y = "seconds"; color = "filter" } + geomBoxplot(outlierSize = 0, width = 0.5, fill = shades.paper) +
            geomPoint(size = 3.0, alpha = 0.7) { shape = "end" } + facetGrid(x = "condition") +
            scaleXDiscrete(limits = FILTERS) +
            scaleYLog10(
                limits = MIN_S to (if (scale == TimeScale.SECONDS) MAX_S else 1.0), breaks = TIMES_S, labels = TIMES_S.map(scale::label),
            ) +
            filterColours(shades) + endShapes(runs) +
            labs(x = "", y = "time from crossing the limit in ${scale.unit}")
        ).dressed(shades, maxOf(960, 320 * conditions(runs)), 420)
}

internal fun sharesFigure(analyses: Map<Condition, Factorial>, shades: Shades): Plot {
    val names = listOf("published") + analyses.keys.map(::title)
    val sources = Source.entries.map(::words) + "error"
    val shares = listOf(Source.entries.map { Published.percent.getValue(it) } + Published.ERROR_PERCENT) +
        analyses.values.map { analysis -> Source.entries.map { 100 * analysis.share(it) } + 100 * analysis.errorShare }
    val data = mapOf(
        "source" to names.flatMap { sources },
        "share" to shares.flatten(),
        "whose" to names.flatMap { name -> sources.map { name } },
    )
    return (
        letsPlot(data) { x = "source"; y = "share"; fill = "whose" } + geomBar(stat = Stat.identity, position = positionDodge()) +
            scaleXDiscrete(limits = sources) + scaleFillManual(values = shades.sources, limits = names, name = "") +
            labs(x = "", y = "share of the variation in %")
        ).dressed(shades, 960, 380)
}

/** Plots the time from crossing the limit to the stop, with more sensors and faster lines, in units of [scale]. */
internal fun scalingFigure(runs: List<Finished>, scale: TimeScale, shades: Shades): Plot {
    val data = mapOf(
        "baud" to runs.map { "${it.trial.baud}" },
        "sensors" to runs.map { "${it.trial.sensors}" },
        "seconds" to runs.map { if (it.result.outcome == Outcome.STOPPED) maxOf(0.01, it.result.sinceLimitMs / 1000) else null },
        "label" to runs.map { fate(it, scale) },
        "view" to runs.map { words(it.trial.view) },
        "condition" to runs.map { title(it.trial.condition) },
    )
    return (
        letsPlot(data) { x = "baud"; y = "sensors" } + geomTile(width = 1, height = 1, color = shades.paper) { fill = "seconds" } +
            geomText(size = 6, color = "#1f2328") { label = "label" } + facetGrid(x = "condition", y = "view", yOrder = -1) +
            coordCartesian() +
            scaleXDiscrete(limits = runs.map { it.trial.baud }.distinct().sorted().map { "$it" }) +
            scaleYDiscrete(limits = runs.map { it.trial.sensors }.distinct().sorted().map { "$it" }) +
            scaleFillGradient(
                low = "#d3f0dc", high = "#f5b971", naValue = "#e58f88", trans = "log10", breaks = HUES_S,
                labels = HUES_S.map(scale::label), name = "time from the limit in ${scale.unit}",
            ) +
            labs(x = "baud", y = "sensors")
        ).dressed(shades, maxOf(1180, 390 * conditions(runs)), 520)
}
