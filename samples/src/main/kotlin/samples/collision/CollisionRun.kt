package samples.collision

import argo.observing.Order
import jason.asSyntax.ASSyntax.createAtom
import jason.asSyntax.ASSyntax.createList
import jason.asSyntax.ASSyntax.createLiteral
import jason.asSyntax.ASSyntax.createNumber
import jason.asSyntax.ASSyntax.createString
import jason.asSyntax.Literal
import javino.LineClock
import javino.sim.SimulatedBoards
import samples.project.MasRun
import samples.project.Progress
import samples.project.SampleProject
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.random.Random

/** The variables of a run. The options of [CollisionCommand] explain them. [port] is null for a simulated robot. */
internal data class Levels(
    val filter: String,
    val limit: Int,
    val interval: Int,
    val baud: Int,
    val sensing: String,
    val port: String?,
    val boards: Int,
    val seed: Long,
)

/**
 * A run of the collision experiment.
 *
 * @param audience the spectators in a browser, or null for none
 * @param program the agent's program, which the user edits while the robot drives, or null for one drive with the sample's program. Saving
 * the program reloads the agent. After each drive, the simulated robot is put back
 */
internal class CollisionRun(
    private val levels: Levels,
    private val progress: Progress,
    private val audience: Audience? = null,
    private val program: Path? = null,
    private val clock: LineClock = LineClock.system(),
) {
    private val witness = Witness()
    private val mas = MasRun(project())
    private var boards: List<RobotBoard> = emptyList() // plugged-in boards
    private val robot = Robot(clock, Random(levels.seed)) // not used with a real robot

    private fun project() = SampleProject("collision").apply {
        believe(
            AGENT,
            body(),
            createLiteral("value", createNumber(levels.limit.toDouble())),
            createLiteral("interval", createNumber(levels.interval.toDouble())),
            createLiteral("view", createAtom(levels.filter)),
        )
        set(AGENT, "argo_sensing", levels.sensing)
        audience?.let { set(AGENT, "argo_view", "${it.port}") }
        program?.let {
            run(AGENT, it)
            set(AGENT, "argo_watch", "true")
        }
    }

    private fun body(): Literal {
        val options = createList(
            createLiteral("baud", createNumber(levels.baud.toDouble())), createLiteral("timeout", createNumber(ANSWER_LIMIT_MS)),
        )
        if (levels.boards == 1) return createLiteral("board", createString(levels.port ?: simulated(RobotBoard.NAME)), options)
        val ports = listOf(RobotBoard.NAME, RobotBoard.SENSORS).map { createLiteral("port", createString(simulated(it)), options) }
        return createLiteral("boards", createList(ports))
    }

    /** Runs the experiment and returns its verdict. The run always ends, unless the user edits the program. Call this function once. */
    fun run(): Verdict {
        val scene = scene()
        try {
            mas.begin(mapOf(AGENT to witness)) { audience?.gather(mas.viewOf(AGENT), scene::picture) }
            var verdict = watch(scene)
            while (program != null && verdict !is Verdict.Failed) {
                println(verdict.sentence)
                driveAgain()
                verdict = watch(scene)
            }
            return verdict.also { audience?.conclude(it.sentence) }
        } finally {
            abandon()
            mas.end()
            boards.forEach { SimulatedBoards.unplug(it.name()) }
        }
    }

    /** A warning if a real robot may still drive after the run, or null. */
    val warning: String?
        get() = levels.port?.takeIf { witness.beliefs.mayDrive }?.let { "the robot on $it may still drive: its agent could not send stop" }

    /**
     * Aborts the run. Stops a real robot if its agent has not done so. The motors keep their last command. Takes at most [HALT_LIMIT_S] s.
     * Safe for use by several threads.
     */
    fun abandon() {
        progress.end()
        if (levels.port == null || witness.beliefs.port !in OPEN) return
        val deadline = clock.nanos() + TimeUnit.SECONDS.toNanos(HALT_LIMIT_S)
        if (!witness.beliefs.isStopped) witness.haltRobot()
        while (!witness.beliefs.isStopped && clock.nanos() < deadline) mas.awaitEnd(LOOK_MS)
    }

    private fun scene(): Scene {
        if (levels.port != null) return BoardScene(witness, levels.port, levels.limit, clock)
        boards = RobotBoard.of(robot, levels.boards)
        boards.forEach { SimulatedBoards.plugIn(it.name(), it) }
        return SimulatedScene(robot, witness::beliefs, levels.limit, clock)
    }

    private fun watch(scene: Scene): Verdict {
        val begin = clock.nanos()
        while (true) {
            scene.verdict()?.let { return it }
            val elapsed = clock.nanos() - begin
            if (program == null && elapsed > TimeUnit.SECONDS.toNanos(MAX_S)) return scene.overdue(MAX_S)
            progress.show(scene.look(), elapsed, scene.picture().line())
            if (mas.awaitEnd(LOOK_MS) != null) return Verdict.Failed(
                "an agent has ended the system; last seen: ${scene.look().joinToString()}",
            )
        }
    }

    /** Puts the robot back. Makes it drive again after the agent has perceived the new distance. */
    private fun driveAgain() {
        mas.awaitEnd(REST_MS)
        robot.putBack()
        while ((witness.beliefs.distance ?: 0.0) <= levels.limit) if (mas.awaitEnd(LOOK_MS) != null) return
        val agent = mas.observed(AGENT)
        LEFT.forEach { agent.order(it) {} } // refused if nothing is left
        agent.order(Order.Begin("start")) { outcome -> outcome.refusal?.let { println("the robot is put back, but does not drive: $it") } }
    }

    private companion object {
        const val AGENT = "robot"

        val LEFT = listOf(Order.Drop("moving"), Order.Forget("status(_)"))
        val OPEN = setOf("on", "timeout")

        fun simulated(board: String) = "${SimulatedBoards.SCHEME}:$board"

        /**
         * The longest wait for the board's answer in ms. The wait is three times the time of an answer at 9600 baud with a waiting command.
         */
        const val ANSWER_LIMIT_MS = 1000.0
        const val LOOK_MS = 50L

        const val REST_MS = 2000L
        const val MAX_S = 60L
        const val HALT_LIMIT_S = 1L
    }
}
