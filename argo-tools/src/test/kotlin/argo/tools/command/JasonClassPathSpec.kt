package argo.tools.command

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import java.io.File
import kotlin.io.path.createDirectories

class JasonClassPathSpec : FunSpec({
    val project = tempdir().toPath()
    val said = "an exploration runs Jason, which argo.jar does not hold: --class-path names its jars and the project's classes, such as "
    val jars = "jason/*${File.pathSeparator}"

    fun missing() = missingJason("an exploration", project)

    test("names the folders of both builds while there is none, and then the one that is there") {
        missing() shouldBe "$said--class-path '${jars}target/classes' of Maven or --class-path '${jars}build/classes/java/main' of Gradle"
        project.resolve("target/classes").createDirectories()
        missing() shouldBe "$said--class-path '${jars}target/classes'"
    }
})
