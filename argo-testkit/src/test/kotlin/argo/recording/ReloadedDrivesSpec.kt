package argo.recording

import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import jason.asSemantics.Agent
import jason.asSyntax.Plan
import java.io.StringReader
import java.nio.file.Path
import kotlin.io.path.deleteIfExists
import kotlin.io.path.writeText
import kotlin.random.Random
import kotlin.time.Duration.Companion.milliseconds

/**
 * Random programs get random new texts at random times, while a board is sensed at 50 Hz. No plan is lost or doubled, no intention is lost,
 * and each drive is replayed exactly. The property `argo.reloads` sets the number of reloads in the long test.
 */
class ReloadedDrivesSpec : FunSpec({
    val folder = tempdir().toPath()

    fun drives(reloads: Int) {
        for (seed in 0L until (reloads + PER_DRIVE - 1) / PER_DRIVE) withClue("seed $seed") {
            val recording = folder.resolve("$seed.mcap")
            ReloadedDrive(Random(seed), folder.resolve("$seed.asl")).run(recording, PER_DRIVE)
            shouldReplay(recording)
            recording.deleteIfExists()
        }
    }

    test("reloads of drawn programs at drawn instants") { drives(QUICK) }

    test("many reloads of drawn programs at drawn instants").config(tags = setOf(NamedTag("Thorough"))) {
        drives(Integer.getInteger("argo.reloads", MANY))
    }
}) {
    private companion object {
        const val PER_DRIVE = 20
        const val QUICK = 40
        const val MANY = 240
    }
}

/** A drive with a random program in [file]. */
private class ReloadedDrive(private val random: Random, private val file: Path) {
    /** A plan of the random program. All plans of one loop have its number, and never end. */
    private inner class Drawn(val loop: Int, var version: Int = 0) {
        val label = if (random.nextInt(3) == 0) "@l${loop}_${random.nextInt(1000)}[note($version)] " else ""

        fun text(): String = when (loop % 4) {
            0 -> "$label+!g$loop : known(_, $version) | not never(_, _) <- " +
                "+seen($version); .wait(${7 + version % 20}); -seen($version); !g$loop."
            1 -> "$label+!g$loop <- !sub$loop(X, _);\n   if (X > 1) { argo.act(move(X)) } else { .wait(${5 + version % 9}) };\n   !!g$loop."
            2 -> "$label+!g$loop <- .wait(\"+dist(_, _)\", ${30 + version % 20}); -+last(_, $version); !g$loop.\n-!g$loop <- !g$loop."
            else -> "$label+!g$loop[source(S)] <- for (.member(_, [1, 2])) { .wait(${3 + version % 8}); +p(S, $version) }; " +
                ".abolish(p(_, _)); !g$loop."
        }
    }

    private val loops = (0 until LOOPS).mapTo(ArrayList()) { Drawn(it) }
    private val others = ArrayList<String>()
    private var count = 0

    private fun text(): String {
        val starts = (0 until LOOPS).joinToString(" ") { "!g$it." }
        val subs = (0 until LOOPS).filter { it % 4 == 1 }.joinToString("\n") { "+!sub$it(X, _) <- X = ${random.nextInt(3)}." }
        val plans = (loops.map { it.text() } + others).joinToString("\n")
        return "!start. $starts\n${if (random.nextBoolean()) "// a comment\n\n" else ""}" +
            "far :- dist(_, Cm) & Cm > ${random.nextInt(100)}.\n" +
            "+!start <- argo.port(ttyACM0); argo.limit(20); argo.percepts(open); .add_plan(\"+!late(_) <- .wait(5).\").\n$plans\n$subs\n"
    }

    private fun change() {
        repeat(1 + random.nextInt(3)) {
            when (random.nextInt(6)) {
                0, 1 -> loops[random.nextInt(loops.size)].version++
                2 -> loops.shuffle(random)
                3 -> others.add(
                    random.nextInt(others.size + 1), "+dist(_, Cm) : far & Cm > ${random.nextInt(100)} & not n(_) <- -+far(${++count}, _).",
                )
                4 -> if (others.isNotEmpty()) others.removeAt(random.nextInt(others.size))
                else -> others.add("@own${++count} +!own(_, X) : X > $count <- .print(_, X).")
            }
        }
    }

    fun run(recording: Path, reloads: Int) {
        file.writeText(text())
        agent(file) {
            board("ttyACM0").shows("dist(front,50)")
            options("argo_record" to "$recording")
        }.use { robot ->
            robot.after(60.milliseconds)
            repeat(reloads) {
                robot.board.shows("dist(front,${random.nextInt(100)})")
                robot.after(random.nextInt(70).milliseconds)
                if (random.nextInt(8) == 0) robot.reload("+!broken <- .print(") else exchange(robot)
            }
            robot.after(100.milliseconds)
            robot.goals() shouldContainAll (0 until LOOPS).map { "g$it" }
        }
    }

    private fun exchange(robot: TestAgent) {
        change()
        val text = text()
        val before = robot.intentions()
        var after: Set<Int>? = null
        robot.reload(text) { after = robot.intentions() }
        after.shouldNotBeNull() shouldContainAll before
        val late = Programs.plansOf(robot).filter { it.sourceFile.isEmpty() }.map(::shown)
        Programs.plansOf(robot).map(::shown) shouldContainExactly plansIn(text) + late
        late shouldContainExactly listOf("+!late(_) <- .wait(5).")
    }

    private fun TestAgent.reload(text: String, done: () -> Unit = {}) {
        file.writeText(text)
        var refusal: String? = null
        var isDone = false
        mas.open {
            observed.reload {
                refusal = it.refusal
                isDone = true
                done()
            }
            mas.time.settle()
        }
        after(1.milliseconds)
        check(isDone) { "the reload has not ended" }
        if ("broken" in text) refusal.shouldNotBeNull() else refusal.shouldBeNull()
    }

    private fun TestAgent.intentions(): Set<Int> = ts.c.run {
        val running = allIntentions.asSequence().filterNot { it.isFinished }
        running.map { it.id }.toSet()
    }

    private fun TestAgent.goals() = ts.c.run {
        val waiting = events.map { "${it.trigger.literal.functor}" }
        waiting + allIntentions.asSequence().filterNot { it.isFinished }.flatMap { one -> one.map { it.trigger.literal.functor } }
    }

    private fun plansIn(text: String): List<String> {
        val reader = Agent().apply { initAg() }
        reader.parseAS(StringReader(text), "text.asl")
        return argo.platform.Plans.of(reader).all.map(::shown)
    }

    /** Returns the text of [plan] without Jason's additions. */
    private fun shown(plan: Plan): String = "$plan".replace(Regex("""@p__\d+\[[^]]*] |,?(source\(self\)|url\("[^"]*"\))"""), "")
        .replace("[]", "").replace(Regex("""(?<!\w)_\d+\w*"""), "_")

    private companion object {
        const val LOOPS = 8
    }
}
