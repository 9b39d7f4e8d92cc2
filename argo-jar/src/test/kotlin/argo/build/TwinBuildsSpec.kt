package argo.build

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import java.nio.file.Path
import kotlin.io.path.readText

/** Gradle is the build for users and IDEs, Maven the one that ./argo runs: neither may drift from the other. */
class TwinBuildsSpec : FunSpec({
    val root = Path.of("..")
    val gradle = gradleBuild(root)
    val maven = mavenBuild(root)
    val samples = root.resolve("samples/pom.xml").readText() to root.resolve("samples/build.gradle.kts").readText()

    test("both build the same modules in the same order") {
        maven.modules.keys.toList() shouldBe gradle.modules.keys.toList()
        maven.modules.keys shouldContainAll listOf("javino-java", "argo-filters-dsl", "argo-tools", "argo-arch", "argo-jar", "samples")
    }

    test("both have the same group and the same versions of all") {
        maven.group shouldBe gradle.group
        maven.versions shouldBe gradle.versions
    }

    test("both compile for the same Java, and the same modules with the plugin for serialization") {
        listOf(maven.java, maven.kotlinJvmTarget, maven.serialized) shouldBe listOf(gradle.java, gradle.kotlinJvmTarget, gradle.serialized)
    }

    test("both publish the same libraries") {
        maven.libraries shouldBe gradle.libraries
    }

    for (module in gradle.modules.keys) {
        test("both give $module the same dependencies") {
            maven.modules[module] shouldBe gradle.modules[module]
        }
    }

    test("both put the same Jason projects and filters on the samples' class path") {
        val (pom, script) = samples
        val folders = checkNotNull(Regex("projects = listOf\\(([^)]*)\\)").find(script)) { "no list of the Jason projects in the script" }
        values(pom, "<include>([^<]+)/\\*\\*</include>") shouldBe values(folders.groupValues[1], "\"([^\"]+)\"")
        values(pom, "<directory>([^<]+)</directory><targetPath>filters</targetPath>") shouldBe
            values(script, "from\\(\"([^\"]+)\"\\) \\{ into\\(\"filters\"\\)")
    }

    test("both name the same files to the samples' tests") {
        val (pom, script) = samples
        val properties = pom.substringAfter("<systemPropertyVariables>").substringBefore("</systemPropertyVariables>")
        values(properties, "<([\\w.]+)>") shouldBe values(script, "systemProperty\\(\"([\\w.]+)\"")
    }

    test("a new project's Gradle build fetches its plugins from where this one does") {
        val repositories = Regex("pluginManagement \\{ repositories \\{.+")
        val own = repositories.find(root.resolve("settings.gradle.kts").readText())?.value
        val made = repositories.find(root.resolve("argo-tools/src/main/resources/argo/tools/project/settings.gradle").readText())?.value
        made shouldBe checkNotNull(own) { "no pluginManagement in the settings" }
    }
})

/** Returns all matches of the group of [pattern] in [text]; fails if there are none, since then the spec would compare nothing. */
private fun values(text: String, pattern: String): Set<String> =
    Regex(pattern).findAll(text).map { it.groupValues[1] }.toSet().also { check(it.isNotEmpty()) { "no $pattern in\n$text" } }
