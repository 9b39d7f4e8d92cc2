package experiment

import argo.tools.command.ExitStatus
import experiment.report.Provenance
import experiment.report.writeReport
import javino.PerceptsRequest
import javino.PortException
import javino.link.Link
import javino.link.LinkSettings
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension

@Command(
    name = "experiment",
    description = [
        "Makes the runs of the collision experiment that ARGO was published with and writes a report.",
        "81 runs for each condition: 3 filters, 3 limits, 3 intervals, 3 replications, in randomised order and in real time.",
        "With --quick they are 24: 2 limits, 2 intervals, 2 replications.",
        "Begun again with the same directory, it continues where it was interrupted.",
    ],
)
internal class ExperimentCommand : RunsCommand<Plan, Trial, Finished>(Plan.entries) {
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

    @Option(
        names = ["--port"], paramLabel = "device",
        description = ["the port of a real robot, such as ttyACM0 or COM5; you put the robot back before each run"],
    )
    override var port: String? = null

    private lateinit var conditions: List<Condition>

    override fun check() {
        if (port?.isBlank() == true) misuse("--port names no port")
        if (port != null && (jobs ?: 1) > 1) misuse("--jobs is for simulated robots, and --port asks for a real one")
        if (port != null && slowdown != null) misuse("--slowdown is for simulated robots, and --port asks for a real one")
        if (port != null && scaling) misuse("--scaling is for simulated robots, and --port asks for a real one")
        conditions = Condition.entries.filter { condition == "all" || condition == it.letter }
        if (conditions.isEmpty()) misuse("--condition is a, b, c, d or all, not $condition")
        port?.let {
            tryRobot(it)
            jobs = 1
        }
    }

    /** Asks the robot on [port] for percepts. A wrong port or robot is then refused before the user moves a robot. */
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

    /** Returns the robot's first answer with a front distance, since a sensor may need time. If no answer has it, returns the last one. */
    private fun firstSight(robot: Link): String {
        var answer = ""
        for (attempt in 1..MAX_REQUESTS) {
            answer = robot.request(PerceptsRequest.ALL, ANSWER_LIMIT_MS).text()
            if (FRONT in answer) break
            Thread.sleep(BETWEEN_REQUESTS_MS)
        }
        return answer
    }

    override fun archive(directory: Path) = collisionArchive(directory)

    /** Returns the published runs in random order, and then the runs with more sensors and other lines in random order. */
    override fun all(settings: Settings<Plan>): List<Trial> = randomised(conditions.flatMap(settings.plan::trials), settings.seed) +
        if (scaling) randomised(conditions.flatMap(settings.plan::scaling), settings.seed) else emptyList()

    override fun runs(archive: Archive<Plan, Finished>, settings: Settings<Plan>, punctuality: Punctuality, given: GivenUp) =
        CollisionRuns(archive, settings, laboratory(settings, punctuality, given))

    private fun laboratory(settings: Settings<Plan>, punctuality: Punctuality, given: GivenUp): Laboratory = settings.port?.let { port ->
        RealLaboratory(AgentHost(), port, Attendant(System.`in`.bufferedReader(), given) { println("\n$it") }::ready)
    } ?: SimulatedLaboratory(AgentHost(), punctuality, settings)

    override fun report(archive: Archive<Plan, Finished>, settings: Settings<Plan>, made: Provenance): Path =
        writeReport(archive.directory, settings, archive.finished(), made)

    override fun status(over: List<Finished>): Int {
        val failed = over.filter { it.result.outcome == Outcome.FAILED }
        failed.forEach { println("${it.trial.id} failed: ${it.result.reason}") }
        return if (failed.isEmpty()) ExitStatus.DONE else ExitStatus.FAILED
    }

    private companion object {
        const val FRONT = "dist(f,"
        const val ANSWER_LIMIT_MS = 500
        const val MAX_REQUESTS = 5
        const val BETWEEN_REQUESTS_MS = 200L
    }
}

internal fun collisionArchive(directory: Path): Archive<Plan, Finished> = Archive(directory, Plan.serializer(), ::finishedIn)

private fun finishedIn(file: Path): Finished? {
    val record = readRecord(file) ?: return null
    val trial = (record.first() as Entry.Begin).trial
    return if (trial.id == file.nameWithoutExtension) Finished(trial, record.last() as Entry.Result) else null
}

/** The runs of the collision experiment with these [settings]. [laboratory] makes the runs. [archive] stores their records. */
internal class CollisionRuns(
    private val archive: Archive<Plan, Finished>, private val settings: Settings<Plan>, private val laboratory: Laboratory,
) : Runs<Trial, Finished> {
    override fun finished() = archive.finished().filter { it.result.outcome != Outcome.FAILED }.associateBy { it.trial }

    override fun make(run: Trial, given: GivenUp): Finished? = RecordWriter(archive.file(run.id)).use { record ->
        record.write(Entry.Begin(run, settings))
        laboratory.run(run, record, given)?.also(record::write).also { record.requireWhole() }?.let { Finished(run, it) }
    }

    override fun isLate(made: Finished) = made.isLate

    /** Estimates the time until the robot is a little past the limit. If a collision is expected, estimates the time until the wall. */
    override fun expectedMs(run: Trial): Long {
        val hits = run.condition == Condition.PUBLISHED && run.view == View.NONE
        return 1_000L + (200 - if (hits) 0 else run.limit) * 100L
    }

    override fun facts(over: Collection<Finished>) = listOf("${over.count { it.result.outcome == Outcome.COLLIDED }} at the wall")
}
