package experiment

import argo.tools.command.ToolCommand
import argo.tools.command.requireWithin
import experiment.report.Provenance
import experiment.report.writeReport
import javino.PerceptsRequest
import javino.PortException
import javino.link.Link
import javino.link.LinkSettings
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import java.io.IOException
import java.nio.file.Path
import java.time.Instant
import kotlin.random.Random

@Command(
    name = "experiment",
    description = [
        "Makes the runs of the collision experiment that ARGO was published with and writes a report.",
        "81 runs for each condition: 3 filters, 3 limits, 3 intervals, 3 replications, in randomised order and in real time.",
        "Begun again with the same directory, it continues where it was interrupted.",
    ],
    exitCodeListHeading = "%nExit status:%n",
    exitCodeList = ["0:all runs are made", "1:some have failed", "2:wrong arguments", "130:interrupted; the same command continues"],
    sortOptions = false,
)
internal class ExperimentCommand : ToolCommand() {
    @Option(names = ["--quick"], description = ["24 runs for each condition in place of 81: 2 limits, 2 intervals, 2 replications"])
    private var quick = false

    @Option(names = ["--smoke"], hidden = true, description = ["the shortest plan, to try the program"])
    private var smoke = false

    @Option(
        names = ["--condition"], paramLabel = "a|b|c|d|all", defaultValue = "all",
        description = [
            "a: as published, b: this project's defaults, c: version 2 with subscription, d: as c, and the board stops the robot " +
                "by a reflex (default: \${DEFAULT-VALUE})",
        ],
    )
    private lateinit var condition: String

    @Option(names = ["--scaling"], description = ["also more sensors (to 768) and faster lines (to 1,000,000 baud)"])
    private var scaling = false

    @Option(names = ["--jobs"], paramLabel = "N", description = ["robots at once (default: two for each processor)"])
    private var jobs: Int? = null

    @Option(
        names = ["--seed"], paramLabel = "S",
        description = ["the seed for the order of the runs and the noise of the sensors (default: random)"],
    )
    private var seed: Long? = null

    @Option(
        names = ["--slowdown"], paramLabel = "X",
        description = [
            "how many times slower than this computer the agents of simulated robots reason, at least 1 " +
                "(default: measured, as slow as a Raspberry Pi 3 of 2016)",
        ],
    )
    private var slowdown: Double? = null

    @Option(
        names = ["--out"], paramLabel = "DIR", defaultValue = "experiment-results",
        description = ["where records and report go (default: \${DEFAULT-VALUE})"],
    )
    private lateinit var directory: Path

    @Option(
        names = ["--port"], paramLabel = "device",
        description = ["the port of a real robot, such as ttyACM0 or COM5; you put the robot back before each run"],
    )
    private var port: String? = null

    override fun call(): Int {
        val conditions = conditions()
        port?.let(::tryRobot)
        return Archive(directory).use { make(it, conditions) }
    }

    /** Asks the robot on [port] for its percepts before a user moves it, so that a wrong port or robot is refused at once. */
    private fun tryRobot(port: String) {
        val answer = try {
            Link.open(port, LinkSettings.defaults(), "the experiment").use(::firstSight)
        } catch (silent: PortException) {
            misuse("--port: ${silent.message}")
        }
        if (FRONT !in answer) {
            misuse("--port: the agent stops by the front distance, and the robot on $port shows no $FRONT…); it answers: $answer")
        }
        println("the robot on $port answers: $answer")
    }

    /** Returns the robot's first answer with the front distance, since a sensor may need some time; the last answer if none has it. */
    private fun firstSight(robot: Link): String {
        var answer = ""
        for (attempt in 1..MAX_REQUESTS) {
            answer = robot.request(PerceptsRequest.ALL, ANSWER_LIMIT_MS).text()
            if (FRONT in answer) break
            Thread.sleep(BETWEEN_REQUESTS_MS)
        }
        return answer
    }

    private fun make(archive: Archive, conditions: List<Condition>): Int {
        val settings = try {
            settings(archive).also(archive::open)
        } catch (refused: ContinuationException) {
            misuse(refused.message.orEmpty())
        } catch (unwritable: IOException) {
            misuse("--out $directory cannot be written to: $unwritable")
        }
        val workers = if (port == null) jobs ?: (2 * Runtime.getRuntime().availableProcessors()) else 1
        println(
            "seed ${settings.seed}; agents reason " +
                "${if (port == null) "${settings.slowdown} times slower than here" else "as fast as they can"} (${settings.computer})",
        )
        archive.unusable().let {
            if (it > 0) println("made anew, since their records are incomplete, damaged or of another version of ARGO: $it runs")
        }
        return try {
            make(archive, settings, conditions, workers)
        } catch (unwritable: IOException) {
            err.println(
                "experiment: ${unwritable.message}. The records are kept: make room, and the same command with --out $directory continues",
            )
            1
        }
    }

    private fun make(archive: Archive, settings: Settings, conditions: List<Condition>, workers: Int): Int {
        val finished = Experiment(archive, settings, workers).run(trials(settings, conditions)) ?: return INTERRUPTED
        val failed = finished.filter { it.result.outcome == Outcome.FAILED }
        val made = Provenance(build(), Instant.now(), machine("At most $workers robots at once"))
        val page = writeReport(archive.directory, settings, archive.finished(), made)
        println("report: $page")
        failed.forEach { println("${it.trial.id} failed: ${it.result.reason}") }
        return if (failed.isEmpty()) 0 else 1
    }

    /** Returns the published runs in one random order, followed by the runs with more work for the machine. */
    private fun trials(settings: Settings, conditions: List<Condition>): List<Trial> =
        randomised(conditions.flatMap(settings.plan::trials), settings.seed) +
            if (scaling) randomised(conditions.flatMap(settings.plan::scaling), settings.seed) else emptyList()

    private fun conditions(): List<Condition> {
        jobs?.let { spec.requireWithin("--jobs", it, 1..MAX_JOBS) }
        slowdown?.let { if (!(it in 1.0..MAX_SLOWDOWN)) misuse("--slowdown is from 1 to ${MAX_SLOWDOWN.toInt()}, not $it") }
        if (port?.isBlank() == true) misuse("--port names no port")
        if (port != null && (jobs ?: 1) > 1) misuse("--jobs is for simulated robots, and --port asks for a real one")
        if (port != null && slowdown != null) misuse("--slowdown is for simulated robots, and --port asks for a real one")
        if (port != null && scaling) misuse("--scaling is for simulated robots, and --port asks for a real one")
        if (condition == "all") return Condition.entries
        return listOf(Condition.entries.find { it.letter == condition } ?: misuse("--condition is a, b, c, d or all, not $condition"))
    }

    /** Returns the settings of the experiment to continue, changed by the options. */
    private fun settings(archive: Archive): Settings {
        val present = archive.settings()
        val plan = if (smoke) Plan.SMOKE else if (quick) Plan.QUICK else Plan.FULL
        if (present != null) return present.copy(
            plan = plan, seed = seed ?: present.seed, slowdown = slowdown ?: present.slowdown, port = port,
        )
        val (factor, computer) =
            if (port == null) Calibration.slowdown(slowdown) else NOT_SLOWED to "those of a real robot are not slowed"
        return Settings(plan, seed ?: Random.nextInt(1, MAX_SEED).toLong(), factor, computer, port)
    }

    private companion object {
        const val FRONT = "dist(f,"
        const val ANSWER_LIMIT_MS = 500
        const val MAX_REQUESTS = 5
        const val BETWEEN_REQUESTS_MS = 200L
        const val NOT_SLOWED = 1.0
    }
}

/** Makes the runs of an experiment, until they are over or the user presses Ctrl-C. */
internal class Experiment(private val archive: Archive, private val settings: Settings, private val jobs: Int) {
    private val given = GivenUp()

    /** Makes the missing runs of [trials]; null: the user interrupted them. */
    fun run(trials: List<Trial>): List<Finished>? {
        val finished = attended(archive.directory, given) { show, punctuality ->
            Campaign(archive, settings, laboratory(punctuality), jobs, given) { show(it.words) }.run(trials)
        }
        if (!given.isUp) return finished
        println("interrupted after ${finished.size} of ${trials.size} runs; the same command with --out ${archive.directory} continues")
        return null
    }

    private fun laboratory(punctuality: Punctuality): Laboratory =
        settings.port?.let { port ->
            RealLaboratory(AgentHost(), port, Attendant(System.`in`.bufferedReader(), given) { println("\n$it") }::ready)
        } ?: SimulatedLaboratory(AgentHost(), punctuality, settings)
}
