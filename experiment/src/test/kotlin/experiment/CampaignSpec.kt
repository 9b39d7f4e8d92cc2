package experiment

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeInstanceOf
import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.ConcurrentLinkedQueue
import kotlin.io.path.appendText
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.writeText

internal val SETTINGS = Settings(Plan.QUICK, seed = 3, slowdown = 5.0, computer = "of a test")

internal fun stopped(
    distance: Double = 39.0, sinceLimitMs: Double = 100.0, lateMs: Double = 0.0, sincePerceivingMs: Double = sinceLimitMs,
) = Entry.Result(Outcome.STOPPED, distance, sinceLimitMs, sincePerceivingMs, commands = 2, frames = 4, lateMs = lateMs)

internal fun collided(ms: Double) = Entry.Result(Outcome.COLLIDED, 0.0, ms, ms, commands = 9, frames = 9, lateMs = 0.0)

private val FULL = Path.of("/dev/full")

class CampaignSpec : FunSpec({
    val trials = Plan.QUICK.trials(Condition.DEFAULTS).take(6)

    fun archive() = collisionArchive(tempdir().toPath().resolve("x")).apply { open(SETTINGS) }

    fun campaign(
        archive: Archive<Plan, Finished> = archive(),
        given: GivenUp = GivenUp(),
        jobs: Int = 2,
        report: (Campaign.Status) -> Unit = {},
        laboratory: Laboratory,
    ) = Campaign(CollisionRuns(archive, SETTINGS, laboratory), jobs, given, report)

    fun expectedMs(trials: List<Trial>): Long = CollisionRuns(archive(), SETTINGS) { _, _, _ -> null }.let { trials.sumOf(it::expectedMs) }

    test("each run is made once and recorded, whatever the number of robots") {
        val archive = archive()
        val made = ConcurrentLinkedQueue<Trial>()
        val over = campaign(archive) { trial, record, _ ->
            made += trial
            record.write(Entry.Command(5, "front", 200.0))
            stopped()
        }.run(trials)
        made shouldContainExactlyInAnyOrder trials
        over.map { it.trial } shouldContainExactlyInAnyOrder trials
        readRecord(archive.file(trials.first().id)) shouldBe
            listOf(Entry.Begin(trials.first(), SETTINGS), Entry.Command(5, "front", 200.0), stopped())
    }

    test("an experiment that was given up is continued, not repeated") {
        val archive = archive()
        val given = GivenUp()
        val made = ConcurrentLinkedQueue<Trial>()
        val laboratory = Laboratory { trial, record, _ ->
            made += trial
            record.write(Entry.Command(5, "front", 200.0))
            if (made.size > 3) given.giveUp()
            if (given.isUp) null else stopped()
        }
        val before = campaign(archive, given, laboratory = laboratory).run(trials)
        before.size shouldBe made.size - trials.count { it in made && it !in before.map(Finished::trial) }
        // checks that all lines are whole
        trials.map { archive.file(it.id) }.filter { it.exists() }.flatMap { it.readLines() }.forEach {
            JSON.decodeFromString(Entry.serializer(), it)
        }
        val again = ConcurrentLinkedQueue<Trial>()
        val after = campaign(archive) { trial, _, _ -> again.add(trial).let { stopped() } }.run(trials)
        again shouldContainExactlyInAnyOrder trials - before.map { it.trial }.toSet()
        after shouldHaveSize trials.size
    }

    test("a record that was cut off in the middle of a line does not count, and its run is made anew") {
        val archive = archive()
        campaign(archive) { _, _, _ -> stopped() }.run(trials)
        val cut = archive.file(trials[2].id)
        cut.writeText(cut.readText().dropLast(7))
        archive.finished().map { it.trial } shouldContainExactlyInAnyOrder trials - trials[2]
        val again = ConcurrentLinkedQueue<Trial>()
        campaign(archive) { trial, _, _ -> again.add(trial).let { stopped() } }.run(trials)
        again.toList() shouldBe listOf(trials[2])
        archive.finished() shouldHaveSize trials.size
    }

    test("so is one that lacks its last line, and one that belongs to another run") {
        val archive = archive()
        campaign(archive) { _, _, _ -> stopped() }.run(trials)
        archive.file(trials[0].id).writeText(archive.file(trials[0].id).readLines().first() + "\n")
        archive.file(trials[1].id).writeText(archive.file(trials[2].id).readText())
        archive.file(trials[3].id).writeText("")
        archive.file(trials[4].id).appendText("nonsense\n")
        archive.finished().map { it.trial } shouldContainExactlyInAnyOrder listOf(trials[2], trials[5])
        archive.unusable() shouldBe 4
    }

    test("a run that has failed is made anew when the experiment is continued") {
        val archive = archive()
        campaign(archive) { _, _, _ -> stopped().copy(outcome = Outcome.FAILED, reason = "the board has gone") }.run(trials)
        val again = ConcurrentLinkedQueue<Trial>()
        campaign(archive) { trial, _, _ -> again.add(trial).let { stopped() } }.run(trials)
        again shouldHaveSize trials.size
    }

    test("a run in which the machine was late is made anew, three times at most") {
        val archive = archive()
        val made = ConcurrentLinkedQueue<Trial>()
        val campaign = campaign(archive) { trial, _, _ ->
            stopped(lateMs = if (trial == trials[0] || made.add(trial) && made.count { it == trial } == 1) 500.0 else 1.0)
        }
        val over = campaign.run(trials).associate { it.trial to it.result.lateMs }
        over.getValue(trials[0]) shouldBe 500.0
        (over - trials[0]).values.toSet() shouldBe setOf(1.0)
        campaign.repetitions shouldBe 2 + 5
    }

    test("the machine may be late by a third of an exchange, which is shorter in version 2") {
        maxLateMs(Condition.PUBLISHED) shouldBe (56.25 plusOrMinus 0.01)
        maxLateMs(Condition.DEFAULTS) shouldBe maxLateMs(Condition.PUBLISHED)
        listOf(Condition.VERSION_2, Condition.REFLEX).forEach { maxLateMs(it) shouldBeLessThan 30.0 }
    }

    test("a full disk ends the experiment, and what was recorded before is kept").config(enabled = FULL.exists()) {
        val archive = archive()
        val laboratory = Laboratory { trial, record, _ ->
            record.write(Entry.Command(5, "front", 200.0))
            if (trial == trials[2]) archive.file(trials[3].id).createSymbolicLinkPointingTo(FULL) // fills the disk for the next run
            stopped()
        }
        val refused = shouldThrow<IOException> { campaign(archive, jobs = 1, laboratory = laboratory).run(trials) }
        archive.file(trials[3].id).deleteExisting()
        refused.message shouldContain "${trials[3].id}.jsonl cannot be written: "
        archive.finished().map { it.trial } shouldContainExactlyInAnyOrder trials.take(3)
    }

    test("an experiment that ends for a reason nobody has thought of does not go on in its other robots") {
        val given = GivenUp()
        val made = ConcurrentLinkedQueue<Trial>()
        shouldThrow<IllegalStateException> {
            campaign(archive(), given) { trial, _, _ ->
                made += trial
                if (trial == trials[1]) error("a fault")
                given.await(10_000)
                null
            }.run(trials)
        }
        made.size shouldBe 2
    }

    test("two experiments in one directory at once are refused, one after the other are not") {
        val first = archive()
        val second = collisionArchive(first.directory)
        shouldThrow<ContinuationException> { second.open(SETTINGS) }
            .message shouldContain "an experiment is being made in ${first.directory} right now"
        first.close()
        second.open(SETTINGS)
        second.close()
    }

    test("other settings are refused with what differs") {
        val archive = archive()
        val refused = shouldThrow<ContinuationException> { archive.open(SETTINGS.copy(seed = 4, plan = Plan.FULL)) }
        refused.message shouldContain "the plan is quick there and full was asked for, the seed is 3 there and 4 was asked for"
        refused.message shouldContain "--out"
    }

    test("settings that cannot be read are refused, not overwritten") {
        val archive = archive()
        archive.directory.resolve("settings.json").writeText("{")
        shouldThrow<ContinuationException> { archive.settings() }.message shouldContain "settings.json cannot be read"
    }

    test("an empty directory holds no runs") {
        collisionArchive(tempdir().toPath()).finished().shouldBeEmpty()
    }

    test("what comes after a record was closed is not in it") {
        val file = tempdir().toPath().resolve("record.jsonl")
        val record = RecordWriter(file)
        record.write(Entry.Begin(trials[0], SETTINGS))
        record.close()
        record.write(stopped())
        file.readLines().map { JSON.decodeFromString(Entry.serializer(), it) }.single().shouldBeInstanceOf<Entry.Begin>()
    }

    test("what a board still says when its run is over is not in the record") {
        val file = tempdir().toPath().resolve("record.jsonl")
        RecordWriter(file).use { record ->
            record.write(Entry.Begin(trials[0], SETTINGS))
            record.write(stopped())
            record.write(Entry.Frame(1, "dist(f,39)", 39.0))
        }
        readRecord(file)?.last() shouldBe stopped()
    }

    test("how far it has come is told with the runs at the wall and the time left") {
        val told = ConcurrentLinkedQueue<Campaign.Status>()
        campaign(jobs = 1, report = told::add) { _, _, _ -> stopped().copy(outcome = Outcome.COLLIDED) }.run(trials)
        told.first() shouldBe Campaign.Status(0, 6, expectedMs(trials), facts = listOf("0 at the wall"))
        told.last() shouldBe Campaign.Status(6, 6, 0, facts = listOf("6 at the wall"))
    }

    test("runs that the machine was too late for are told while they are repeated") {
        val told = ConcurrentLinkedQueue<Campaign.Status>()
        campaign(jobs = 1, report = told::add) { _, _, _ -> stopped(lateMs = 500.0) }.run(trials.take(1))
        told.last().words shouldBe listOf("run 1 of 1", "0 at the wall", "2 repeated: machine late")
    }

    test("the time left expects that runs go on being repeated") {
        val told = ConcurrentLinkedQueue<Campaign.Status>()
        campaign(jobs = 1, report = told::add) { _, _, _ -> stopped(lateMs = 500.0) }.run(trials)
        told.elementAt(1).left shouldBe 3 * expectedMs(trials.drop(1))
    }

    test("the time left is told in whole minutes, and never as none while there are runs") {
        fun words(done: Int, seconds: Long) = Campaign.Status(done, 81, seconds * 1000, facts = listOf("5 at the wall")).words
        words(0, 1000) shouldBe listOf("run 0 of 81", "5 at the wall", "about 17 min left")
        listOf(69L, 68, 39, 38, 1, 0).map { words(77, it).last() } shouldBe listOf(
            "about 2 min left", "about 1 min left", "about 1 min left", "less than a minute left", "less than a minute left",
            "the last 4 runs",
        )
        words(80, 0).last() shouldBe "the last run"
        words(81, 0) shouldBe listOf("run 81 of 81", "5 at the wall")
    }
})
