package argo.filters.format

import argo.filters.FilterNotFoundException
import argo.filters.FilterProvider
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.dropFilter
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.StringSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.net.URLClassLoader
import java.nio.file.Path
import java.util.ServiceConfigurationError
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

class NightFilters : FilterProvider {
    override val filters = listOf(PerceptionFilter("dark", Rule("light")), PerceptionFilter("shared", Rule("a")))
}

class DayFilters : FilterProvider {
    override val filters = listOf(PerceptionFilter("bright", Rule("dark")), PerceptionFilter("shared", Rule("b")))
}

private object TopLevel {
    val filter = dropFilter("lazy") { drop("Dist") }
}

class TwiceFilters : FilterProvider {
    override val filters = listOf(PerceptionFilter("twice", Rule("a")), PerceptionFilter("twice", Rule("b")))
}

class EarlyMistake : FilterProvider {
    override val filters = listOf(dropFilter("early") { drop("Dist") })
}

class LateMistake : FilterProvider {
    override val filters get() = listOf(dropFilter("late") { drop("Dist") })
}

class MistakeElsewhere : FilterProvider {
    override val filters get() = listOf(TopLevel.filter)
}

class FilterProviderSpec : StringSpec({
    val project = tempdir().toPath()
    project.resolve("dark.xml").writeText(XmlFilters.write(PerceptionFilter("dark", Rule("from_file"))))
    project.resolve("json_too.json").writeText(JsonFilters.write(PerceptionFilter("json_too", Rule("from_json"))))
    project.resolve("package.json").writeText("{\"name\": \"x\"}")
    project.resolve("both.json").writeText(JsonFilters.write(PerceptionFilter("both", Rule("from_json"))))
    project.resolve("both.xml").writeText(XmlFilters.write(PerceptionFilter("both", Rule("from_xml"))))

    fun finder(vararg providers: Class<*>): FilterFinder {
        val services: Path = tempdir().toPath()
        val file = services.resolve("META-INF/services/${FilterProvider::class.java.name}")
        file.parent.createDirectories()
        file.writeText(providers.joinToString("\n") { it.name })
        return FilterFinder(project, URLClassLoader(arrayOf(services.toUri().toURL()), FilterProviderSpec::class.java.classLoader))
    }

    "a filter of a provider is found by name" {
        finder(NightFilters::class.java, DayFilters::class.java).find("bright").rules shouldBe listOf(Rule("dark"))
    }

    "it comes before a file of the same name" {
        finder(NightFilters::class.java).find("dark").rules shouldBe listOf(Rule("light"))
        finder().find("dark").rules shouldBe listOf(Rule("from_file"))
    }

    "a file with its extension is meant when it is named so" {
        finder(NightFilters::class.java).find("dark.xml").rules shouldBe listOf(Rule("from_file"))
    }

    "two providers may not offer different filters of one name" {
        val finder = finder(NightFilters::class.java, DayFilters::class.java)
        shouldThrow<FilterNotFoundException> { finder.find("shared") }.message shouldContain
            "argo.filters.format.NightFilters and argo.filters.format.DayFilters offer different filters"
        shouldThrow<FilterNotFoundException> { finder(TwiceFilters::class.java).find("twice") }.message shouldBe
            "argo.filters.format.TwiceFilters offers different filters of the name 'twice'; give one of them another name."
    }

    "a filter that is refused in Kotlin is told with its provider and the reason, also the second time" {
        for (provider in listOf(EarlyMistake::class.java, LateMistake::class.java, MistakeElsewhere::class.java)) repeat(2) {
            val message = shouldThrow<ServiceConfigurationError> { finder(provider).find("dark") }.message
            message shouldContain provider.name
            message shouldContain "'Dist' is no functor"
        }
    }

    "a filter in JSON is found as one in XML, which comes first" {
        finder().find("json_too").rules shouldBe listOf(Rule("from_json"))
        finder().find("json_too.json").name shouldBe "json_too"
        finder().find("both").rules shouldBe listOf(Rule("from_xml"))
        finder().find("both.json").rules shouldBe listOf(Rule("from_json"))
    }

    "filters of all kinds are listed when there is none of the name" {
        shouldThrow<FilterNotFoundException> { finder(NightFilters::class.java).find("nowhere") }.message shouldContain
            "There are these filters: both, dark, json_too, shared."
    }
})
