package samples.collision

import argo.tools.command.ToolCommand
import argo.tools.command.ToolException
import argo.tools.command.requireWithin
import javino.LineSettings
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import samples.project.LogFile
import samples.project.Logs
import samples.project.Progress
import samples.project.SampleProject
import sun.misc.Signal
import java.nio.charset.Charset
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicBoolean
import kotlin.io.path.exists
import kotlin.io.path.isRegularFile
import kotlin.system.exitProcess

@Command(
    name = "collision",
    description = [
        "A robot drives at a wall and its agent stops it.",
        "The robot is simulated: it starts 200 cm from the wall and drives at 10 cm/s. With --port the agent drives a real one.",
    ],
    exitCodeListHeading = "%nExit status:%n",
    exitCodeList = ["0:the robot was stopped", "1:it ran into the wall, or there was nothing to measure", "2:wrong arguments"],
    sortOptions = false,
)
internal class CollisionCommand : ToolCommand() {
    @Option(
        names = ["--filter"], paramLabel = "name", defaultValue = "frontDistance",
        description = ["the agent's filter: none, frontSide or frontDistance (default: \${DEFAULT-VALUE})"],
    )
    private lateinit var filter: String

    @Option(
        names = ["--limit"], paramLabel = "cm", defaultValue = "40",
        description = ["the front distance at which the agent stops (default: \${DEFAULT-VALUE})"],
    )
    private var limit = 0

    @Option(
        names = ["--interval"], paramLabel = "ms", defaultValue = "20",
        description = ["the sensing interval; 0: as fast as the line allows (default: \${DEFAULT-VALUE})"],
    )
    private var interval = 0

    @Option(
        names = ["--baud"], paramLabel = "n", defaultValue = "${LineSettings.DEFAULT_BAUD}",
        description = ["the line's rate, each byte takes ten bit times (default: \${DEFAULT-VALUE})"],
    )
    private var baud = 0

    @Option(
        names = ["--sensing"], paramLabel = "policy", defaultValue = "fresh",
        description = ["when the agent gets a snapshot of its sensors: fresh, every or in_cycle (default: \${DEFAULT-VALUE})"],
    )
    private lateinit var sensing: String

    @Option(names = ["--port"], paramLabel = "device", description = ["the port of a real robot, such as ttyACM0 or COM5"])
    private var port: String? = null

    @Option(
        names = ["--boards"], paramLabel = "n", defaultValue = "1",
        description = ["the boards of the simulated robot; 2: its sensors have one of their own (default: \${DEFAULT-VALUE})"],
    )
    private var boards = 0

    @Option(names = ["--seed"], paramLabel = "n", description = ["where the noise of the simulated sensors starts from (default: 1)"])
    private var seed: Long? = null

    @Option(
        names = ["--view"], paramLabel = "port", arity = "0..1", fallbackValue = "0",
        description = ["shows the agent live on a page for browsers on this computer (default: on a port that is free)"],
    )
    private var view: Int? = null

    @Option(
        names = ["--view-wait"], paramLabel = "s",
        description = ["with --view, how long the robot waits for the first browser, or Enter; 0: not at all (default: 60)"],
    )
    private var viewWait: Int? = null

    @Option(
        names = ["--watch"], paramLabel = "folder", arity = "0..1", fallbackValue = "collision",
        description = [
            "reloads the agent whenever its program or a filter in the folder is saved, and puts the robot back after each drive; " +
                "without the folder, it is made with the program of the sample (default: \${FALLBACK-VALUE})",
        ],
    )
    private var watch: Path? = null

    override fun call(): Int {
        val levels = levels()
        val audience = audience()
        watch?.let { return edited(levels, audience, it) }
        val progress = Progress.onStandardOutput()
        val log = LogFile.open("collision")
        val isOver = AtomicBoolean()
        val (verdict, warning) = log.use {
            val run = CollisionRun(levels, progress, audience)
            whenInterrupted {
                if (isOver.getAndSet(true)) return@whenInterrupted
                run.abandon()
                log.delete()
                run.warning?.let(System.err::println)
                exitProcess(INTERRUPTED)
            }
            run.run() to run.warning
        }
        if (isOver.getAndSet(true)) return INTERRUPTED.also { log.delete() }
        if (verdict.exitStatus == 0) log.delete() else println("log: ${log.path}")
        println(verdict.sentence)
        warning?.let(System.err::println)
        return verdict.exitStatus
    }

    /** Makes the robot drive repeatedly until Ctrl-C. The user edits the agent's program in [folder]. */
    private fun edited(levels: Levels, audience: Audience?, folder: Path): Int {
        val program = folder.resolve(PROGRAM)
        if (!folder.exists()) SampleProject("collision").copy(FILES, folder)
        if (!program.isRegularFile()) throw ToolException("there is no $PROGRAM in $folder")
        println("edit $program and $folder/filters: the agent is reloaded when a file is saved. Ctrl-C ends it")
        Logs.to(System.out)
        val verdict = CollisionRun(levels, Progress(System.out, inPlace = false, Charset.defaultCharset()), audience, program).run()
        println(verdict.sentence)
        return verdict.exitStatus
    }

    /** Does [action] on Ctrl-C. A shutdown hook would be too late, since jSerialComm's own hook may already have closed the ports. */
    private fun whenInterrupted(action: () -> Unit) = listOf("INT", "TERM").forEach { name -> Signal.handle(Signal(name)) { action() } }

    private fun levels(): Levels {
        requireOneOf("--filter", filter, "none", "frontSide", "frontDistance")
        requireOneOf("--sensing", sensing, "fresh", "every", "in_cycle")
        val maxCm = if (port == null) Course.START_CM.toInt() - 1 else MAX_CM
        spec.requireWithin(
            "--limit", limit, 1..maxCm,
            "cm" + if (port == null) ", since the robot starts ${Course.START_CM.toInt()} cm from the wall" else "",
        )
        spec.requireWithin("--interval", interval, 0..MAX_MS, "ms")
        spec.requireWithin("--baud", baud, MIN_BAUD..MAX_BAUD, "bits a second")
        if (port?.isBlank() == true) misuse("--port names no port")
        spec.requireWithin("--boards", boards, 1..2, "")
        if (port != null && boards > 1) misuse("--boards is for the simulated robot, and --port asks for a real one")
        if (port != null && watch != null) misuse("--watch is for the simulated robot, and --port asks for a real one")
        if (port != null && seed != null) misuse("--seed is for the simulated robot, and --port asks for a real one")
        return Levels(filter, limit, interval, baud, sensing, port, boards, seed ?: 1)
    }

    private fun audience(): Audience? {
        view?.let { spec.requireWithin("--view", it, 0..MAX_PORT, "as a port, 0 being any that is free") }
        viewWait?.let {
            if (view == null) misuse("--view-wait is for --view")
            spec.requireWithin("--view-wait", it, 0..MAX_WAIT_S, "s")
        }
        return view?.let { Audience(it, viewWait ?: WAIT_S, System.out, System.`in`) }
    }

    private fun requireOneOf(option: String, value: String, vararg words: String) {
        if (value !in words) misuse("$option is ${words.dropLast(1).joinToString(", ")} or ${words.last()}, not $value")
    }

    private companion object {
        const val PROGRAM = "robot.asl"
        val FILES = listOf(PROGRAM, "filters/frontDistance.xml", "filters/frontSide.xml")
        const val INTERRUPTED = 130 // the exit status that shells use for Ctrl-C
        const val MAX_PORT = 65_535
        const val WAIT_S = 60
        const val MAX_WAIT_S = 3600
        const val MAX_CM = 10_000
        const val MAX_MS = 10_000
        const val MIN_BAUD = 300
        const val MAX_BAUD = 4_000_000
    }
}
