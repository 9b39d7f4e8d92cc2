package argo.recording.why

import argo.recording.replay.Recording
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.shouldBeGreaterThanOrEqual
import java.nio.file.Path

/**
 * In generated scenarios whose cause is known, the answer names the frames that are the cause and no other, and each counterfactual in it
 * holds when the agent is driven so. The property `argo.why.scenarios` is how many are asked about.
 */
class WhyScenariosSpec : FunSpec({
    val count = System.getProperty("argo.why.scenarios")?.toInt() ?: 50

    /** These [frames], which the answer sees as the cause; one that is not the [first] of its phase has the phase -1. */
    fun causes(frames: List<Frame>, first: Set<Int>) =
        frames.map { CausingFrame(it.namespace, if (it.number in first) it.phase else -1) }.toSet()

    fun <T> asking(file: Path, ask: (Why) -> T): T = Recording(file).use { recording -> Why(recording).use(ask) }

    /** The numbers of the first frame of each board in each phase that was perceived. */
    fun firstFrames(file: Path): Set<Int> = Recording(file).use { recording ->
        recording.cycles("agent").flatMap { it.input.snapshots }.toList()
            .mapIndexed { place, it -> Triple(it.port, it.texts.first { "phase(" in it }, place + 1) }
            .distinctBy { (port, phase, _) -> port to phase }.map { it.third }.toSet()
    }

    test("the cause of $count scenarios") {
        val wrong = ArrayList<String>()
        val untrue = ArrayList<String>()
        var asked = 0
        var had = 0
        for (seed in 1..count) {
            val scenario = WhyScenario(seed)
            val file = scenario.record()
            val first = firstFrames(file)
            for (known in scenario.commands) {
                val command = asking(file) { why -> why.commands.find { it.text == known.text } }
                if ((command != null) != (known.phase != null)) {
                    wrong += "seed $seed, ${known.text}: sent ${command != null}, known ${known.phase}\n${scenario.program}"
                    continue
                }
                if (command == null) continue
                asked++
                val answer = asking(file) { it.answer(command) }
                val named = causes(answer.frames, first) to answer.frame?.let { causes(listOf(it), first).single() }
                if (named != known.causes to known.root) {
                    wrong += "seed $seed, ${known.text}: named $named, known ${known.causes} to ${known.root}\n${scenario.program}\n$answer"
                }
                for (one in answer.had) {
                    had++
                    val from = answer.frames.first { frame -> frame.texts.any { inSpace(frame.namespace, it) == one.replaced } }.phase
                    val sent = scenario.sentWith(one.percept, from, checkNotNull(known.phase), command.seconds)
                    if (known.text in sent != one.isSent) untrue += "seed $seed, ${known.text}: $one, sent $sent\n${scenario.program}"
                }
            }
        }
        println("$count scenarios, $asked commands, ${wrong.size} wrong answers; $had counterfactuals, ${untrue.size} do not hold")
        withClue((untrue.take(3) + wrong.take(3)).joinToString("\n\n")) {
            (1 - wrong.size.toDouble() / asked) shouldBeGreaterThanOrEqual 0.99
            untrue.shouldBeEmpty()
        }
    }
})
