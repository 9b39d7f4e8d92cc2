package argo.tools.project

import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.ToolException
import argo.tools.command.making
import argo.tools.command.messageOf
import argo.tools.command.ownJar
import argo.tools.command.requireNew
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.isRegularFile
import kotlin.io.path.writeText

@Command(
    name = "new",
    description = [
        "Makes a Jason project in a folder of its name: agent, filter in Kotlin, Arduino sketch, tests, builds for Gradle and Maven.",
        "It runs without a board. Existing files are not overwritten.",
    ],
)
internal class NewCommand : ToolCommand() {
    @Parameters(index = "0", paramLabel = "NAME", description = ["the project's name: letters, digits, - and _"])
    private lateinit var name: String

    @Option(names = ["--boards"], paramLabel = "N", description = ["how many boards the agent perceives: 1 or 2 (\${DEFAULT-VALUE})"])
    private var boards: Int = 1

    @Option(names = ["--in"], paramLabel = "FOLDER", description = ["the parent folder (the working directory)"])
    private var parent: Path = Path.of("")

    @Option(names = ["--argo-jar"], paramLabel = "FILE", description = ["argo.jar, if this program does not run from it"])
    private var argoJar: Path? = null

    @Option(names = ["--testkit-jar"], paramLabel = "FILE", description = ["argo-testkit.jar, if it is not beside argo.jar"])
    private var testKitJar: Path? = null

    override fun call(): Int {
        ProjectName.problem(name)?.let { misuse(it) }
        if (boards !in 1..MAX_BOARDS) misuse("--boards is 1 or $MAX_BOARDS, not $boards; a project can be given more later, see argo.ports")
        val argo = existing(argoJar ?: ownJar() ?: misuse("this program does not run from argo.jar; give it with --argo-jar FILE"))
        val testKit = testKitJar?.let(::existing)
            ?: listOf(TEST_KIT, "argo-testkit-$VERSION.jar").map(argo::resolveSibling).find { it.isRegularFile() }
        val target = parent.resolve(name)
        requireNew(target)
        make(target, argo, testKit)
        out.println("made $target: \"cd ${quoted(target)}\", then \"gradle\" or \"mvn compile exec:exec\" runs it; see README.md")
        if (testKit == null) {
            err.println("there is no $TEST_KIT beside argo.jar, so the project has no test of its agent; give it with --testkit-jar FILE")
        }
        return ExitStatus.DONE
    }

    /** Makes the project under a temporary name first. A full disk then leaves no partial project. */
    private fun make(target: Path, argo: Path, testKit: Path?) {
        val draft = making(parent.toAbsolutePath().resolve(".$name-${ProcessHandle.current().pid()}")) { Files.createDirectory(it) }
        try {
            projectFiles(ProjectName(name), withTestKit = testKit != null, boards).forEach { (path, text) ->
                draft.resolve(path).apply { parent.createDirectories() }.writeText(text)
            }
            val lib = draft.resolve("lib").createDirectories()
            argo.copyTo(lib.resolve("argo.jar"))
            testKit?.copyTo(lib.resolve(TEST_KIT))
            Files.move(draft, target.toAbsolutePath())
        } catch (trouble: IOException) {
            throw ToolException("$target cannot be made: ${messageOf(trouble)}")
        } finally {
            draft.toFile().deleteRecursively()
        }
    }

    private fun quoted(path: Path) = "$path".let { if (PLAIN.matches(it)) it else "'${it.replace("'", "'\\''")}'" }

    private fun existing(file: Path): Path = file.takeIf { it.isRegularFile() } ?: throw ToolException("there is no file $file")

    private companion object {
        const val TEST_KIT = "argo-testkit.jar"
        const val MAX_BOARDS = 2

        /** Matches paths that shells read without quotes. */
        val PLAIN = Regex("""[\w./\\:+-]+""")

        /** The version in ARGO's file names. */
        const val VERSION = "0.1.0"
    }
}
