package argo.recording

import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.WhatIf
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.longs.shouldBeGreaterThan
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.deleteIfExists

/**
 * Faulty drives of the samples and the experiment's agent are replayed exactly: events, plans, steps, commands and messages. A free run of
 * a program on the recorded inputs sends equal commands. The property `argo.drives` sets the number of drives.
 */
class SeededDrivesSpec : FunSpec({
    val folder = tempdir().toPath()
    val drives = Integer.getInteger("argo.drives", 9)
    val systems = SeededDrives.ALL

    fun differenceOf(file: Path): String? = try {
        val outcome = replayOf(file)
        outcome.cycles shouldBeGreaterThan 0L
        outcome.differences.firstOrNull()?.toString()
            ?: "${outcome.recorded - outcome.cycles} cycles were not run".takeIf { outcome.cycles != outcome.recorded.toLong() }
    } catch (refused: RecordingException) {
        "$refused"
    }

    /** Returns the first different command of a free run on the recorded inputs, or null if there is none. */
    fun differenceOfCommands(file: Path): String? = Recording(file).use { recording ->
        recording.agents.keys.firstNotNullOfOrNull { agent ->
            WhatIf(recording, agent).use { it.run().difference(Duration.ZERO) }?.let { "agent $agent sends others: $it" }
        }
    }

    for ((index, system) in systems.withIndex()) test("drives of $system") {
        val seeds = (index until drives step systems.size).map(Int::toLong)
        seeds.mapNotNull { seed ->
            val file = folder.resolve("$seed.mcap")
            system.record(seed, file)
            (differenceOf(file) ?: differenceOfCommands(file))?.let { "seed $seed: $it" }.also { file.deleteIfExists() }
        }.shouldBeEmpty()
    }
})
