package argo.watching

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.nio.file.attribute.FileTime
import kotlin.io.path.deleteExisting
import kotlin.io.path.moveTo
import kotlin.io.path.writeText

class SavedFilesSpec : FunSpec({
    val asl = Path.of("robot.asl")
    val xml = Path.of("front.xml")
    fun stamp(ms: Long) = FileStamp(FileTime.fromMillis(ms), 10, null)
    val stamps = HashMap<Path, FileStamp?>()
    beforeTest { stamps.putAll(mapOf(asl to stamp(1), xml to stamp(1))) }

    test("files that stand still are not saved, however often one looks") {
        val saved = SavedFiles(stamps::get)
        repeat(5) { saved.look(listOf(asl, xml)).shouldBeEmpty() }
    }

    test("a file is saved once it has changed and then stood still for a look") {
        val saved = SavedFiles(stamps::get)
        saved.look(listOf(asl, xml))
        stamps[asl] = stamp(2)
        saved.look(listOf(asl, xml)).shouldBeEmpty()
        stamps[asl] = stamp(3) // the editor still writes
        saved.look(listOf(asl, xml)).shouldBeEmpty()
        saved.look(listOf(asl, xml)) shouldBe listOf(asl)
        saved.look(listOf(asl, xml)).shouldBeEmpty()
    }

    test("a file that goes and comes back as it was is not saved; one that stays away is, since the program lacks it") {
        val saved = SavedFiles(stamps::get)
        saved.look(listOf(asl))
        stamps[asl] = null
        saved.look(listOf(asl)).shouldBeEmpty()
        stamps[asl] = stamp(1)
        repeat(2) { saved.look(listOf(asl)).shouldBeEmpty() }
        stamps[asl] = null
        saved.look(listOf(asl)).shouldBeEmpty()
        saved.look(listOf(asl)) shouldBe listOf(asl)
    }

    test("a file that the program newly includes is not saved by that") {
        val saved = SavedFiles(stamps::get)
        saved.look(listOf(asl))
        repeat(3) { saved.look(listOf(asl, xml)).shouldBeEmpty() }
        stamps[xml] = stamp(2)
        saved.look(listOf(asl, xml))
        saved.look(listOf(asl, xml)) shouldBe listOf(xml)
    }

    test("a file that an editor replaces by another of the same length and time is saved") {
        val folder = tempdir().toPath()
        val file = folder.resolve("robot.asl").apply { writeText("a.") }
        val other = folder.resolve("robot.asl~").apply { writeText("b.") }
        val time = FileTime.fromMillis(1_000)
        listOf(file, other).forEach { Files.setLastModifiedTime(it, time) }
        val saved = SavedFiles()
        saved.look(listOf(file))
        other.moveTo(file, StandardCopyOption.REPLACE_EXISTING)
        saved.look(listOf(file))
        saved.look(listOf(file)) shouldBe listOf(file)
        file.deleteExisting()
        saved.look(listOf(file)).shouldBeEmpty()
    }
})
