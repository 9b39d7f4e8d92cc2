package argo.packing

import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import org.objectweb.asm.ClassReader
import org.objectweb.asm.ClassWriter
import org.objectweb.asm.Opcodes
import org.objectweb.asm.commons.ClassRemapper
import org.objectweb.asm.commons.Remapper
import java.nio.file.Path
import java.util.jar.JarFile
import kotlin.io.path.exists

/** Tests the contents of argo.jar. */
class JarSpec : FunSpec({
    val file = Path.of(System.getProperty("argo.jar"))
    val jar = Source.read(file)
    val own = jar.classes.filterNot { it.startsWith("argo/shaded/") }
        .filter { name -> listOf("argo/", "javino/", "jason/").any { name.startsWith(it) } }

    test("it holds the architecture, the live view, the filters, the links and the tools") {
        listOf("argo/Arch", "argo/port", "argo/view/AgentView", "argo/filters/PerceptionFilter", "javino/link/Link", "argo/tools/MainKt")
            .forEach { own shouldContain it }
        JarFile(file.toFile()).use { it.manifest.mainAttributes.getValue("Main-Class") } shouldBe "argo.tools.MainKt"
    }

    test("no library is in it under its own name, but Kotlin's and the serial driver") {
        jar.classes.filterNot { name -> OWN_NAMES.any { name.startsWith(it) } }.shouldBeEmpty()
    }

    test("the board for tests is not in it") {
        own.filter { it.startsWith("javino/sim/FakeBoard") }.shouldBeEmpty()
    }

    test("whatever ARGO's classes name is in it, in Java or in Jason") {
        val there = jar.classes.toSet()
        own.flatMap { names(jar.entries.getValue("$it.class")) }.toSet()
            .filterNot { it in there || it.startsWith("jason/") || isOfJava(it) }.shouldBeEmpty()
    }

    test("each provider that a service file of ARGO, or of a renamed library, names is in it") {
        val services = jar.entries.filterKeys { it.startsWith("META-INF/services/argo.") || it.startsWith("META-INF/services/javino.") }
        services.flatMap { (_, bytes) -> providers(bytes) }.filterNot { it.replace('.', '/') in jar.classes }.shouldBeEmpty()
    }

    context("argo-fleet.jar, beside it") {
        val fleets = Path.of(System.getProperty("argo.fleet.jar"))
        val beside = Source.read(fleets)

        test("holds fleets and JGroups, and nothing that argo.jar holds") {
            listOf("argo/fleet/MainKt", "org/jgroups/JChannel").forEach { beside.classes shouldContain it }
            beside.classes.filter { it in jar.classes }.shouldBeEmpty()
            JarFile(fleets.toFile()).use { it.manifest.mainAttributes.getValue("Class-Path") } shouldBe "argo.jar"
        }
        test("whatever its classes of ARGO name is in one of them, in Java or in Jason") {
            val there = jar.classes.toSet() + beside.classes
            beside.classes.filter { it.startsWith("argo/") }.flatMap { names(beside.entries.getValue("$it.class")) }.toSet()
                .filterNot { it in there || it.startsWith("jason/") || isOfJava(it) }.shouldBeEmpty()
        }
    }

    val gradles = Path.of("build/libs/argo.jar")
    val mavens = Path.of("target/argo.jar")
    val areBothBuilt = gradles.exists() && mavens.exists()
    val bothBuilt = if (areBothBuilt) Enabled.enabled else Enabled.disabled("one of the builds has packed no jar here")
    test("the jar that Gradle packs holds the same files and services as Maven's").config(enabledOrReasonIf = { bothBuilt }) {
        val (one, other) = listOf(gradles, mavens).map { Source.read(it).entries }
        (one.keys - other.keys to other.keys - one.keys) shouldBe (emptySet<String>() to emptySet<String>())
        one.services() shouldBe other.services()
    }
})

private fun Map<String, ByteArray>.services(): Map<String, List<String>> =
    filterKeys { it.startsWith("META-INF/services/") }.mapValues { (_, bytes) -> providers(bytes) }

private fun isOfJava(name: String): Boolean = ClassLoader.getPlatformClassLoader().getResource("$name.class") != null

private fun names(bytes: ByteArray): Set<String> {
    val names = mutableSetOf<String>()
    val collector = object : Remapper(Opcodes.ASM9) {
        override fun map(name: String): String = name.also { names += it }
    }
    ClassReader(bytes).accept(ClassRemapper(ClassWriter(0), collector), 0)
    return names
}
