package argo.build

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import java.nio.file.Path
import kotlin.io.path.readText

/** Gradle is the build for users, Maven its twin for places that reach only Maven Central: neither may drift. */
class TwinBuildsSpec : FunSpec({
    val root = Path.of("..")
    val gradle = gradleBuild(root)
    val maven = mavenBuild(root)

    test("both build the same modules in the same order") {
        maven.modules.keys.toList() shouldBe gradle.modules.keys.toList()
        maven.modules.keys shouldContainAll listOf("javino-java", "argo-filters-dsl", "argo-tools", "argo-arch", "samples")
    }

    test("both have the same group and version") {
        maven.group to maven.version shouldBe (gradle.group to gradle.version)
    }

    test("both compile for the same Java with the same Kotlin") {
        listOf(maven.java, maven.kotlin, maven.kotlinJvmTarget) shouldBe listOf(gradle.java, gradle.kotlin, gradle.kotlinJvmTarget)
    }

    test("both try the jar with the same newest Jason") {
        maven.newestJason shouldBe gradle.newestJason
    }

    test("both publish the same libraries, documented by the same Dokka") {
        maven.libraries to maven.dokka shouldBe (gradle.libraries to gradle.dokka)
    }

    test("both jars run the same program, and may load the serial driver") {
        val pom = root.resolve("argo-arch/pom.xml").readText()
        val script = root.resolve("argo-arch/build.gradle.kts").readText()
        listOf("Main-Class", "Enable-Native-Access").forEach { entry ->
            val maven = checkNotNull(Regex("<$entry>(.+)</$entry>").find(pom)) { "no $entry in the pom" }
            val gradle = checkNotNull(Regex("\"$entry\" to \"(.+)\"").find(script)) { "no $entry in the script" }
            maven.groupValues[1] shouldBe gradle.groupValues[1]
        }
    }

    test("both leave the same entries out of the jar") {
        val pom = root.resolve("argo-arch/pom.xml").readText()
        val script = root.resolve("argo-arch/build.gradle.kts").readText()
        values(pom, "<exclude>([^<]+)</exclude>") shouldBe values(checkNotNull(Regex("exclude\\((.+)\\)").find(script)).value, "\"([^\"]+)\"")
    }

    test("both put the same Jason projects and filters on the samples' class path") {
        val pom = root.resolve("samples/pom.xml").readText()
        val script = root.resolve("samples/build.gradle.kts").readText()
        val folders = checkNotNull(Regex("listOf\\((.+)\\)\\.forEach").find(script)) { "no list of the Jason projects in the script" }.groupValues[1]
        values(pom, "<include>([^<]+)/\\*\\*</include>") shouldBe values(folders, "\"([^\"]+)\"")
        values(pom, "<directory>([^<]+)</directory><targetPath>filters</targetPath>") shouldBe values(script, "from\\(\"([^\"]+)\"\\) \\{ into\\(\"filters\"\\)")
    }

    test("both tell the samples' tests of the same files") {
        val pom = root.resolve("samples/pom.xml").readText().substringAfter("<systemPropertyVariables>").substringBefore("</systemPropertyVariables>")
        val script = root.resolve("samples/build.gradle.kts").readText()
        values(pom, "<([\\w.]+)>") shouldBe values(script, "systemProperty\\(\"([\\w.]+)\"")
    }

    test("a new project's Gradle build fetches its plugins from where this one does") {
        val repositories = Regex("pluginManagement \\{ repositories \\{.+")
        val own = repositories.find(root.resolve("settings.gradle.kts").readText())?.value
        val made = repositories.find(root.resolve("argo-tools/src/main/resources/argo/tools/project/settings.gradle").readText())?.value
        made shouldBe checkNotNull(own) { "no pluginManagement in the settings" }
    }

    for (module in gradle.modules.keys) {
        test("both give $module the same dependencies") {
            maven.modules[module] shouldBe gradle.modules[module]
        }
    }
})

/** What the group of [pattern] matches in [text], all of it; fails when nothing does, since then nothing would be compared. */
private fun values(text: String, pattern: String): Set<String> =
    Regex(pattern).findAll(text).map { it.groupValues[1] }.toSet().also { check(it.isNotEmpty()) { "no $pattern in\n$text" } }
