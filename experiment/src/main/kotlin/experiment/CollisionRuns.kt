package experiment

import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension

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
