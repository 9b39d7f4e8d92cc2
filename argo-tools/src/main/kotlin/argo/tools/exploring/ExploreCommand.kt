package argo.tools.exploring

import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.ToolException
import argo.tools.command.classPathWithJason
import argo.tools.command.missingJason
import argo.tools.command.printableLines
import argo.tools.command.requireFile
import argo.tools.command.requireNew
import argo.tools.command.requireWithin
import argo.tools.command.runJava
import argo.tools.command.tellAbsent
import picocli.CommandLine
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.io.File
import java.nio.file.Path
import kotlin.io.path.createTempDirectory

@Command(
    name = "explore",
    description = [
        "Plays changing sensors and faults of boards against an agent in virtual time, and looks for a run that breaks a rule.",
        "Prints such a run, as short as it gets, in words and as a spec. Exit status: 0 none found, 1 found, 2 wrong arguments,",
        "3 nothing could be found out.",
        "For example: explore robot.asl --board 'ttyACM0 dist(front,5..200)' --rule 'stopsWhenBlind(stop,[front])'",
    ],
)
internal class ExploreCommand : ToolCommand() {
    @Parameters(index = "0", paramLabel = "FILE", description = ["the .asl of an agent, or the .mas2j of a system"])
    private lateinit var source: String

    @Option(
        names = ["--board"], paramLabel = "BOARD",
        description = [
            "a port, as the agent names it, and what each sensor can show: a number of a range, or one of several percepts, at first the " +
                "first one; nothing is a percept too: 'ttyACM0 dist(front,5..200) line(on)|line(off)|'",
        ],
    )
    private var boards: List<String> = emptyList()

    @Option(names = ["--version2"], description = ["the boards of --board speak version 2 of the protocol"])
    private var isVersion2 = false

    @Option(
        names = ["--boards"], paramLabel = "WHERE",
        description = [
            "boards and rules in Kotlin, a function Exploration.boards(): the name of its class on the class path, RobotKt; " +
                "or the file, robot.kt, which kotlinc of the PATH compiles",
        ],
    )
    private var described: String? = null

    @Option(names = ["--message"], paramLabel = "MESSAGE", description = ["a message that may come: 'robot boss achieve patrol'"])
    private var messages: List<String> = emptyList()

    @Option(names = ["--rule"], paramLabel = "RULE", description = ["one more rule: 'stopsWhenBlind(stop,[front])'"])
    private var rules: List<String> = emptyList()

    @Option(names = ["--without"], paramLabel = "RULE", description = ["leaves out a rule, as neverOscillates"])
    private var left: List<String> = emptyList()

    @Option(names = ["--faults"], paramLabel = "FAULT,…", description = ["plays only these faults, as cables,noise; '' for none"])
    private var faults: String? = null

    @Option(names = ["--seed"], paramLabel = "N", description = ["the first seed (0)"])
    private var seed: Long? = null

    @Option(names = ["--runs"], paramLabel = "N", description = ["how many runs are tried at most (1000)"])
    private var runs: Int? = null

    @Option(names = ["--time"], paramLabel = "S", description = ["how long runs are tried at most, in seconds of real time (60)"])
    private var time: Int? = null

    @Option(names = ["--spec"], paramLabel = "FILE", description = ["also writes the spec, as AgesSpec.kt"])
    private var written: Path? = null

    @Option(names = ["--class-path"], paramLabel = "PATH", description = ["the project's classes and jars, and Jason's, as for java -cp"])
    private var classPath: String? = null

    override fun call(): Int = try {
        explore()
    } catch (refused: ToolException) {
        err.println(printableLines(refused.message.orEmpty()))
        NOTHING_KNOWN
    }

    private fun explore(): Int {
        if (boards.isEmpty() && described == null) misuse("describe the agent's board: --board 'ttyACM0 dist(front,5..200)'")
        runs?.let { spec.requireWithin("--runs", it, 1..MOST_RUNS) }
        time?.let { spec.requireWithin("--time", it, 1..MOST_SECONDS, "seconds") }
        written?.let(::requireNew)
        tellAbsent(classPath, err)
        val path = withTestKit(classPathWithJason(classPath) ?: throw ToolException(missingJason("an exploration")))
        val wanted = described ?: return explore(path, null)
        if (!wanted.endsWith(".kt")) return explore(path, wanted)
        val classes = createTempDirectory("argo-explore")
        try {
            requireFile(Path.of(wanted))
            return explore("$classes${File.pathSeparator}$path", compiled(Path.of(wanted), path, classes))
        } finally {
            classes.toFile().deleteRecursively()
        }
    }

    private fun explore(classPath: String, described: String?): Int {
        val options = givenWithout("--class-path", "--boards") + listOfNotNull(described?.let { "--boards=$it" })
        val status = runJava(listOf("-cp", classPath, "argo.exploring.command.MainKt", source) + options)
        return when (status) {
            FOUND_THERE -> ExitStatus.FAILED
            in TOLD -> status
            else -> throw ToolException(
                "nothing was explored: the Java machine for it has ended with status $status. What it printed above has the reason, such " +
                    "as too little memory, or a class path without the test kit",
            )
        }
    }

    private companion object {
        const val MOST_RUNS = 1_000_000
        const val MOST_SECONDS = 86_400

        const val NOTHING_KNOWN = 3

        /** The exit status of an exploration that found a run that breaks a rule. */
        const val FOUND_THERE = 4

        /** The exit statuses with which an exploration has already printed the reason. */
        val TOLD = setOf(ExitStatus.DONE, CommandLine.ExitCode.USAGE, NOTHING_KNOWN)
    }
}
