package experiment.delegation

import argo.tools.command.ToolCommand
import argo.tools.command.requireWithin
import experiment.AgentHost
import experiment.Calibration
import experiment.ContinuationException
import experiment.GivenUp
import experiment.INTERRUPTED
import experiment.MAX_JOBS
import experiment.MAX_SEED
import experiment.MAX_SLOWDOWN
import experiment.attended
import experiment.build
import experiment.inParallel
import experiment.machine
import experiment.punctual
import experiment.report.Provenance
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import java.io.IOException
import java.nio.file.Path
import java.time.Instant
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.atomic.AtomicInteger
import kotlin.random.Random

@Command(
    name = "delegation",
    description = [
        "Measures whether one agent reacts faster to its sensors, or several that share the work, and writes a report.",
        "Each block of runs has each combination of the factors once, in random order and in real time.",
        "Begun again with the same directory, it continues where it was interrupted.",
    ],
    exitCodeListHeading = "%nExit status:%n",
    exitCodeList = ["0:all runs are made", "1:a record could not be written", "2:wrong arguments", "130:interrupted"],
    sortOptions = false,
)
internal class DelegationCommand : ToolCommand() {
    @Option(names = ["--quick"], description = ["three blocks of 32 runs in place of five blocks of 144"])
    private var quick = false

    @Option(names = ["--smoke"], hidden = true, description = ["the shortest plan, to try the program"])
    private var smoke = false

    @Option(names = ["--jobs"], paramLabel = "N", description = ["runs at once (default: two for each processor)"])
    private var jobs = 2 * Runtime.getRuntime().availableProcessors()

    @Option(names = ["--seed"], paramLabel = "S", description = ["the seed for the order of the runs and the stimuli (default: random)"])
    private var seed: Long? = null

    @Option(
        names = ["--slowdown"], paramLabel = "X",
        description = ["how many times slower than this computer the agents reason, at least 1 (default: measured, as for the experiment)"],
    )
    private var slowdown: Double? = null

    @Option(
        names = ["--out"], paramLabel = "DIR", defaultValue = "delegation-results",
        description = ["where records and report go (default: \${DEFAULT-VALUE})"],
    )
    private lateinit var directory: Path

    override fun call(): Int {
        val ignored = spec.commandLine().parent.parseResult.matchedOptions().map { it.longestName() }
        if (ignored.isNotEmpty()) misuse("options of the experiment on delegation stand behind its name, not ${ignored.joinToString()}")
        spec.requireWithin("--jobs", jobs, 1..MAX_JOBS)
        slowdown?.let { if (!(it in 1.0..MAX_SLOWDOWN)) misuse("--slowdown is from 1 to ${MAX_SLOWDOWN.toInt()}, not $it") }
        return DelegationRecords(directory).use(::make)
    }

    private fun make(records: DelegationRecords): Int {
        val settings = opened(records)
        println("seed ${settings.seed}; agents reason ${settings.slowdown} times slower than here (${settings.computer})")
        return try {
            make(records, settings)
        } catch (unwritable: IOException) {
            err.println("delegation: $unwritable. The records are kept: make room, and the same command with --out $directory continues")
            1
        }
    }

    private fun opened(records: DelegationRecords): DelegationSettings = try {
        val settings = settings(records.settings())
        val damaged = records.open(settings)
        if (damaged > 0) println("made anew, since their records are damaged or of another version of ARGO: $damaged runs")
        settings
    } catch (refused: ContinuationException) {
        misuse(refused.message.orEmpty())
    } catch (unwritable: IOException) {
        misuse("--out $directory cannot be written to: $unwritable")
    }

    private fun settings(present: DelegationSettings?): DelegationSettings {
        val plan = if (smoke) DelegationPlan.SMOKE else if (quick) DelegationPlan.QUICK else DelegationPlan.FULL
        if (present == null) {
            val (factor, computer) = Calibration.slowdown(slowdown)
            return DelegationSettings(plan, seed ?: Random.nextInt(1, MAX_SEED).toLong(), factor, computer)
        }
        val asked = present.copy(plan = plan, seed = seed ?: present.seed, slowdown = slowdown ?: present.slowdown)
        if (asked != present) misuse(
            "$directory holds the plan ${present.plan.name.lowercase()} with --seed ${present.seed} and --slowdown ${present.slowdown}. " +
                "Continue it with the same, or choose another directory with --out",
        )
        return present
    }

    private fun make(records: DelegationRecords, settings: DelegationSettings): Int {
        val given = GivenUp()
        val all = settings.plan.runs(settings.seed)
        attended(directory, given) { show, punctuality ->
            val laboratory = DelegationLaboratory(AgentHost(), punctuality, settings.seed, settings.slowdown)
            val missing = ConcurrentLinkedQueue(all - records.finished.map { it.run }.toSet())
            val repeated = AtomicInteger()
            Design.entries.forEach { laboratory.run(DelegationRun(0, settings.plan.loads.last(), it), given) } // compiles the programs
            inParallel(jobs, given) {
                while (!given.isUp) {
                    show(words(records.finished.size, all.size, repeated.get()))
                    val run = missing.poll() ?: break
                    punctual(DelegationResult::isLate, repeated::incrementAndGet) { laboratory.run(run, given) }
                        ?.let { records.add(Measured(run, it)) }
                }
            }
        }
        if (given.isUp) {
            println("interrupted after ${records.finished.size} of ${all.size} runs; the same command with --out $directory continues")
            return INTERRUPTED
        }
        val made = Provenance(build(), Instant.now(), machine("At most $jobs runs at once"))
        println("report: ${writeDelegationReport(directory, settings, records.finished, made)}")
        return 0
    }

    private fun words(done: Int, all: Int, repeated: Int): List<String> {
        val left = (all - done) * DelegationLaboratory.EXPECTED_MS / jobs / 60_000
        return listOfNotNull(
            "run $done of $all", "$repeated repeated: machine late".takeIf { repeated > 0 }, "about ${left + 1} min left",
        )
    }
}
