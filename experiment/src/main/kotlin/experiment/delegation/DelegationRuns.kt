package experiment.delegation

import experiment.Archive
import experiment.GivenUp
import experiment.JSON
import experiment.Runs
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readText

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
