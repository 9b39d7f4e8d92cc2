package argo.pausing

import argo.insides.Insides
import argo.observing.Breakpoint
import argo.observing.BreakpointOwner
import argo.observing.PausePhase
import argo.observing.PausePhase.MAKING_SAFE
import argo.observing.PausePhase.PAUSED
import argo.observing.PausePhase.RUNNING
import argo.observing.PauseState
import argo.observing.Pausing
import argo.observing.SourceLine
import argo.observing.StopAt
import argo.platform.isSameFile
import jason.architecture.AgArch
import jason.asSemantics.Option
import jason.asSemantics.TransitionSystem
import jason.infra.local.LocalAgArchAsynchronous
import java.nio.file.attribute.FileTime
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.locks.ReentrantLock
import java.util.logging.Level
import java.util.logging.Logger
import kotlin.concurrent.withLock

/**
 * The parts of an agent's world that a pause needs.
 *
 * @property nanos the agent's clock
 * @property makeSafe makes the boards safe, on the agent's thread. Returns the result for each board, in words; null if no command makes
 * them safe
 * @property standing called by the agent's thread, with true when a pause begins and with false when it ends
 * @property wake wakes the agent until `seen` returns true
 * @property isStandingStill whether the world stops while the agent is paused, see [argo.platform.Platform.standsStill]
 */
internal class PauseWorld(
    val nanos: () -> Long,
    val makeSafe: () -> List<CompletableFuture<String>>?,
    val standing: (Boolean) -> Unit,
    val wake: (seen: () -> Boolean) -> Unit,
    val isStandingStill: Boolean,
)

/**
 * Pauses the agent of [ts] by blocking its thread in [cycleStarting]. If the world also stops, the agent can even be paused within a cycle,
 * so that breakpoints do not change its behaviour.
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
    private val works = ArrayDeque<() -> Unit>() // work for the paused agent's thread; under the lock
    private var mayGoOn = true // under the lock
    private val owned = LinkedHashMap<Any, List<Placed>>() // under the lock
    private val listeners = CopyOnWriteArrayList<(PauseState) -> Unit>()

    @Volatile
    private var isClosed = false
    private val isOff get() = refusal != null || isClosed
    private val isWatching get() = !isOff && (until != null || breaks.lines.isNotEmpty())

    /** The reason why an agent is paused, and the owners for whom it is paused. There is at least one owner. */
    private data class Stand(val met: Met, val owners: Set<Any>) {
        fun with(others: Set<Any>) = copy(owners = owners + others)
        fun without(owner: Any) = copy(owners = owners - owner).takeIf { it.owners.isNotEmpty() }
    }

    /** A breakpoint, with the time at which its file had last been saved when it was set. The time is null if the file is not on a disk. */
    private class Placed(val breakpoint: Breakpoint, val savedAt: FileTime?)

    private class Until(val stop: Stop, val owner: Any)

    /** The pause that begins before the agent's next cycle; null if there is none. Written under the lock. */
    @Volatile
    private var wanted: Stand? = null

    /** The current pause, during which the agent's thread does [works]; null if the agent is not paused. Under the lock. */
    private var standing: Stand? = null

    @Volatile
    private var until: Until? = null // written under the lock

    private var isInCycle = false // for the agent's thread

    private val breaks = Breakpoints()
    private var lastOption: Option? = null // for the agent's thread

    @Volatile
    override var state = PauseState(RUNNING, null, emptyList(), null, null, world.nanos())
        private set

    override fun pause(owner: Any) {
        if (isOff) return
        lock.withLock {
            val now = standing.takeUnless { mayGoOn }
            if (now == null) want(Stand(BY_REQUEST, setOf(owner))) else standing = now.with(setOf(owner))
        }
        if (wanted != null) world.wake { wanted == null }
    }

    /** Makes [next] the pause that begins next. Owners of an earlier pause that has not begun also become its owners. Under the lock. */
    private fun want(next: Stand) {
        wanted = next.with(wanted?.owners.orEmpty())
    }

    override fun goOn() = goOn(null, null)

    override fun goOnUntil(stop: StopAt, owner: Any) {
        if (isOff) return
        if (stop == StopAt.NextCycle) {
            goOn(null, Stand(Met("one cycle is over"), setOf(owner)))
            return world.wake { wanted == null }
        }
        val next = Until(stopOf(stop, ts), owner)
        val isStanding = meanwhile {
            next.stop.met(ts, null) // notes the current beliefs before the agent continues
            goOn(next, null)
        }
        if (!isStanding) goOn(next, null)
    }

    private fun goOn(stop: Until?, next: Stand?) = lock.withLock {
        until = stop
        wanted = next
        mayGoOn = true
        changed.signalAll()
    }

    override fun breakAt(owner: Any, file: String, lines: List<Int>): List<Breakpoint> {
        if (refusal != null) return lines.map { Breakpoint(file, it, null, refusal) }
        val known = PlanLines(ts.ag)
        val savedAt = known.savedAt(file)
        val found = lines.map { breakpoint(known, file, it) }
        lock.withLock { set(owner, owned[owner].orEmpty().filter { it.breakpoint.file != file } + found.map { Placed(it, savedAt) }) }
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

    override fun breakpoints(owner: Any) = lock.withLock { owned[owner].orEmpty().map { it.breakpoint } }

    /** Calls [exchange] to exchange the agent's plans, and moves breakpoints with their plans. Called by the agent's thread. */
    fun exchanging(exchange: () -> Unit) {
        val before = PlanLines(ts.ag).takeIf { lock.withLock { owned.isNotEmpty() } }
        exchange()
        val now = before?.let { PlanLines(ts.ag) } ?: return
        lock.withLock { owned.keys.filter { owner -> moveAll(owner, before, now) } }
            .forEach { owner -> carryOut { (owner as? BreakpointOwner)?.breakpointsChanged() } }
    }

    /** Moves the breakpoints of [owner]. Returns true if the line of any has changed. Under the lock. */
    private fun moveAll(owner: Any, before: PlanLines, now: PlanLines): Boolean {
        val its = owned.getValue(owner)
        val moved = its.map { moved(it, before, now) }
        set(owner, moved)
        return its.zip(moved).any { (one, other) -> one.breakpoint.line != other.breakpoint.line }
    }

    /**
     * A breakpoint that was set before its file was saved belongs to the old text, and moves with its plan. All other breakpoints belong to
     * the new text.
     */
    private fun moved(placed: Placed, before: PlanLines, now: PlanLines): Placed {
        val (file, wanted, line) = placed.breakpoint
        val savedAt = now.savedAt(file)
        val isOfOldText = line != null && (savedAt == null || savedAt != placed.savedAt)
        val next =
            if (!isOfOldText) breakpoint(now, file, wanted)
            else before.moved(file, line, now)?.let { Breakpoint(file, it, it, null) }
                ?: Breakpoint(file, line, null, "the plan of line $line is gone")
        if (next.line != line) {
            val place = next.line?.let { "the breakpoint is at line $it now" } ?: "there is no breakpoint any more: ${next.refusal}"
            log.info("$file:${line ?: wanted}: the program has changed, and $place")
        }
        return Placed(next, savedAt)
    }

    override fun release(owner: Any): Unit = lock.withLock {
        set(owner, emptyList())
        if (until?.owner == owner) until = null
        wanted = wanted?.without(owner)
        val now = standing ?: return
        standing = now.without(owner) ?: now.also {
            mayGoOn = true
            changed.signalAll()
        }
    }

    private fun set(owner: Any, its: List<Placed>) {
        if (its.isEmpty()) owned -= owner else owned[owner] = its
        breaks.lines = owned.values.flatten().map { it.breakpoint }.mapNotNull { one -> one.line?.let { SourceLine(one.file, it) } }
    }

    override fun follow(listener: (PauseState) -> Unit): AutoCloseable {
        listeners += listener
        return AutoCloseable { listeners -= listener }
    }

    override fun look(look: () -> Unit): Boolean = meanwhile { asking(look) }

    /**
     * If the agent is paused or its pause is beginning, returns true, and the agent's thread does [work] before the agent continues. Else
     * returns false. Any thread may call this function.
     */
    fun meanwhile(work: () -> Unit): Boolean = lock.withLock {
        if (standing == null) return false
        works += work
        changed.signalAll()
        true
    }

    /** If a pause is wanted before the cycle that begins now, pauses the agent. Called by the agent's thread. */
    fun cycleStarting() {
        isInCycle = true
        standIfWanted()
    }

    private fun standIfWanted() {
        if (wanted == null) return
        val begun = lock.withLock {
            wanted.takeIf { !isClosed }.also {
                wanted = null
                mayGoOn = it == null
                standing = it
            }
        }
        begun?.let { stand(it.met) }
    }

    /**
     * Returns true if the agent can pause without a new cycle. False only if a pause is wanted and the world does not stop with the agent.
     */
    fun maySleep(): Boolean = world.isStandingStill || wanted == null

    /**
     * Returns true if the agent must pause before it carries out an intention. Called by the agent's thread between the rules of its cycle.
     */
    fun isHolding(): Boolean {
        if (!isInCycle || !isWatching || !Insides.isBeforeIntention(ts) || !hasMet()) return false
        if (world.isStandingStill) standIfWanted()
        return !world.isStandingStill
    }

    /** Called by the agent's thread at the end of each cycle. */
    fun cycleFinished() {
        isInCycle = false
        if (!isWatching || wanted != null || !hasMet()) return
        if (world.isStandingStill) standIfWanted() else world.wake { wanted == null }
    }

    /** Returns true if the agent must pause now, and notes the pause and its owners. */
    private fun hasMet(): Boolean {
        val option = ts.c.selectedOption
        val chosen = option.takeIf { it !== lastOption }?.plan
        lastOption = option
        val awaited = until
        val broken = breaks.met(ts, chosen)
        val met = broken ?: awaited?.stop?.met(ts, chosen) ?: return false
        return lock.withLock {
            val owners = broken?.place?.let(::ownersAt) ?: setOfNotNull(awaited?.owner.takeIf { until === awaited })
            owners.isNotEmpty().also { if (it) want(Stand(met, owners)) }
        }
    }

    private fun ownersAt(place: SourceLine): Set<Any> =
        owned.filterValues { its -> its.any { it.breakpoint.line == place.line && isSameFile(it.breakpoint.file, place.file) } }.keys

    private fun stand(met: Met) {
        lock.withLock { until = null }
        world.standing(true)
        val boards = if (world.isStandingStill) listOf(STILL) else makeSafe(met)
        tell(PAUSED, met, boards)
        val place = met.place?.run { " at ${file.removePrefix("file:")}:$line" }.orEmpty()
        log.info { "the agent is paused: ${(listOf("${met.why}$place") + boards).joinToString("; ")}" }
        while (true) carryOut(nextWork() ?: break)
        world.standing(false)
        tell(RUNNING, null, emptyList())
    }

    private fun makeSafe(met: Met): List<String> {
        tell(MAKING_SAFE, met, emptyList())
        val boards = world.makeSafe() ?: return listOf(UNSAFE)
        boards.forEach { it.thenRun { lock.withLock(changed::signalAll) } }
        lock.withLock { while (!mayGoOn && !boards.all { it.isDone }) changed.awaitUninterruptibly() }
        return boards.mapNotNull { it.getNow(null) }
    }

    /** Waits for the next work of the paused agent and returns it. Returns null when the agent continues. */
    private fun nextWork(): (() -> Unit)? = lock.withLock {
        while (works.isEmpty() && !mayGoOn) changed.awaitUninterruptibly()
        works.removeFirstOrNull().also { if (it == null) standing = null }
    }

    private fun carryOut(work: () -> Unit) = try {
        work()
    } catch (broken: Throwable) { // a view or a debugger may throw anything, and the agent must continue
        log.log(Level.WARNING, "what was asked of the standing agent has failed", broken)
    }

    private fun tell(phase: PausePhase, met: Met?, boards: List<String>) {
        state = PauseState(phase, met?.why, boards, met?.place, met?.intention, world.nanos())
        listeners.forEach { carryOut { it(state) } }
    }

    /** Lets the agent continue, and never pauses it again. Called when the agent ends. */
    override fun close() {
        isClosed = true
        goOn()
    }

    private companion object {
        val BY_REQUEST = Met("by request")
        const val STILL = "the world stands still with it"
        const val UNSAFE = "its boards go on with what they do, since it has no option argo_safe"
    }
}

/** Returns the reason, in words, why an agent with these [architectures] cannot be paused; null if it can be paused. */
internal fun refusalToPause(architectures: Sequence<AgArch>): String? =
    if (architectures.none { it is LocalAgArchAsynchronous }) null
    else "the agent has a thread each for sensing, deliberating and acting, which cannot stand together; leave out \"asynchronous\" in " +
        "the .mas2j"
