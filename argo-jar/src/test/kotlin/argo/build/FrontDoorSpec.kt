package argo.build

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith
import java.nio.file.attribute.FileTime
import java.security.MessageDigest
import java.time.Instant
import java.util.concurrent.TimeUnit
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.setLastModifiedTime
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.seconds

/** Tests the lines that `./argo` itself prints. */
class FrontDoorSpec : FunSpec({
    fun bash(vararg command: String): Pair<Int, String> {
        val process = ProcessBuilder("bash", *command).redirectErrorStream(true).start()
        val said = process.inputStream.readBytes().decodeToString()
        return process.waitFor() to said
    }

    test("a build shows its own modules, and none of the build before") {
        val logs = tempdir().toPath()
        val log = logs.resolve("build.log")
        fun building(module: String) = "echo '[INFO] Building $module 0.1.0 [1/4]'"
        // the shell opens the log in the background, so only some rounds could show an earlier line
        val rounds = """
            . ../build-tools/common.bash; logs='$logs'
            mvn() { ${building("later")}; }
            tail() { printf '%s\\n' "$(<'$log')"; }
            for round in {1..60}; do ${building("earlier")} >'$log'; maven '$log'; done
        """
        bash("-c", rounds).second shouldNotContain "earlier"
    }

    test("a build ends with the command that waits for it") {
        val logs = tempdir().toPath()
        val begun = logs.resolve("begun")
        val command = ". ../build-tools/common.bash; logs='$logs'; mvn() { touch '$begun'; exec sleep 100; }; maven '$logs/build.log'"
        val process = ProcessBuilder("bash", "-c", command).redirectErrorStream(true).start()
        eventually(60.seconds) { begun.exists() shouldBe true }
        process.destroy()
        process.waitFor(60, TimeUnit.SECONDS) shouldBe true
        process.exitValue() shouldBe SIGTERM_STATUS
    }

    test("what one command has built, with other modules, the next one does not build again until it changes") {
        val tree = tempdir().toPath()
        tree.resolve("pom.xml").writeText("<module>one</module>\n<module>two</module>\n")
        listOf("one", "two", "samples", "experiment").forEach { name ->
            tree.resolve(name).resolve("src").createDirectories()
            tree.resolve(name).resolve("target").createDirectories().resolve("$name.jar").writeText("")
            tree.resolve(name).resolve("pom.xml").writeText("")
        }
        val maven = "mkdir -p \"\$logs\"; maven() { echo \"maven \$5\"; }"
        val set = ". ../build-tools/common.bash; here='$tree'; logs='$tree/.argo'; $maven"
        fun built(modules: String) = bash("-c", "$set; build $modules 2>/dev/null").second.trim()
        built("one two") shouldBe "maven one,two"
        built("two") shouldBe ""
        built("one") shouldBe ""
        tree.resolve("two/target/two.jar").deleteExisting()
        built("one two") shouldBe "maven two"
        tree.resolve("two/target/two.jar").writeText("")
        tree.resolve("one/src/One.kt").apply { writeText("") }.setLastModifiedTime(FileTime.from(Instant.now().plusSeconds(60)))
        built("one two") shouldBe "maven one,two"
    }

    mapOf("" to "formatting", "--check" to "checking the format").forEach { (option, work) ->
        test("./argo format $option says first what it does and how long that takes") {
            val folder = tempdir().toPath()
            val java = "${System.getProperty("java.home")}/bin/java"
            // runs Maven, but no formatter; one that fails, so that no source counts as formatted
            val formatters = "#!/bin/sh\ncase \"\$*\" in *ktlint*|*palantir*) exit 1 ;; *) exec '$java' \"\$@\" ;; esac\n"
            folder.resolve("java").apply { writeText(formatters) }.toFile().setExecutable(true)
            val command = "PATH=$folder:\$PATH exec bash ../argo format $option"
            val process = ProcessBuilder("bash", "-c", command).redirectErrorStream(true).start()
            process.inputStream.bufferedReader().readLine() shouldStartWith "$work; takes about "
            process.destroy()
        }
    }

    test("a release's library lies where Maven looks for it, with the checksum of the file that was packed") {
        val folder = tempdir().toPath()
        folder.resolve("packed.jar").writeText("bytes")
        folder.resolve("pom.xml").writeText("    <argo.group>org.example.robots</argo.group>\n")
        val pack = "in_repository argo-arch 0.1.0 '$folder/packed.jar' -sources.jar"
        val (status, said) = bash("-c", ". ../build-tools/dist; here='$folder'; $pack")
        withClue(said) { status shouldBe 0 }
        val place = folder.resolve("dist/maven/org/example/robots/argo-arch/0.1.0")
        place.resolve("argo-arch-0.1.0-sources.jar").readText() shouldBe "bytes"
        val sum = MessageDigest.getInstance("SHA-1").digest("bytes".toByteArray()).joinToString("") { "%02x".format(it) }
        place.resolve("argo-arch-0.1.0-sources.jar.sha1").readText().trim() shouldBe sum
    }

    test("checksums are made by the program of macOS where that of GNU is not there") {
        val folder = tempdir().toPath()
        bash("-c", "printf '#!/bin/bash\necho shasum \"\$@\"' >'$folder/shasum'; chmod +x '$folder/shasum'; . ../build-tools/dist; " +
            "PATH=$folder; checksums sha256sum 'a file'").second.trim() shouldBe "shasum -a 256 a file"
    }

    listOf("bench", "bench a b", "bench latency soak", "bench fly").forEach { line ->
        test("./argo $line is refused before anything is built, with exit status 2") {
            val (status, said) = bash("../argo", *line.split(' ').toTypedArray())
            said shouldStartWith
                "./argo: bench takes one of latency, filters, realtime, stops, boards, bounds, faults, soak, tls, ros, explore, record," +
                " reload and fleet, not: "
            said shouldContain line.removePrefix("bench").trim().ifEmpty { "nothing" }
            status shouldBe 2
        }
    }

    mapOf(
        "new" to "new takes the name of a project, such as my-robot", "sample" to "sample takes the name of one: blink",
        "site here" to "site takes --into FOLDER or nothing, not: here", "dist here" to "dist takes --bundle or nothing, not: here",
        "install here" to "install takes no arguments, not: here", "explore" to "explore takes the .asl of an agent",
        "sample blinc" to "there is no sample 'blinc'; there are: blink, collision",
        "new 2fast" to "a project's name begins with a letter and has ASCII letters, digits, - and _, unlike \"2fast\"",
    ).forEach { (line, reason) ->
        test("./argo $line is refused before anything is built") {
            val (status, said) = bash("../argo", *line.split(' ').toTypedArray())
            said shouldStartWith "./argo: $reason"
            status shouldBe 2
        }
    }

    test("a project that cannot be made is refused before anything is built") {
        val folder = tempdir().toPath()
        folder.resolve("taken").createDirectories()
        fun new(vararg arguments: String) = bash("../argo", "new", *arguments)
        new("robot", "--in", "$folder/none") shouldBe (1 to "./argo: there is no folder $folder/none, in which robot would be made\n")
        new("--boards", "2", "--in=$folder/none", "robot") shouldBe
            (1 to "./argo: there is no folder $folder/none, in which robot would be made\n")
        new("--in", "$folder", "taken") shouldBe (1 to "./argo: $folder/taken exists already, and is not overwritten\n")
    }

    test("an agent that is not there is refused before anything is built") {
        bash("../argo", "explore", "no-such.asl", "--time", "1") shouldBe
            (1 to "./argo: there is no file no-such.asl, nor is it in src/agt, src/main/asl or src/test/resources\n")
    }
})

private const val SIGTERM_STATUS = 143
