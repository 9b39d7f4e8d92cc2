package experiment

import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.requireWithin
import experiment.report.Provenance
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import samples.project.Logs
import samples.project.Progress
import sun.misc.Signal
import java.io.IOException
import java.io.PrintStream
import java.nio.file.AccessDeniedException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.time.Instant
import kotlin.random.Random

/**
 * A command that makes the runs [T] of an experiment and reports the finished runs [R].
 *
 * @param plans the plans [P] in this order: full, quick, shortest
 */
@Command(
    exitCodeListHeading = "%nExit status:%n",
    exitCodeList = [
        "0:all runs are made", "1:some have failed, or a record could not be written", "2:wrong arguments",
        "130:interrupted; the same command continues",
    ],
    sortOptions = false,
)
internal abstract class RunsCommand<P, T, R : Any>(private val plans: List<P>) : ToolCommand() {
    @Option(names = ["--quick"], description = ["fewer runs, for some minutes"])
    private var quick = false

    @Option(names = ["--smoke"], hidden = true, description = ["the shortest plan, to try the program"])
    private var smoke = false

    @Option(names = ["--jobs"], paramLabel = "N", description = ["runs at once (default: two for each processor)"])
    protected var jobs: Int? = null

    @Option(
        names = ["--seed"], paramLabel = "S",
        description = ["the seed for the order of the runs and for chance in them (default: random)"],
    )
    private var seed: Long? = null

    @Option(
        names = ["--slowdown"], paramLabel = "X",
        description = [
            "how many times slower than this computer the agents of simulated robots reason, at least 1 " +
                "(default: measured, as slow as a Raspberry Pi 3 of 2016)",
        ],
    )
    protected var slowdown: Double? = null

    @Option(
        names = ["--out"], paramLabel = "DIR",
        description = ["where records and report go (default: experiment-results, of delegation delegation-results)"],
    )
    private var directory: Path? = null

    private val name get() = spec.name().substringAfterLast(' ') // without the user's words before it

    /** The port of a real robot, or null for simulated robots. */
    protected open val port: String? get() = null

    protected abstract fun check()

    protected abstract fun archive(directory: Path): Archive<P, R>

    protected abstract fun all(settings: Settings<P>): List<T>

    /** Returns the runs for a campaign. [punctuality] gives the delay of this machine in each run. */
    protected abstract fun runs(archive: Archive<P, R>, settings: Settings<P>, punctuality: Punctuality, given: GivenUp): Runs<T, R>

    protected abstract fun report(archive: Archive<P, R>, settings: Settings<P>, made: Provenance): Path

    protected open fun status(over: List<R>): Int = ExitStatus.DONE

    override fun call(): Int {
        jobs?.let { spec.requireWithin("--jobs", it, 1..MAX_JOBS) }
        slowdown?.let { if (!(it in 1.0..MAX_SLOWDOWN)) misuse("--slowdown is from 1 to ${MAX_SLOWDOWN.toInt()}, not $it") }
        check()
        return archive(directory ?: Path.of("$name-results")).use(::make)
    }

    private fun make(archive: Archive<P, R>): Int {
        val settings = opened(archive)
        val speed = if (port == null) "${settings.slowdown} times slower than here" else "as fast as they can"
        println("seed ${settings.seed}; agents reason $speed (${settings.computer})")
        val unusable = archive.unusable()
        if (unusable > 0) println("made anew, since their records are incomplete, damaged or of another version of ARGO: $unusable runs")
        return try {
            make(archive, settings)
        } catch (unwritable: IOException) {
            val remedy = "The records are kept: make room, and the same command with --out ${archive.directory} continues"
            err.println("$name: ${unwritable.message}. $remedy")
            ExitStatus.FAILED
        }
    }

    private fun opened(archive: Archive<P, R>): Settings<P> = try {
        settings(archive.settings()).also(archive::open)
    } catch (refused: ContinuationException) {
        misuse(refused.message.orEmpty())
    } catch (unwritable: IOException) {
        misuse("--out ${archive.directory} cannot be written to: ${words(unwritable)}")
    }

    private fun words(unwritable: IOException): String? = // the message of the one exception is only a file's name
        if (unwritable is AccessDeniedException) "this user has no permission for ${unwritable.file}" else unwritable.message

    /**
     * Returns the settings of the [present] experiment with the user's changes. If [present] is null, returns the settings of a new
     * experiment.
     */
    private fun settings(present: Settings<P>?): Settings<P> {
        val plan = plans[if (smoke) 2 else if (quick) 1 else 0]
        if (present != null) {
            return present.copy(plan = plan, seed = seed ?: present.seed, slowdown = slowdown ?: present.slowdown, port = port)
        }
        val (factor, computer) =
            if (port == null) Calibration.slowdown(slowdown) else NOT_SLOWED to "those of a real robot are not slowed"
        return Settings(plan, seed ?: Random.nextInt(1, MAX_SEED).toLong(), factor, computer, port)
    }

    private fun make(archive: Archive<P, R>, settings: Settings<P>): Int {
        val all = all(settings)
        val atOnce = jobs ?: (2 * Runtime.getRuntime().availableProcessors())
        val given = GivenUp()
        val over = attended(archive.directory, given) { show, punctuality ->
            Campaign(runs(archive, settings, punctuality, given), atOnce, given) { show(it.words) }.run(all)
        }
        if (given.isUp) {
            println("interrupted after ${over.size} of ${all.size} runs; the same command with --out ${archive.directory} continues")
            return INTERRUPTED
        }
        println("report: ${report(archive, settings, Provenance(build(), Instant.now(), machine("At most $atOnce runs at once")))}")
        return status(over)
    }

    private companion object {
        const val INTERRUPTED = 130
        const val MAX_JOBS = 256
        const val MAX_SLOWDOWN = 1000.0
        const val MAX_SEED = 1_000_000
        const val NOT_SLOWED = 1.0
    }
}

/**
 * Does [work]. The parameter `show` of [work] writes a line of progress. The log of Jason, ARGO and the agents is written to `log.txt` in
 * [directory]. Ctrl-C aborts the experiment through [given].
 */
internal fun <T> attended(directory: Path, given: GivenUp, work: (show: (List<String>) -> Unit, punctuality: Punctuality) -> T): T {
    val progress = Progress.onStandardOutput()
    listOf("INT", "TERM").forEach { Signal.handle(Signal(it)) { given.giveUp() } }
    val begin = System.nanoTime()
    val file = Files.newOutputStream(directory.resolve("log.txt"), StandardOpenOption.CREATE, StandardOpenOption.APPEND)
    try {
        return PrintStream(file, true, Charsets.UTF_8).use { log ->
            Logs.to(log)
            Punctuality().use { work({ facts -> progress.show(facts, System.nanoTime() - begin) }, it) }
        }
    } finally {
        progress.end()
    }
}

/** Describes this machine for a report. [atOnce] is the number of simultaneous runs, in words. */
internal fun machine(atOnce: String): String =
    listOf("os.name", "os.arch", "java.vm.name", "java.version").joinToString(" ", transform = System::getProperty)
        .let { "$atOnce on ${Runtime.getRuntime().availableProcessors()} processors, $it." }

/** Returns the version and the commit of ARGO. A program without a jar takes them from the property `argo.build`. */
internal fun build(): String =
    System.getProperty("argo.build") ?: Punctuality::class.java.`package`.implementationVersion ?: "of an unknown version"
