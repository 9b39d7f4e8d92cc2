package experiment.delegation

import experiment.report.CONFIDENCE
import experiment.report.Factorial
import experiment.report.Interval
import experiment.report.median
import org.apache.commons.math3.distribution.TDistribution
import org.apache.commons.math3.stat.StatUtils
import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.sqrt

/**
 * A ratio of times with its 95 % interval, which is null for one block.
 *
 * @property value the geometric mean
 */
internal data class Ratio(val value: Double, val interval: Interval?)

/**
 * Returns the ratio for its [logarithms], one per block, by Student's t distribution. The blocks are independent. A slow block changes both
 * times of its ratio alike.
 */
internal fun ratio(logarithms: List<Double>): Ratio {
    val values = logarithms.toDoubleArray()
    val mean = StatUtils.mean(values)
    if (values.size < 2) return Ratio(exp(mean), null)
    val margin = TDistribution(values.size - 1.0).inverseCumulativeProbability((1 + CONFIDENCE) / 2) *
        sqrt(StatUtils.variance(values) / values.size)
    return Ratio(exp(mean), Interval(exp(mean - margin), exp(mean + margin)))
}

/** Compares the designs by the [measured] runs. The runs are whole blocks of [plan]. Each run counts with the median of its reactions. */
internal class Comparison(measured: List<Measured>, val plan: DelegationPlan) {
    private val results = measured.associate { it.run to it.result }

    fun results(load: Load, design: Design): List<DelegationResult> = (1..plan.blocks).map { result(load, design, it) }

    private fun result(load: Load, design: Design, block: Int) = results.getValue(DelegationRun(block, load, design))

    /** The reaction of [design] under [load] in ms, as the median of all blocks. */
    fun reaction(load: Load, design: Design): Double = median(results(load, design).map { median(it.times) })

    private fun logarithm(load: Load, design: Design, block: Int) = ln(median(result(load, design, block).times))

    /** Returns the reaction of [design] divided by that of one agent in the same block, over all [loads]. */
    fun ratio(design: Design, loads: List<Load>): Ratio = ratio(
        (1..plan.blocks).map { block ->
            loads.map { logarithm(it, design, block) - logarithm(it, Design.ONE, block) }.average()
        },
    )

    /** Analyses the logarithms of the reactions for [processors] and [interval]. The factors are design, sensors and plans. */
    fun allocation(processors: Int, interval: Int) = Factorial(
        Design.entries.map { design ->
            plan.sensors.map { sensors ->
                plan.plans.map { plans -> (1..plan.blocks).map { logarithm(Load(processors, interval, sensors, plans), design, it) } }
            }
        },
    )
}
