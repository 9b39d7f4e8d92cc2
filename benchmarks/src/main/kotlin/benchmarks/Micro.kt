package benchmarks

import org.openjdk.jmh.profile.GCProfiler
import org.openjdk.jmh.results.RunResult
import org.openjdk.jmh.results.format.ResultFormatType
import org.openjdk.jmh.runner.Runner
import org.openjdk.jmh.runner.options.OptionsBuilder
import org.openjdk.jmh.runner.options.VerboseMode
import java.io.File

/** Runs the JMH benchmarks of filters, and prints a table. Writes all results to [json]. */
internal fun filters(json: File) {
    val options = OptionsBuilder().include("FilterBenchmark|CycleBenchmark").addProfiler(GCProfiler::class.java)
        .verbosity(VerboseMode.SILENT).resultFormat(ResultFormatType.JSON).result(json.path).build()
    System.err.println("measuring what filters cost; takes about two minutes")
    val results = Runner(options).run().associateBy(::name)
    println("filters, ${machine()}:")
    results.forEach { (name, result) ->
        val time = result.primaryResult
        println(figures("%-32s %12.1f %s %10.1f B", name, time.score, time.scoreUnit, allocated(result)))
    }
    printRatios(results.mapValues { it.value.primaryResult.score })
    noise()
    println("all results: $json")
}

private fun name(result: RunResult): String {
    val parameters = result.params.paramsKeys.joinToString(",") { result.params.getParam(it) }
    return result.params.benchmark.substringAfterLast('.') + if (parameters.isEmpty()) "" else "($parameters)"
}

private const val MESSAGE = FilterBenchmark.MESSAGE

private fun allocated(result: RunResult): Double =
    result.secondaryResults.entries.firstOrNull { it.key.endsWith("gc.alloc.rate.norm") }?.value?.score ?: Double.NaN

private fun printRatios(score: Map<String, Double>) {
    fun ratio(words: String, of: String, to: String) =
        println(figures("%-72s %8.2f", words, score.getValue(of) / score.getValue(to)))
    ratio("Jason's parser, times a percept dropped by an argument rule", "readWithJasonsParser", "dropByArgument")
    ratio("Jason's parser, times a kept percept read", "readWithJasonsParser", "readKept")
    ratio("filtering after parsing, times filtering before it", "dropAfterJasonsParser", "dropByArgument")
    ratio("1000 rules, times 10 rules", "dropByOneOf1000Rules", "dropByOneOf10Rules")
    ratio("a message whose percepts are smoothed, times one that is only filtered", "perceiveSmoothed", "perceive")
    fun more(words: String, of: String, than: String = "perceive") =
        println(figures("%-72s %8.1f ns", "$words, more for each percept", (score.getValue(of) - score.getValue(than)) / MESSAGE))
    more("smoothed by a median of 5", "perceiveSmoothed")
    more("outliers left out", "perceiveWithoutOutliers")
    more("outliers left out, and smoothed by a median of 3", "perceiveSmoothedTwice")
    more("a second limit, while no sensor meets it", "perceiveUntil", "perceiveLimit")
    more("a second limit that most sensors meet", "perceiveUntilMet", "perceiveLimit")
    for (n in listOf(12, 120, 1200)) ratio(
        "a cycle with $n percepts and no filter, times with one that keeps one", "cycle(none,$n)", "cycle(one,$n)",
    )
}
