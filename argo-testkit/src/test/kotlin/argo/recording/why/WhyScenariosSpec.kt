package argo.recording.why

import argo.recording.replay.Recording
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.shouldBeGreaterThanOrEqual
import java.nio.file.Path

/**
 * In random scenarios with known causes, an answer names exactly the causing frames. Each of its counterfactuals holds in a new drive. The
 * property `argo.why.scenarios` sets the number of scenarios.
 */
class WhyScenariosSpec : FunSpec({
    val count = System.getProperty("argo.why.scenarios")?.toInt() ?: 8

    fun <T> asking(file: Path, ask: (Why) -> T): T = Recording(file).use { recording -> Why(recording).use(ask) }

    fun framesOf(file: Path) = Recording(file).use { recording ->
        val snapshots = recording.cycles("agent").flatMap { it.input.snapshots }.distinctBy { it.port to it.receivedNs }.toList()
        val firstNs = checkNotNull(recording.firstNs)
        val frames = snapshots.mapIndexed { place, it ->
            KnownFrame(it.port, phaseOf(it.texts), place + 1, (it.receivedNs - firstNs) / 1e9)
        }
        KnownFrames(frames)
    }

    test("the cause of $count scenarios") {
        val wrong = ArrayList<String>()
        val untrue = ArrayList<String>()
        var asked = 0
        var had = 0
        for (seed in 1..count) {
            val scenario = WhyScenario(seed)
            val file = scenario.record()
            val ones = framesOf(file)
            for (known in scenario.commands) {
                val command = asking(file) { why -> why.commands.find { it.text == known.text } }
                if ((command != null) != (known.phase != null)) {
                    wrong += "seed $seed, ${known.text}: sent ${command != null}, known ${known.phase}\n${scenario.program}"
                    continue
                }
                if (command == null) continue
                asked++
                val answer = asking(file) { it.answer(command) }
                val isRoot = answer.frame?.let(ones::cause).let { it == null && known.root == null || it != null && known.root in it }
                if (!isRoot || !ones.are(answer.frames, known.causes)) {
                    wrong += "seed $seed, ${known.text}: known ${known.causes} to ${known.root}\n${scenario.program}\n$answer"
                }
                for (one in answer.had) {
                    had++
                    val from = checkNotNull(answer.cause?.percepts()?.find { it.belief == one.replaced }?.frame).phase
                    val sent = scenario.sentWith(one.percept, from, checkNotNull(known.phase), command.seconds)
                    if (known.text in sent != one.isSent) untrue += "seed $seed, ${known.text}: $one, sent $sent\n${scenario.program}"
                }
            }
        }
        println("$count scenarios, $asked commands, ${wrong.size} wrong answers; $had counterfactuals, ${untrue.size} do not hold")
        (untrue + wrong).forEach(::println)
        withClue((untrue.take(3) + wrong.take(3)).joinToString("\n\n")) {
            (1 - wrong.size.toDouble() / asked) shouldBeGreaterThanOrEqual 0.99
            untrue.shouldBeEmpty()
        }
    }
})

/** A frame of the board on [port]. [seconds] is the time of its last byte. */
private class KnownFrame(val port: String, val phase: Int, val number: Int, val seconds: Double)

private class KnownFrames(private val all: List<KnownFrame>) {
    /** Returns the roles of [frame]: the first of its phase, the one with which a held-back percept passes, or both. */
    fun cause(frame: Frame): Set<CausingFrame> = setOfNotNull(
        CausingFrame(frame.namespace, frame.phase).takeIf { isFirst(frame) },
        CausingFrame(frame.namespace, frame.phase, isHeld = true).takeIf { isHeldUntil(frame) },
    )

    fun are(frames: List<Frame>, known: Set<CausingFrame>): Boolean {
        val causes = frames.map(::cause)
        return causes.all { it.any(known::contains) } && known.all { one -> causes.any { one in it } }
    }

    private fun isFirst(frame: Frame) = firstIn(frame.port, frame.phase)?.number == frame.number

    /**
     * Returns true if a percept passes with [frame] that was held back since the first frame of the phase before. The percept passes with
     * the newest frame at the end of the wait, or with the next frame.
     */
    private fun isHeldUntil(frame: Frame): Boolean {
        if (!ScenarioFilter.isLong(frame.phase)) return false
        val over = (firstIn(frame.port, frame.phase - 1) ?: return false).seconds + ScenarioFilter.EVERY_MS / 1e3
        val ofBoard = all.filter { it.port == frame.port }
        val newest = ofBoard.indexOfLast { it.seconds <= over }
        return ofBoard.subList(newest, minOf(newest + 2, ofBoard.size)).any { it.number == frame.number }
    }

    private fun firstIn(port: String, phase: Int) = all.find { it.port == port && it.phase == phase }
}
