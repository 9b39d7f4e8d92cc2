package argo.pausing

import argo.insides.Insides
import argo.observing.Breakpoint
import argo.observing.PausePhase
import argo.observing.PausePhase.MAKING_SAFE
import argo.observing.PausePhase.RUNNING
import argo.observing.PausePhase.STANDING
import argo.observing.PauseState
import argo.observing.Pausing
import argo.observing.SourceLine
import argo.observing.StopAt
import jason.asSemantics.Option
import jason.asSemantics.TransitionSystem
import jason.infra.local.LocalAgArchAsynchronous
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.locks.ReentrantLock
import java.util.logging.Level
import java.util.logging.Logger
import kotlin.concurrent.withLock

/**
 * The world of an agent that stands, as far as a pause touches it.
 *
 * @property nanos the agent's clock
 * @property makeSafe makes the boards safe, on the agent's thread; returns what becomes of each, in words; null: there is no such command
 * @property standing called by the agent's thread when it begins (true) or ceases (false) to stand
 * @property wake wakes the agent until its argument returns true
 * @property isStandingStill whether the world stands still with the agent, see [argo.platform.Platform.standsStill]
 */
internal class PauseWorld(
    val nanos: () -> Long,
    val makeSafe: () -> List<CompletableFuture<String>>?,
    val standing: (Boolean) -> Unit,
    val wake: (seen: () -> Boolean) -> Unit,
    val isStandingStill: Boolean,
)

/**
 * Has the agent of [ts] stand on its own thread, in [cycleStarting]. In a world that stands still with it, the agent also stands within a
 * cycle, so that breakpoints do not change its course.
 *
 * @param asking see [argo.boundary.Boundary.asking]
 */
internal class AgentPausing(
    override val refusal: String?,
    private val ts: TransitionSystem,
    private val world: PauseWorld,
    private val log: Logger,
    private val asking: (ask: () -> Unit) -> Unit,
) : Pausing, AutoCloseable {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val works = ArrayDeque<() -> Unit>() // for the thread of the standing agent; under the lock
    private var mayGoOn = true // under the lock
    private var isTakingWork = false // under the lock
    private val owned = LinkedHashMap<Any, List<Breakpoint>>() // under the lock
    private val listeners = CopyOnWriteArrayList<(PauseState) -> Unit>()

    @Volatile
    private var isClosed = false
    private val isOff get() = refusal != null || isClosed
    private val isWatching get() = !isOff && (until != null || breaks.lines.isNotEmpty())

    /** The reason why the agent is to stand before its next cycle; null: it is not. */
    @Volatile
    private var wanted: Met? = null

    @Volatile
    private var until: Stop? = null

    private val breaks = Breakpoints()
    private var lastOption: Option? = null // for the agent's thread

    @Volatile
    override var state = PauseState(RUNNING, null, emptyList(), null, null, world.nanos())
        private set

    override val breakpoints: List<Breakpoint> get() = lock.withLock { owned.values.flatten() }

    override fun pause() {
        if (isOff || state.phase != RUNNING) return
        wanted = PAUSED
        world.wake { wanted == null }
    }

    override fun goOn() = goOn(null, null)

    override fun goOnUntil(stop: StopAt) {
        if (isOff) return
        if (stop == StopAt.NextCycle) {
            goOn(null, Met("one cycle is over"))
            return world.wake { wanted == null }
        }
        val next = stopOf(stop, ts)
        val isStanding = meanwhile {
            next.met(ts, null) // sees what is there before the agent goes on
            goOn(next, null)
        }
        if (!isStanding) goOn(next, null)
    }

    private fun goOn(stop: Stop?, next: Met?) = lock.withLock {
        until = stop
        wanted = next
        mayGoOn = true
        changed.signalAll()
    }

    override fun breakAt(owner: Any, file: String, lines: List<Int>): List<Breakpoint> {
        if (refusal != null) return lines.map { Breakpoint(file, it, null, refusal) }
        val found = PlanLines(ts.ag).let { known -> lines.map { breakpoint(known, file, it) } }
        lock.withLock { set(owner, owned[owner].orEmpty().filter { it.file != file } + found) }
        return found
    }

    private fun breakpoint(known: PlanLines, file: String, wanted: Int): Breakpoint {
        val line = known.from(file, wanted)
        val why = when {
            line != null -> null
            known.has(file) -> "no plan or step is at line $wanted or behind it"
            else -> "the agent has no plan of this file; it has plans of ${known.files.joinToString()}"
        }
        return Breakpoint(file, wanted, line, why)
    }

    override fun removeBreakpoints(owner: Any) = lock.withLock { set(owner, emptyList()) }

    private fun set(owner: Any, its: List<Breakpoint>) {
        if (its.isEmpty()) owned -= owner else owned[owner] = its
        breaks.lines = owned.values.flatten().mapNotNull { one -> one.line?.let { SourceLine(one.file, it) } }
    }

    override fun follow(listener: (PauseState) -> Unit): AutoCloseable {
        listeners += listener
        return AutoCloseable { listeners -= listener }
    }

    override fun look(look: () -> Unit): Boolean = meanwhile { asking(look) }

    /**
     * If the agent stands, or is about to, has its thread do [work] before it goes on, and returns true; else returns false. Any thread may
     * call.
     */
    fun meanwhile(work: () -> Unit): Boolean = lock.withLock {
        if (!isTakingWork) return false
        works += work
        changed.signalAll()
        true
    }

    /** Has the agent stand, if it is to stand before the cycle that begins now. Called by its thread. */
    fun cycleStarting() {
        if (wanted == null) return
        val met = lock.withLock {
            wanted.takeIf { !isClosed }.also {
                wanted = null
                mayGoOn = it == null
                isTakingWork = it != null
            }
        }
        met?.let(::stand)
    }

    /**
     * Returns true if the agent is to carry out no intention in this cycle, since it is to stand before the next one. Called by the agent's
     * thread between the rules of its cycle.
     */
    fun isHolding(): Boolean {
        if (!isWatching || !Insides.isBeforeIntention(ts)) return false
        val met = met() ?: return false
        wanted = met
        if (world.isStandingStill) cycleStarting()
        return !world.isStandingStill
    }

    /** Called by the agent's thread at the end of each cycle. */
    fun cycleFinished() {
        if (isWatching && wanted == null) wanted = met()
    }

    private fun met(): Met? {
        val option = ts.c.selectedOption
        val chosen = option.takeIf { it !== lastOption }?.plan
        lastOption = option
        return breaks.met(ts, chosen) ?: until?.met(ts, chosen)
    }

    private fun stand(met: Met) {
        until = null
        world.standing(true)
        val boards = if (world.isStandingStill) listOf(STILL) else makeSafe(met)
        tell(STANDING, met, boards)
        val place = met.place?.run { " at ${file.removePrefix("file:")}:$line" }.orEmpty()
        log.info { "the agent stands: ${met.why}$place; ${boards.joinToString("; ")}" }
        while (true) carryOut(nextWork() ?: break)
        world.standing(false)
        tell(RUNNING, null, emptyList())
    }

    /** Makes the boards safe; returns what has become of each, in words. */
    private fun makeSafe(met: Met): List<String> {
        tell(MAKING_SAFE, met, emptyList())
        val boards = world.makeSafe() ?: return listOf(UNSAFE)
        boards.forEach { it.thenRun { lock.withLock(changed::signalAll) } }
        lock.withLock { while (!mayGoOn && !boards.all { it.isDone }) changed.awaitUninterruptibly() }
        return boards.mapNotNull { it.getNow(null) }
    }

    /** Waits for work of the standing agent; null: the agent goes on. */
    private fun nextWork(): (() -> Unit)? = lock.withLock {
        while (works.isEmpty() && !mayGoOn) changed.awaitUninterruptibly()
        works.removeFirstOrNull().also { if (it == null) isTakingWork = false }
    }

    private fun carryOut(work: () -> Unit) = try {
        work()
    } catch (broken: Throwable) { // of a view or a debugger, and the agent must go on
        log.log(Level.WARNING, "what was asked of the standing agent has failed", broken)
    }

    private fun tell(phase: PausePhase, met: Met?, boards: List<String>) {
        state = PauseState(phase, met?.why, boards, met?.place, met?.intention, world.nanos())
        listeners.forEach { carryOut { it(state) } }
    }

    /** Has the agent go on for good, since it ends. */
    override fun close() {
        isClosed = true
        goOn()
    }

    private companion object {
        val PAUSED = Met("it was paused")
        const val STILL = "the world stands still with it"
        const val UNSAFE = "its boards go on with what they do, since it has no option argo_safe"
    }
}

/** Returns why the agent of [ts] cannot stand, in words; null: it can. */
internal fun refusalToPause(ts: TransitionSystem): String? =
    if (generateSequence(ts.agArch) { it.nextAgArch }.none { it is LocalAgArchAsynchronous }) null
    else "the agent has a thread each for sensing, deliberating and acting, which cannot stand together; leave out \"asynchronous\" in " +
        "the .mas2j"
