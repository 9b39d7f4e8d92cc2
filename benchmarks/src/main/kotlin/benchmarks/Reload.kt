package benchmarks

import argo.Arch
import argo.observing.Outcome
import argo.platform.Platform
import jason.asSyntax.ASSyntax
import jason.asSyntax.NumberTerm
import javino.sim.Sketch
import java.nio.file.Path
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import kotlin.io.path.writeText

/**
 * Measures reloads of a program with 200 plans while its agent senses a board at 50 Hz. The figures are the time until the agent has the
 * new program, and the effect on perception. Prints one line for reloads that change one plan, and one for reloads that change all plans.
 * Returns true if all figures keep their bounds.
 */
internal fun reloaded(): Boolean {
    println("machine: ${machine()}")
    return listOf("one plan" to 1, "all plans" to PLANS).map { (what, changed) -> measured(what, changed) }.all { it }
}

private fun measured(what: String, changed: Int): Boolean = withAgents(mapOf(BOARD to Numbered())) { agents ->
    agents.start("driver", programOf(0, changed), PerceivingArch::class.java.name)
    val arch = checkNotNull(PerceivingArch.last)
    val file = arch.observed.sources().first()
    Thread.sleep(LOADING_S * 1_000L)
    val first = reload(arch, file, programOf(1, changed))
    arch.begin()
    val times = (2 until RELOADS + 2).map { version ->
        Thread.sleep(PAUSE_MS + version % INTERVAL_MS.toLong()) // varies the time of the reload between two messages
        reload(arch, file, programOf(version, changed))
    }.sorted()
    val seen = arch.end()
    println(
        figures(
            "%s of $PLANS changed: median %.0f ms, longest %.0f ms of $RELOADS, the first %.0f ms; longest cycle %.0f ms; of %d messages " +
                "of the board %d not perceived, longest interval %.0f ms",
            what, times[times.size / 2], times.last(), first, seen.longestCycleMs, seen.messages, seen.lost, seen.longestMs,
        ),
    )
    times.last() <= MOST_MS && seen.lost == 0 && seen.longestMs <= 2 * INTERVAL_MS
}

private fun reload(arch: Arch, file: Path, program: String): Double {
    file.writeText(program)
    val done = CompletableFuture<Outcome>()
    val begin = System.nanoTime()
    arch.observed.reload(done::complete)
    val outcome = done.get(LIMIT_S, TimeUnit.SECONDS)
    check(outcome.refusal == null) { outcome.refusal.orEmpty() }
    return (System.nanoTime() - begin) / NS_OF_MS
}

/** An architecture that notes the number and time of each perceived message of its board. */
class PerceivingArch(platform: Platform) : Arch(platform) {
    /** The numbers of perceived and lost messages, the longest time between two perceived messages, and the longest cycle. */
    internal class Seen(val messages: Int, val lost: Int, val longestMs: Double, val longestCycleMs: Double)

    private val numbers = ArrayList<Int>()
    private val times = ArrayList<Long>()
    private var cycleNs = 0L
    private var longestNs = 0L

    @Volatile
    private var isNoting = false

    constructor() : this(Platform.system)

    override fun init() {
        super.init()
        last = this
    }

    internal fun begin() {
        isNoting = true
    }

    internal fun end(): Seen {
        isNoting = false
        Thread.sleep(PAUSE_MS)
        val longest = times.zipWithNext { one, next -> next - one }.max()
        return Seen(numbers.size, numbers.last() - numbers.first() + 1 - numbers.size, longest / NS_OF_MS, longestNs / NS_OF_MS)
    }

    override fun reasoningCycleStarting() {
        cycleNs = System.nanoTime()
        super.reasoningCycleStarting()
    }

    override fun reasoningCycleFinished() {
        super.reasoningCycleFinished()
        if (!isNoting) return
        longestNs = maxOf(longestNs, System.nanoTime() - cycleNs)
        val belief = ts.ag.bb.getCandidateBeliefs(NUMBER)?.asSequence()?.firstOrNull()
        val number = belief?.let { (it.getTerm(0) as NumberTerm).solve().toInt() }
        if (number == null || number == numbers.lastOrNull()) return
        numbers += number
        times += System.nanoTime()
    }

    companion object {
        private val NUMBER = ASSyntax.createLiteral("message", ASSyntax.createVar("N")).predicateIndicator

        @Volatile
        internal var last: PerceivingArch? = null
    }
}

private class Numbered : Sketch {
    private val requests = AtomicInteger()

    override fun percepts() = listOf("message(${requests.incrementAndGet()})", "dist(front,40)", "dist(left,120)", "light(200)")

    override fun act(command: String) = true
}

private fun programOf(version: Int, changed: Int): String =
    sensing("sim:$BOARD", baud = 115_200, INTERVAL_MS, "+message(N) <- -+seen(N).\n") + (0 until PLANS).joinToString("\n") { number ->
        val own = if (number < changed) version else 0
        "+!task$number(X, _) : dist(front, Cm) & Cm > X & not blocked(_)\n   <- .print(\"task $number, $own\");\n" +
            "      argo.act(move(X));\n" +
            "      if (X > $own) { +passed($number, X); .wait(100) } else { -passed($number, _) };\n      !task$number(X + 1, left)."
    }

private const val BOARD = "bench-reload"
private const val PLANS = 200
private const val INTERVAL_MS = 20
private const val RELOADS = 30
private const val PAUSE_MS = 300L
private const val LOADING_S = 3
private const val LIMIT_S = 10L
private const val MOST_MS = 100
private const val NS_OF_MS = 1e6
