package argo.tools.samples

import argo.tools.command.ToolException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

class SamplesPlaceSpec : FunSpec({
    test("a release has the samples beside its jar") {
        val release = tempdir().toPath()
        release.resolve("samples").createDirectories().resolve("samples.jar").writeText("")
        samplesClassPath(release.resolve("argo.jar"), "samples") shouldBe release.resolve("samples").toString() + File.separator + "*"
    }

    listOf("samples", "experiment").forEach { module ->
        test("in the sources $module is where Maven has built it") {
            val tree = tempdir().toPath()
            val target = tree.resolve("$module/target").createDirectories()
            target.resolve("run.classpath").writeText("a.jar${File.pathSeparator}b.jar\n")
            samplesClassPath(tree.resolve("argo-jar/target/argo.jar"), module) shouldBe
                listOf("${target.resolve("classes")}", "a.jar", "b.jar").joinToString(File.pathSeparator)
        }
    }

    test("where there are none it is said where they were looked for, and how to get them") {
        val alone = tempdir().toPath()
        alone.resolve("samples").createDirectories()
        val refused = shouldThrow<ToolException> { samplesClassPath(alone.resolve("argo.jar"), "samples") }
        refused.message shouldContain "${alone.resolve("samples")}"
        refused.message shouldContain "mvn package"
    }
})
