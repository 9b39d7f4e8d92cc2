package samples.collision

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import samples.Program
import kotlin.io.path.appendText
import kotlin.io.path.createDirectory
import kotlin.io.path.readText
import kotlin.io.path.writeText

@Tags("Thorough")
class WatchSpec : FunSpec({
    test("the robot drives again and again, by a program that is edited meanwhile; a mistake in it is told, and the robot drives on") {
        val folder = tempdir().toPath()
        Program.start("samples.MainKt", "demo", "--watch", "--limit", "190", directory = folder).use { run ->
            run.awaitLine("edit collision/robot.asl")
            val program = folder.resolve("collision/robot.asl")
            run.awaitLine("stopped: ")
            program.writeText(program.readText().replace("\"stopped: ", "\"halted: "))
            run.awaitLine("robot.asl saved")
            run.awaitLine("halted: ")
            program.appendText("+!broken <- .")
            run.awaitLine("robot.asl saved, but the agent goes on as it is:")
            repeat(2) { run.awaitLine("halted: ") }
            val filter = folder.resolve("collision/filters/frontDistance.xml")
            filter.writeText(filter.readText().replace("PerceptionFilter", "PerceptionFilters"))
            run.awaitLine("frontDistance.xml saved, but")
            run.interrupt()
        }
    }

    test("a folder without a program is refused") {
        val folder = tempdir().toPath()
        folder.resolve("mine").createDirectory()
        val (status, printed) = Program.start("samples.MainKt", "demo", "--watch", "mine", directory = folder).use { it.awaitEnd() }
        status shouldBe 1
        printed shouldContain "there is no robot.asl in mine"
    }
})
