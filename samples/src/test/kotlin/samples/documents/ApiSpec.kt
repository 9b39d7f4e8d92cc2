package samples.documents

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.jetbrains.kotlin.abi.tools.AbiFilters
import org.jetbrains.kotlin.abi.tools.AbiTools
import java.io.File
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * `<library>/api/<library>.api` contains the public API of each library, so that changes are noticed. `-Dargo.write.api=true` writes the
 * files.
 */
class ApiSpec : FunSpec({
    val root = Path.of("..").toRealPath()
    val onClassPath = System.getProperty("java.class.path").split(File.pathSeparator).map { File(it).canonicalFile }

    /** The classes of a library, from a Maven or a Gradle build. */
    fun classes(library: String): List<File> = onClassPath.filter { it.startsWith(root.resolve(library).toFile()) }
        .flatMap { place -> place.walk().filter { it.extension in setOf("class", "jar") } }

    libraries(root).forEach { library ->
        test("the public API of $library is the one in its file") {
            val files = classes(library)
            withClue("$library is not on the class path") { files.shouldNotBeEmpty() }
            val api = buildString { AbiTools.getInstance().printJvmDump(this, files, AbiFilters.EMPTY) }
            val file = root.resolve("$library/api/$library.api")
            if (System.getProperty("argo.write.api") == "true") file.apply { parent.createDirectories() }.writeText(api)
            val now = declarations(api)
            val kept = declarations(if (file.exists()) file.readText() else "")
            withClue("if this change is meant, and stands in CHANGELOG.md: $UPDATE") {
                ((now - kept).map { "new: $it" } + (kept - now).map { "gone: $it" }).joinToString("\n") shouldBe ""
            }
            api shouldContain "public "
        }
    }
})

internal fun libraries(root: Path): List<String> = Regex("<module>(.+?)</module>").findAll(root.resolve("pom.xml").readText())
    .map { it.groupValues[1] }.filterNot { "<maven.install.skip>true" in root.resolve("$it/pom.xml").readText() }.toList()

/** The lines of an API. A member's line begins with its type. */
private fun declarations(api: String): Set<String> = api.split("\n\n").flatMap { type ->
    val lines = type.trim().lines()
    listOf(lines.first()) + lines.drop(1).map { "${lines.first().substringBefore(" {")}: ${it.trim()}" }
}.toSet()

private const val UPDATE = "mvn -o -pl samples -am test -Dtest=ApiSpec -Dsurefire.failIfNoSpecifiedTests=false -Dargo.write.api=true"
