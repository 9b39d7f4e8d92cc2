package argo.recording

import argo.testkit.agentOf
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.nulls.shouldNotBeNull
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.exists
import kotlin.random.Random
import kotlin.time.Duration.Companion.milliseconds

/**
 * Agents that are killed at random times continue from their saved state. The state is at most five seconds old. The board carries out no
 * command twice, and each recording is replayed exactly. The property `argo.kills` sets the number of kills in the long test.
 */
class KilledAgentsSpec : FunSpec({
    val folder = tempdir().toPath()

    /** Moves on from the place that its board reports, and counts tenths of seconds. */
    val program = """
        tick(0).
        !start. !count.
        +!start <- argo.port(ttyACM0, [baud(115200), boot(0)]); argo.limit(20); argo.percepts(open); !!drive.
        +!drive <- .wait(at(_)); .wait(math.random(300)); !step.
        +!step : at(N) & .random(R) <- argo.act(go(N + 1, R)); .wait(at(N + 1)); !drive.
        +!count : tick(T) <- .wait(100); -+tick(T + 1); !count.
        +resumed(Ms) : tick(T) <- .print("resumed ", T).
    """

    class World(val seed: Long) {
        val chance = Random(seed)
        val carriedOut = ArrayList<String>()
        var state: Path? = null
        var lives = 0
        var lastTick = 0
    }

    /** Runs the agent until it is killed. Later changes of its files, for example at its end, do not count. */
    fun World.live() {
        val own = folder.resolve("$seed-${++lives}.state")
        state?.takeIf { it.exists() }?.copyTo(own)
        val goesOn = own.exists()
        val recording = folder.resolve("$seed-$lives.mcap")
        val before = carriedOut.size
        agentOf(program) {
            options("argo_resume" to "$own", "argo_record" to "$recording")
            val board = board("ttyACM0")
            if (chance.nextBoolean()) board.version2()
            board.shows { listOf("at(${before + board.arrivals.size})") }
        }.use { robot ->
            robot.after(chance.nextLong(1, 9_000).milliseconds)
            carriedOut += robot.sent
            val resumed = robot.printed.firstOrNull()?.substringAfter("resumed ")?.toInt()
            if (goesOn) withClue("ticks that are lost") { lastTick - resumed.shouldNotBeNull() shouldBeLessThanOrEqual 50 }
            lastTick = robot.beliefs.firstNotNullOf { Regex("""tick\((\d+)\)""").matchEntire(it) }.groupValues[1].toInt()
            state = folder.resolve("$seed-$lives.killed").also { if (own.exists()) own.copyTo(it) }
            robot.log.filter { "SEVERE" in it || "WARNING" in it }.shouldBeEmpty()
        }
        shouldReplay(recording)
    }

    fun shouldGoOn(seeds: LongRange) = seeds.forEach { seed ->
        withClue("seed $seed") {
            val world = World(seed)
            repeat(LIVES) { world.live() }
            world.carriedOut.map { it.substringBefore(',') }.shouldBeUnique()
            folder.toFile().listFiles().orEmpty().forEach { it.delete() }
        }
    }

    test("agents that are killed go on") { shouldGoOn(1L..1L) }

    test("many kills").config(tags = setOf(NamedTag("Thorough"))) { shouldGoOn(2L..Integer.getInteger("argo.kills", 60) / LIVES) }
})

/** The number of runs of an agent. Each run continues the one before. */
private const val LIVES = 5
