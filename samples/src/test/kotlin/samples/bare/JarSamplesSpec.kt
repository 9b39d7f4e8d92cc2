package samples.bare

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import samples.Program
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.util.jar.JarEntry
import java.util.jar.JarOutputStream
import kotlin.io.path.absolute
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.name
import kotlin.io.path.outputStream

/** The samples as a user of a release runs them: `java -jar argo.jar demo`, without a script, from any folder. */
class JarSamplesSpec : FunSpec({
    val folder = tempdir().toPath()
    val jar = release(tempdir().toPath().resolve("the release"))

    test("the demo tells its options under the name that was typed") {
        val help = Program.run(folder, "-jar", "$jar", "demo", "--help")
        withClue(help.printed) {
            help.status shouldBe 0
            help.printed shouldStartWith "Usage: java -jar argo.jar demo"
        }
    }

    test("a sample runs, and its end is the jar's") {
        val blinked = Program.run(folder, "-jar", "$jar", "sample", "blink", "--seconds", "3")
        withClue(blinked.printed) {
            blinked.status shouldBe 0
            blinked.printed shouldContain "LED on"
        }
        val refused = Program.run(folder, "-jar", "$jar", "sample", "race")
        withClue(refused.printed) {
            refused.status shouldBe 2
            refused.printed shouldContain "there is no sample 'race'; there are: collision, blink"
        }
    }

    test("who ends the jar ends the sample that it runs") {
        Program.start(folder, "-jar", "$jar", "sample", "blink", "--seconds", "100").use { sample ->
            sample.awaitLine("LED on")
            val children = sample.children().also { it.size shouldBe 1 }
            withClue(sample.interrupt().printed) { children.filter { it.isAlive } shouldBe emptyList() }
        }
    }

    test("a jar alone says what it lacks") {
        val alone = Path.of(System.getProperty("argo.jar")).copyTo(folder.resolve("argo.jar"))
        val refused = Program.run(folder, "-jar", "$alone", "demo")
        refused.status shouldBe 1
        refused.printed shouldContain "A release has them in the folder samples beside argo.jar"
    }
})

private fun release(folder: Path): Path {
    val samples = folder.resolve("samples").createDirectories()
    val entries = (System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")).split(File.pathSeparator)
    entries.map { Path.of(it).absolute() }.forEachIndexed { at, entry ->
        if (entry.isRegularFile()) Files.createSymbolicLink(samples.resolve("$at-${entry.name}"), entry)
        else if (entry.isDirectory()) pack(entry, samples.resolve("$at.jar"))
    }
    return Path.of(System.getProperty("argo.jar")).copyTo(folder.resolve("argo.jar"))
}

private fun pack(classes: Path, target: Path) = JarOutputStream(target.outputStream()).use { jar ->
    Files.walk(classes).use { files ->
        files.filter { it.isRegularFile() }.forEach { file ->
            jar.putNextEntry(JarEntry(classes.relativize(file).joinToString("/")))
            Files.copy(file, jar)
        }
    }
}
