package samples.bare

import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import samples.Program
import samples.documents.Document
import java.io.File
import java.nio.file.Path
import kotlin.io.path.Path
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.isDirectory
import kotlin.io.path.writeText

/** Runs the project of the page on migrating in JaCaMo, in its own process, if JaCaMo is installed. */
@Tags("Thorough")
class JaCaMoSpec : FunSpec({
    val libraries = System.getenv("JACAMO_LIB")?.let(::Path)
    val isThere: EnabledOrReasonIf = {
        if (libraries?.isDirectory() == true) Enabled.enabled
        else Enabled.disabled(
            "JaCaMo is not on Maven Central: JACAMO_LIB names a folder with its jars and those that they need, Jason's too",
        )
    }

    test("an agent perceives through its board and an artifact, acts on both, and ends its system").config(enabledOrReasonIf = isThere) {
        val project = tempdir().toPath()
        val root = Path.of("..").toRealPath()
        val page = Document.all(root).single { it.name == "docs/migrating.md" }
        project.resolve("robot.jcm").writeText(page.snippets.single { it.language == "jcm" }.text)
        project.resolve("src/agt").createDirectories().resolve("robot.asl").writeText(ROBOT)
        project.resolve("logging.properties").writeText("handlers = java.util.logging.ConsoleHandler\n")
        root.resolve("argo-tools/src/main/resources/argo/tools/project/drive.rec").copyTo(project.resolve("drive.rec"))

        val classPath =
            listOf("$libraries/*", "${Path.of(System.getProperty("argo.jar")).toAbsolutePath()}").joinToString(File.pathSeparator)
        val ended = Program.run(
            ProcessBuilder(
                newestJava().program, "-Duser.home=$project", "-cp", classPath, "jacamo.infra.JaCaMoLauncher", "robot.jcm", "--no-net",
            ).directory(project.toFile()),
        )
        withClue(ended.printed) {
            ended.printed shouldContain Regex("tick \\d+ with \\d+ cm in front")
            ended.printed shouldNotContain "Exception"
        }
    }
})

/** Starts the clock when an object is near. Ends the system after both have happened. */
private const val ROBOT = """
!start.
+!start <- .port("replay:drive.rec"); argo.limit(100); .argo.percepts(open).
+dist(front,Cm) : Cm < 50 & not near <- +near; argo.act(ledOn); start.
+nticks(N) : N > 0 & dist(front,Cm) <- .print("tick ", N, " with ", Cm, " cm in front"); .stopMAS(0,0).
{ include("${'$'}jacamo/templates/common-cartago.asl") }
"""
