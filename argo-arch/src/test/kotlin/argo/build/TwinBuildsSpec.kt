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

    for (module in gradle.modules.keys) {
        test("both give $module the same dependencies") {
            maven.modules[module] shouldBe gradle.modules[module]
        }
    }
})
