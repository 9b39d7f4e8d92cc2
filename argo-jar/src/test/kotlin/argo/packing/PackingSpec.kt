package argo.packing

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.maps.shouldContainKeys
import io.kotest.matchers.maps.shouldNotContainKeys
import io.kotest.matchers.shouldBe
import java.net.URLClassLoader
import java.nio.file.Path
import java.util.function.Supplier
import kotlin.io.path.createDirectories
import kotlin.io.path.readBytes
import kotlin.io.path.writeText

private const val SERVICE = "META-INF/services/fixture.library.Voice"

class PackingSpec : FunSpec({
    val library = classes("fixture/library/Voice.class", "fixture/library/LibraryVoice.class") + texts(
        SERVICE to "# the library's own\nfixture.library.LibraryVoice\n",
        "META-INF/library.kotlin_module" to "names",
        "META-INF/LICENSE-library" to "licence",
    )
    val program = classes("fixture/program/Choir.class", "fixture/program/ProgramVoice.class") + texts(
        SERVICE to "fixture.program.ProgramVoice # the program's\nfixture.library.LibraryVoice\n",
        "META-INF/program.kotlin_module" to "names",
        "META-INF/SIGNED.SF" to "signature",
        "META-INF/versions/9/module-info.class" to "module",
        "module-info.class" to "module",
    )
    val sources = listOf(Source(program), Source(library))
    val packed = pack(sources, Relocation(sources, own = listOf("fixture/program/"), into = "shaded/"))

    test("service files of one name become one, under the library's new name, with each provider once") {
        packed.getValue("META-INF/services/shaded.fixture.library.Voice").decodeToString() shouldBe
            "fixture.program.ProgramVoice\nshaded.fixture.library.LibraryVoice\n"
        packed.shouldNotContainKeys(SERVICE)
    }

    test("a packed program runs with the library under its new name alone") {
        val jar = tempdir().toPath().resolve("packed.jar")
        writeJar(jar, emptyMap(), packed)
        val kotlin = Unit::class.java.protectionDomain.codeSource.location
        URLClassLoader(arrayOf(jar.toUri().toURL(), kotlin), ClassLoader.getPlatformClassLoader()).use { loader ->
            val choir = loader.loadClass("fixture.program.Choir").getConstructor().newInstance() as Supplier<*>
            choir.get() shouldBe listOf("program", "library")
        }
        packed.shouldContainKeys("shaded/fixture/library/Voice.class")
        packed.shouldNotContainKeys("fixture/library/Voice.class")
    }

    test("a class that names no library is packed as it is") {
        val alone = listOf(Source(classes("fixture/library/Voice.class")))
        pack(alone, Relocation(alone, own = listOf("fixture/"), into = "shaded/")).getValue("fixture/library/Voice.class") shouldBe
            library.getValue("fixture/library/Voice.class")
    }

    test("signatures, module descriptors and what a library says of its old names are left out, its licence is not") {
        packed.shouldNotContainKeys("META-INF/SIGNED.SF", "module-info.class", "META-INF/versions/9/module-info.class")
        packed.shouldNotContainKeys("META-INF/library.kotlin_module")
        packed.shouldContainKeys("META-INF/program.kotlin_module", "META-INF/LICENSE-library")
    }

    test("of a file that several have the first is taken") {
        val two = listOf(Source(texts("LICENSE" to "mine")), Source(texts("LICENSE" to "theirs")))
        pack(two, Relocation(two, emptyList(), "shaded/")).getValue("LICENSE").decodeToString() shouldBe "mine"
    }

    test("a folder, a jar and nothing are read alike, and the same entries make the same bytes") {
        val folder = tempdir().toPath()
        val content = folder.resolve("content/deep").createDirectories().apply { resolve("file.txt").writeText("text") }.parent
        val jars = (1..2).map { folder.resolve("$it.jar") }
        jars.forEach { writeJar(it, mapOf("Main-Class" to "Main"), Source.read(content).entries) }
        jars[0].readBytes() shouldBe jars[1].readBytes()
        Source.read(jars[0]).entries.keys shouldContainExactly setOf("META-INF/MANIFEST.MF", "deep/file.txt")
        Source.read(Path.of("no/such/folder")).entries shouldBe emptyMap()
    }
})

private fun classes(vararg names: String): Map<String, ByteArray> =
    names.associateWith { name -> checkNotNull(PackingSpec::class.java.classLoader.getResource(name)) { name }.readBytes() }

private fun texts(vararg entries: Pair<String, String>): Map<String, ByteArray> =
    entries.associate { (name, text) -> name to text.toByteArray() }
