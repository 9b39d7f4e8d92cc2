package argo.build

import java.nio.file.Path
import kotlin.io.path.readText

/**
 * One of the two builds, as far as they must agree.
 * @property libraries the modules that are published
 */
data class Build(
    val group: String,
    val version: String,
    val java: String,
    val kotlin: String,
    val kotlinJvmTarget: String,
    val newestJason: String,
    val dokka: String,
    val libraries: List<String>,
    val modules: Map<String, Set<Dependency>>,
)

/**
 * A dependency of a module.
 * @property scope `compile`, `provided`, `runtime`, `test` or `processor`
 */
data class Dependency(val scope: String, val coordinates: String, val version: String)

/** Reads what the Gradle build under [root] declares, in the idioms that it uses; fails on one that it does not know. */
fun gradleBuild(root: Path): Build {
    val catalog = Catalog.read(root.resolve("gradle/libs.versions.toml"))
    val script = root.resolve("build.gradle.kts").readText()
    val version = script.value("""version = "(.+)"""")
    val shared = dependencies(script.replace("rootProject.", ""), catalog, version)
    val modules = include(root.resolve("settings.gradle.kts").readText())
    return Build(
        group = script.value("""group = "(.+)""""),
        version = version,
        java = script.value("""options\.release = (\d+)"""),
        kotlin = catalog.versions.getValue("kotlin"),
        kotlinJvmTarget = script.value("""JvmTarget\.JVM_(\d+)"""),
        newestJason = catalog.versions.getValue("newest-jason"),
        dokka = catalog.versions.getValue("dokka"),
        libraries = quoted(script.value("""val libraries = listOf\(([^)]*)\)""")),
        modules = modules.associateWith { module ->
            merged(shared + dependencies(root.resolve("$module/build.gradle.kts").readText(), catalog, version))
        },
    )
}

private fun include(settings: String): List<String> =
    quoted(settings.value("""include\(([^)]*)\)"""))

private fun quoted(text: String): List<String> = Regex("\"([^\"]+)\"").findAll(text).map { it.groupValues[1] }.toList()

private fun String.value(pattern: String): String =
    checkNotNull(Regex(pattern).find(this)) { "no $pattern in\n$this" }.groupValues[1]

private val SCOPES = mapOf(
    "api" to "compile", "implementation" to "compile", "compileOnly" to "provided", "runtimeOnly" to "runtime",
    "testImplementation" to "test", "annotationProcessor" to "processor",
)

private fun dependencies(script: String, catalog: Catalog, version: String): Set<Dependency> =
    Regex("""^\s*"?(${SCOPES.keys.joinToString("|")})"?\((.+)\)""", RegexOption.MULTILINE).findAll(script).map { match ->
        val (configuration, notation) = match.destructured
        val scope = SCOPES.getValue(configuration)
        val project = Regex("""project\(":(.+)"\)""").matchEntire(notation)
        if (project != null) Dependency(scope, "argo:${project.groupValues[1]}", version)
        else catalog.dependency(scope, notation)
    }.toSet()

/** `compileOnly` and `testImplementation` of one library are what Maven calls `provided`. */
private fun merged(dependencies: Set<Dependency>): Set<Dependency> = dependencies.filterNot {
    it.scope == "test" && it.copy(scope = "provided") in dependencies
}.toSet()

/** The version catalog. */
private class Catalog(val versions: Map<String, String>, private val libraries: Map<String, Pair<String, String>>) {
    fun dependency(scope: String, accessor: String): Dependency {
        val alias = accessor.removePrefix("libs.").replace('.', '-')
        val (module, version) = checkNotNull(libraries[alias]) { "$accessor is not in the catalog" }
        return Dependency(scope, module.removeSuffix("-jvm"), version)
    }

    companion object {
        private val VERSION = Regex("""([\w-]+) = "(.+)"""")
        private val LIBRARY = Regex("""([\w-]+) = \{ module = "(.+)", version\.ref = "(.+)" }""")

        fun read(file: Path): Catalog {
            val sections = sections(file.readText())
            val versions = sections.getValue("versions").associate { checkNotNull(VERSION.matchEntire(it)) { it }.destructured.let { (k, v) -> k to v } }
            val libraries = sections.getValue("libraries").associate { line ->
                val (alias, module, version) = checkNotNull(LIBRARY.matchEntire(line)) { line }.destructured
                alias to (module to versions.getValue(version))
            }
            return Catalog(versions, libraries)
        }

        private fun sections(text: String): Map<String, List<String>> =
            text.split(Regex("(?m)^\\[")).drop(1).associate { section ->
                val lines = section.lines().map { it.substringBefore(" #").trim() }.filter { it.isNotEmpty() && !it.startsWith("#") }
                lines.first().removeSuffix("]") to lines.drop(1)
            }
    }
}
