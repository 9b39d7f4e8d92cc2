package argo.build

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Path
import java.util.zip.ZipFile
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * Tests `./argo dist --bundle` with a key made for the test. Calls the functions of the script that check what Maven's central registry
 * requires.
 */
class BundleSpec : FunSpec({
    fun tree(properties: String = OF_A_PUBLISHER): Path = tempdir().toPath().apply { resolve("pom.xml").writeText("$properties\n") }

    /** Runs [commands] in the script of `dist` for the sources in [tree]. Returns the exit status and the output. */
    fun dist(tree: Path, commands: String): Pair<Int, String> {
        val script = "export GNUPGHOME='$tree/keys'; . ../build-tools/dist; here='$tree'; $commands"
        val bash = ProcessBuilder("bash", "-c", script).redirectErrorStream(true).start()
        return bash.inputStream.readBytes().decodeToString().let { bash.waitFor() to it }
    }

    val key = "mkdir -m 700 \"\$GNUPGHOME\"; gpg --batch --quiet --passphrase '' --quick-generate-key test ed25519 default never"
    val end = "gpgconf --kill gpg-agent" // the test deletes the agent's folder

    /** Adds a library to [tree] in the form in which `dist` packs libraries. */
    fun library(tree: Path, pom: String = POM) {
        listOf(".jar", "-sources.jar", "-javadoc.jar", ".pom").forEach { ending ->
            val packed = tree.resolve("packed$ending").apply { writeText(if (ending == ".pom") pom else ending) }
            dist(tree, "in_repository one 1.0 '$packed' $ending").let { (status, said) -> withClue(said) { status shouldBe 0 } }
        }
    }

    test("a bundle holds each file of a library with its checksums and a signature").config(enabled = IS_GPG_THERE) {
        val tree = tree()
        library(tree)
        val (status, said) = dist(tree, "$key; need_publisher; bundle; cd '$tree/dist/maven/$FOLDER' && gpg --verify one-1.0.jar.asc; $end")
        withClue(said) { status shouldBe 0 }
        said shouldContain "Good signature"
        val names = ZipFile(tree.resolve("dist/bundle.zip").toFile()).use { zip -> zip.entries().asSequence().map { it.name }.toList() }
        names shouldContainExactlyInAnyOrder listOf(".jar", "-sources.jar", "-javadoc.jar", ".pom")
            .flatMap { file -> listOf("", ".md5", ".sha1", ".asc").map { "$FOLDER/one-1.0$file$it" } }
    }

    mapOf(
        "<name>one</name>" to "has no name", "<connection>scm:git:x</connection>" to "has no scm/connection",
    ).forEach { (element, reason) ->
        test("there is no bundle of a POM that $reason").config(enabled = IS_GPG_THERE) {
            val tree = tree()
            library(tree, POM.replace(element, ""))
            val (status, said) = dist(tree, "$key; trap '$end' EXIT; bundle")
            said shouldContain "$FOLDER/one-1.0.pom $reason"
            status shouldBe 1
            tree.resolve("dist/bundle.zip").exists() shouldBe false
        }
    }

    test("there is no bundle without documentation").config(enabled = IS_GPG_THERE) {
        val tree = tree()
        library(tree)
        tree.resolve("dist/maven/$FOLDER/one-1.0-javadoc.jar").deleteExisting()
        dist(tree, "$key; trap '$end' EXIT; bundle").second shouldContain "there is no $FOLDER/one-1.0-javadoc.jar"
    }

    mapOf(
        OF_A_PUBLISHER.replace("org.example.robots", "argo") to "the property argo.group in pom.xml is argo",
        OF_A_PUBLISHER.replace("<argo.url>https://example.org</argo.url>", "<argo.url />") to "pom.xml has no value for argo.url:",
        "    <argo.group>org.example</argo.group>" to "pom.xml has no value for argo.url argo.developer argo.scm:",
        OF_A_PUBLISHER to "gpg has no key to sign with",
    ).forEach { (properties, reason) ->
        test("dist --bundle says before it builds: $reason").config(enabled = IS_GPG_THERE) {
            val (status, said) = dist(tree(properties), "mkdir -m 700 \"\$GNUPGHOME\"; trap '$end' EXIT; need_publisher")
            said shouldContain "./argo: $reason"
            status shouldBe 1
        }
    }

    test("the POM of this repository has a place for all that a publisher says, and names nobody") {
        val pom = Path.of("../pom.xml").readText()
        listOf("argo.url", "argo.developer", "argo.scm").forEach { pom shouldContain "    <$it />\n" }
    }
})

private const val FOLDER = "org/example/robots/one/1.0"

private const val OF_A_PUBLISHER = """    <argo.group>org.example.robots</argo.group>
    <argo.url>https://example.org</argo.url>
    <argo.developer>Example</argo.developer>
    <argo.scm>https://example.org/robots.git</argo.scm>
  <version>1.0</version>"""

private const val POM = """<project xmlns="http://maven.apache.org/POM/4.0.0">
  <groupId>org.example.robots</groupId><artifactId>one</artifactId><version>1.0</version>
  <name>one</name><description>d</description><url>u</url>
  <licenses><license><name>l</name><url>u</url></license></licenses>
  <developers><developer><name>n</name></developer></developers>
  <scm><connection>scm:git:x</connection><developerConnection>scm:git:x</developerConnection><url>u</url></scm>
</project>"""

private val IS_GPG_THERE = System.getenv("PATH").split(':').any { Path.of(it, "gpg").exists() }
