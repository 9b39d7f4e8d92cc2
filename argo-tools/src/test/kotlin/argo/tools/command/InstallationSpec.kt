package argo.tools.command

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

class InstallationSpec : FunSpec({
    test("a release has the samples beside its jar") {
        val release = tempdir().toPath()
        release.resolve("samples").createDirectories().resolve("samples.jar").writeText("")
        val samples = release.resolve("samples").toString() + File.separator + "*"
        Installation(release.resolve("argo.jar")).classPathOf("samples") shouldBe samples
    }

    listOf("samples", "experiment").forEach { module ->
        test("in the sources $module is where Maven has built it") {
            val tree = tempdir().toPath()
            val target = tree.resolve("$module/target").createDirectories()
            target.resolve("run.classpath").writeText("a.jar${File.pathSeparator}b.jar\n")
            Installation(tree.resolve("argo-jar/target/argo.jar")).classPathOf(module) shouldBe
                listOf("${target.resolve("classes")}", "a.jar", "b.jar").joinToString(File.pathSeparator)
        }
    }

    test("where there are none it is said where they were looked for, and how to get them") {
        val alone = tempdir().toPath()
        alone.resolve("samples").createDirectories()
        val refused = shouldThrow<ToolException> { Installation(alone.resolve("argo.jar")).classPathOf("samples") }
        refused.message shouldContain "${alone.resolve("samples")}"
        refused.message shouldContain "mvn package"
    }
})
