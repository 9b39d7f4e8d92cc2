package argo.recording

import argo.recording.replay.Recording
import argo.recording.replay.WhatIf
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.deleteIfExists

/**
 * Faulty drives of the samples and the experiment's agent lose all but their last seconds. The rest of each drive is replayed exactly, from
 * a key frame on. The property `argo.rings` sets the number of shortened recordings.
 */
@Tags("Thorough")
class SeededRingsSpec : FunSpec({
    val folder = tempdir().toPath()
    val drives = Integer.getInteger("argo.rings", 18)
    val systems = SeededDrives.ALL
    val from = HashMap<String, Int>() // the number of replays by their start

    /** Returns the start of the replay of [ring]: the first cycle, a key frame, or none. */
    fun beginningOf(ring: Path): String = Recording(ring).use { recording ->
        val beginnings = recording.agents.keys.map { agent ->
            val isWhole = (recording.cycles(agent).firstOrNull()?.index ?: 1) == 1L
            if (isWhole) "first cycle" else if (recording.start(agent) == null) "nowhere" else "key frame"
        }
        listOf("nowhere", "key frame", "first cycle").first { it in beginnings }
    }

    fun differenceOf(ring: Path): String? = Recording(ring).use { recording ->
        val outcome = replayOf(ring)
        outcome.differences.firstOrNull()?.toString()
            ?: recording.agents.keys.firstNotNullOfOrNull { agent ->
                WhatIf(recording, agent).use { it.run().difference(Duration.ZERO) }?.let { "agent $agent sends others: $it" }
            }
    }

    for ((index, system) in systems.withIndex()) test("the last seconds of drives of $system") {
        (index until drives step systems.size).map(Int::toLong).mapNotNull { seed ->
            val file = folder.resolve("$seed.mcap")
            system.record(seed, file)
            val ring = ringOf(file, Duration.ofSeconds(6))
            val beginning = beginningOf(ring)
            from.merge(beginning, 1, Int::plus)
            val difference = if (beginning == "nowhere") null else differenceOf(ring)
            listOf(file, ring).forEach { it.deleteIfExists() }
            difference?.let { "seed $seed: $it" }
        }.shouldBeEmpty()
    }

    test("nearly all that have lost their beginning have a key frame") {
        val replayed = from["key frame"] ?: 0
        replayed shouldBeGreaterThan drives / 4
        (from["nowhere"] ?: 0) * 8 shouldBeLessThan replayed
    }
})
