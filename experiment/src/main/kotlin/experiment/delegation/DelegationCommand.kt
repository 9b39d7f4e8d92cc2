package experiment.delegation

import experiment.AgentHost
import experiment.Archive
import experiment.GivenUp
import experiment.JSON
import experiment.Punctuality
import experiment.Runs
import experiment.RunsCommand
import experiment.Settings
import experiment.report.Provenance
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import picocli.CommandLine.Command
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readText

@Command(
    name = "delegation",
    description = [
        "Measures whether one agent reacts faster to its sensors, or several that share the work, and writes a report.",
        "Each of five blocks of runs has each of 144 combinations of the factors once, in random order and in real time.",
        "With --quick they are three blocks of 32 runs.",
        "Begun again with the same directory, it continues where it was interrupted.",
    ],
)
internal class DelegationCommand : RunsCommand<DelegationPlan, DelegationRun, Measured>(DelegationPlan.entries) {
    override fun check() {
        val ignored = spec.commandLine().parent.parseResult.matchedOptions().map { it.longestName() }
        if (ignored.isNotEmpty()) misuse("options of the experiment on delegation stand behind its name, not ${ignored.joinToString()}")
    }

    override fun archive(directory: Path) = delegationArchive(directory)

    override fun all(settings: Settings<DelegationPlan>): List<DelegationRun> = settings.plan.runs(settings.seed)

    override fun runs(
        archive: Archive<DelegationPlan, Measured>, settings: Settings<DelegationPlan>, punctuality: Punctuality, given: GivenUp,
    ): Runs<DelegationRun, Measured> {
        val laboratory = DelegationLaboratory(AgentHost(), punctuality, settings.seed, settings.slowdown)
        Design.entries.forEach { laboratory.run(DelegationRun(0, settings.plan.loads.last(), it), given) } // warms up Java
        return DelegationRuns(archive, laboratory)
    }

    override fun report(archive: Archive<DelegationPlan, Measured>, settings: Settings<DelegationPlan>, made: Provenance): Path =
        writeDelegationReport(archive.directory, settings, archive.finished(), made)
}

@Serializable
internal data class Measured(val run: DelegationRun, val result: DelegationResult)

internal fun delegationArchive(directory: Path): Archive<DelegationPlan, Measured> =
    Archive(directory, DelegationPlan.serializer(), ::measuredIn)

private fun measuredIn(file: Path): Measured? = try {
    JSON.decodeFromString(Measured.serializer(), file.readText()).takeIf { it.run.id == file.nameWithoutExtension }
} catch (_: SerializationException) {
    null // the line is incomplete, or another version of this program wrote it
}

/** The runs of the experiment. [laboratory] makes the runs. [archive] stores their records. */
internal class DelegationRuns(
    private val archive: Archive<DelegationPlan, Measured>, private val laboratory: DelegationLaboratory,
) : Runs<DelegationRun, Measured> {
    override fun finished() = archive.finished().associateBy { it.run }

    override fun make(run: DelegationRun, given: GivenUp): Measured? {
        val file = archive.file(run.id)
        Files.deleteIfExists(file) // removes an earlier try, which was late, in case this try is aborted
        val measured = laboratory.run(run, given)?.let { Measured(run, it) } ?: return null
        Files.writeString(file, JSON.encodeToString(Measured.serializer(), measured) + "\n")
        return measured
    }

    override fun isLate(made: Measured) = made.result.isLate

    override fun expectedMs(run: DelegationRun) = DelegationLaboratory.EXPECTED_MS
}
