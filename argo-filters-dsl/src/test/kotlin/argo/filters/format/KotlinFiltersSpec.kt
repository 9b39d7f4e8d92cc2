package argo.filters.format

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.Outliers
import argo.filters.PerceptionFilter
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.SmoothingRule
import argo.filters.TermTest
import argo.filters.dropFilter
import argo.filters.filters
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.RandomSource
import org.jetbrains.kotlin.cli.common.ExitCode
import org.jetbrains.kotlin.cli.jvm.K2JVMCompiler
import java.io.ByteArrayOutputStream
import java.io.File
import java.io.PrintStream
import java.net.URLClassLoader

class KotlinFiltersSpec : FunSpec({
    test("a filter in Kotlin compiles, and is equal to what it was written from").config(tags = thorough) {
        val written = List(120) { filters.sampleAt(it) } + infinite
        written.zip(compiled(tempdir(), written)).forEach { (filter, read) ->
            withClue(KotlinFilters.write(filter)) {
                read shouldBe filter
                read.name shouldBe filter.name
            }
        }
    }

    test("names that are none in Kotlin, or hold what its strings do not, come back").config(tags = thorough) {
        val names = listOf("front", "front-left", "night/dark", "when", "__", "c\$d", "7", "a b", "é.漢", "\uD83D\uDE00")
        val written = names.map { PerceptionFilter(it, Rule("dist")) }
        compiled(tempdir(), written).map { it.name } shouldBe names
    }

    test("a name by which no agent can ask for the filter is not written") {
        for (name in listOf(" ", "a\"b", "none")) shouldThrow<IllegalArgumentException> { KotlinFilters.write(PerceptionFilter(name)) }
    }

    test("the paper's filter is written as a person writes it") {
        KotlinFilters.write(
            dropFilter("frontDistance") {
                drop("temperature")
                drop("distance") { argument(0) ne "front" }
                drop("light") { argument(1) gt 200; everyMs(500) }
            },
        ) shouldBe """
            import argo.filters.*

            val frontDistance = dropFilter("frontDistance") {
                drop("temperature")
                drop("distance") { argument(0) ne "front" }
                drop("light") {
                    everyMs(500)
                    argument(1) gt 200
                }
            }

        """.trimIndent()
    }

    test("whoever adds something to a rule teaches all writers to write it") {
        fun partsOf(type: Class<*>) = type.declaredFields.map { it.name }.filter { it != "Companion" && it.any(Char::isLowerCase) }
        partsOf(Rule::class.java) shouldContainExactlyInAnyOrder listOf("predicate", "conditions", "arity", "rate")
        partsOf(Rate::class.java) shouldContainExactlyInAnyOrder listOf("everyMs", "deadbands")
        partsOf(PerceptionFilter::class.java) shouldContainExactlyInAnyOrder
            listOf("name", "mode", "onSwitch", "rules", "critical", "smoothing")
        partsOf(CriticalRule::class.java) shouldContainExactlyInAnyOrder listOf("rule", "reflex", "smoothed")
        partsOf(Condition.Argument::class.java) shouldContainExactlyInAnyOrder listOf("index", "test", "until")
        partsOf(SmoothingRule::class.java) shouldContainExactlyInAnyOrder
            listOf("rule", "argument", "maxRate", "outliers", "median", "annotates")
        partsOf(Outliers::class.java) shouldContainExactlyInAnyOrder listOf("deviations", "among")
    }
})

private val infinite = PerceptionFilter(
    "infinite",
    Rule("dist", Condition.Argument(0, TermTest.Compare(Operator.GT, GroundTerm.Number(Double.NEGATIVE_INFINITY)))),
)

private fun <T> Arb<T>.sampleAt(seed: Int): T = sample(RandomSource.seeded(seed.toLong())).value

/** Writes [filters] as Kotlin, compiles them and returns the results. Each filter has its own file and package. */
private fun compiled(directory: File, filters: List<PerceptionFilter>): List<PerceptionFilter> {
    val sources = filters.mapIndexed { number, filter ->
        directory.resolve("Filter$number.kt").apply { writeText("package filter$number\n\n" + KotlinFilters.write(filter)) }
    }
    val messages = ByteArrayOutputStream()
    val classPath = System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")
    val out = directory.resolve("out")
    val exit = K2JVMCompiler().exec(
        PrintStream(messages), "-no-stdlib", "-no-reflect", "-Werror", "-classpath", classPath, "-jvm-target", "17", "-d", out.path,
        *sources.map { it.path }.toTypedArray(),
    )
    withClue(messages) { exit shouldBe ExitCode.OK }
    return URLClassLoader(arrayOf(out.toURI().toURL()), PerceptionFilter::class.java.classLoader).use { loader ->
        filters.indices.map { number ->
            val getter =
                loader.loadClass("filter$number.Filter${number}Kt").methods.single { it.returnType == PerceptionFilter::class.java }
            getter.invoke(null) as PerceptionFilter
        }
    }
}

private val thorough = setOf(NamedTag("Thorough"))
