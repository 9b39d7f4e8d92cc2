package argo.build

import java.nio.file.Path
import kotlin.io.path.readText

/**
 * One of the two builds, as far as they must agree.
 * @property versions ARGO's own and those of the libraries and tools, by the names that the builds give them
 * @property libraries the modules that are published
 * @property serialized the modules that are compiled with Kotlin's plugin for serialization
 */
data class Build(
    val group: String,
    val versions: Map<String, String>,
    val java: String,
    val kotlinJvmTarget: String,
    val libraries: List<String>,
    val serialized: List<String>,
    val modules: Map<String, Set<Dependency>>,
)

/**
 * A dependency of a module.
 * @property scope `compile`, `provided`, `runtime`, `test` or `processor`
 */
data class Dependency(val scope: String, val coordinates: String, val version: String)

/** Reads the declarations of the Gradle build under [root], in the idioms that it uses; fails on an unknown one. */
fun gradleBuild(root: Path): Build {
    val script = root.resolve("build.gradle.kts").readText()
    val catalog = Catalog(root.resolve("gradle/libs.versions.toml").readText(), script.value("""version = "(.+)""""))
    val modules = quoted(root.resolve("settings.gradle.kts").readText().value("""include\(([^)]*)\)"""))
    val scripts = modules.associateWith { root.resolve("$it/build.gradle.kts").readText() }
    return Build(
        group = script.value("""group = "(.+)""""),
        versions = catalog.versions,
        java = script.value("""options\.release = (\d+)"""),
        kotlinJvmTarget = script.value("""JvmTarget\.JVM_(\d+)"""),
        libraries = quoted(script.value("""val libraries =\s+listOf\(([^)]*)\)""")),
        serialized = modules.filter { "libs.plugins.kotlin.serialization" in scripts.getValue(it) },
        modules = scripts.mapValues { (_, own) ->
            merged(catalog.dependencies(script.replace("rootProject.", "")) + catalog.dependencies(own))
        },
    )
}

private fun quoted(text: String): List<String> = Regex("\"([^\"]+)\"").findAll(text).map { it.groupValues[1] }.toList()

private fun String.value(pattern: String): String =
    checkNotNull(Regex(pattern).find(this)) { "no $pattern in\n$this" }.groupValues[1]

private val SCOPES = mapOf(
    "api" to "compile", "implementation" to "compile", "compileOnly" to "provided", "runtimeOnly" to "runtime",
    "testImplementation" to "test", "annotationProcessor" to "processor",
)

/** Merges `compileOnly` and `testImplementation` of one library: Maven calls both `provided`. */
private fun merged(dependencies: Set<Dependency>): Set<Dependency> = dependencies.filterNot {
    it.scope == "test" && it.copy(scope = "provided") in dependencies
}.toSet()

/** The version catalog. */
private class Catalog(text: String, private val argo: String) {
    private val sections = text.split(Regex("(?m)^\\[")).drop(1).associate { section ->
        val lines = section.lines().map { it.substringBefore(" #").trim() }.filter { it.isNotEmpty() && !it.startsWith("#") }
        lines.first().removeSuffix("]") to lines.drop(1)
    }
    val versions = sections.getValue("versions").associate { line ->
        val (name, version) = checkNotNull(Regex("""([\w-]+) = "(.+)"""").matchEntire(line)) { line }.destructured
        name to version
    } + ("argo" to argo)
    private val libraries = sections.getValue("libraries").associate { line ->
        val match = checkNotNull(Regex("""([\w-]+) = \{ module = "(.+)", version\.ref = "(.+)" }""").matchEntire(line)) { line }
        val (alias, module, version) = match.destructured
        alias to (module.removeSuffix("-jvm") to versions.getValue(version))
    }

    /** Returns the dependencies of a script. */
    fun dependencies(script: String): Set<Dependency> =
        Regex("""^\s*"?(${SCOPES.keys.joinToString("|")})"?\((.+)\)""", RegexOption.MULTILINE).findAll(script).map { match ->
            val (configuration, notation) = match.destructured
            val project = Regex("""project\(":(.+)"\)""").matchEntire(notation)
            val (module, version) = if (project != null) "argo:${project.groupValues[1]}" to argo else library(notation)
            Dependency(SCOPES.getValue(configuration), module, version)
        }.toSet()

    private fun library(accessor: String): Pair<String, String> =
        checkNotNull(libraries[accessor.removePrefix("libs.").replace('.', '-')]) { "$accessor is not in the catalog" }
}
