package argo

import argo.boards.AgentBoards
import argo.boards.AgentPerception
import argo.boundary.Boundary
import argo.boundary.CompletionInbox
import argo.boundary.Live
import argo.boundary.Perception
import argo.filters.PerceptionFilter
import argo.observing.AgentObserver
import argo.observing.ObservedAgent
import argo.observing.Observers
import argo.observing.Order
import argo.orders.Orders
import argo.orders.Reloading
import argo.pausing.AgentPausing
import argo.pausing.PauseWorld
import argo.pausing.SafeCommand
import argo.pausing.refusalToPause
import argo.perception.DeletedPercepts
import argo.perception.EnvironmentPercepts
import argo.perception.ReasoningQueues
import argo.perception.bringForward
import argo.perception.takeTurns
import argo.platform.Platform
import argo.platform.Waker
import argo.platform.nowMs
import argo.sensing.SensingPolicy
import jason.architecture.AgArch
import jason.asSemantics.ActionExec
import jason.asSemantics.Message
import jason.asSyntax.Literal
import jason.infra.local.LocalAgArch
import java.util.logging.Logger

/**
 * The architecture of an agent that perceives and acts through microcontroller boards. A project declares it in its `.mas2j`:
 *
 *     agents: robot agentArchClass argo.Arch;
 *
 * The agents of the project use the internal actions `argo.port`, `argo.ports`, `argo.limit`, `argo.percepts`, `argo.act`, `argo.can`,
 * `argo.change_filter`, `argo.age`, `argo.skew`, `argo.explain`, `argo.record` and `argo.reload`.
 *
 * The architecture has these options:
 * - `[argo_sensing=fresh]` (the default), `every` or `in_cycle` decides when the agent gets snapshots of the sensors
 * - `argo_percepts=4096` limits the percepts of one board that are believed at once
 * - `argo_safe=stop` is the command that makes boards safe before the agent is paused, see [argo.observing.Pausing]
 * - `argo_resume="robot.state"` names the file that keeps the agent's state for its next run
 *
 * Other options, such as `argo_view=8080` of the live view, belong to observers.
 *
 * The architecture follows C. E. Pantoja et al., "ARGO: An Extended Jason Architecture that Facilitates Embedded Robotic Agents
 * Programming", EMAS 2016. A reasoning cycle waits for a board only under `in_cycle`, which exists for comparison.
 *
 * Jason calls the methods of [AgArch]; projects do not call them.
 *
 * @param platform the agent's time, threads and ports; the default is the machine's own platform
 */
open class Arch @JvmOverloads constructor(private val platform: Platform = Platform.system) : AgArch() {
    private val waker = Waker(this, platform)
    private val deleted = DeletedPercepts()
    private var waiting: Int? = null // see Perception.waiting
    private val environment = EnvironmentPercepts(nowMs = platform.nowMs)

    // the boundary gets these functions in each cycle; making them once saves time
    private val perceiveLive = { perceiveBoards() }
    private val criticalLive = { perception.takeNewlyCritical() }
    private val mailLive = { super.checkMail() }
    private val holdLive = { pausing.isHolding() }
    private val sleepLive = {
        super.canSleep() && !perception.hasNews() && !environment.isWaiting() && orders.isEmpty() && pausing.maySleep() && waker.maySleep()
    }
    private val ordersLive = { orders.takeAll() }
    private val carryOut: (Order) -> Unit = { order ->
        if (order is Order.Reload) pausing.exchanging { orders.carryOut(order, ts) } else orders.carryOut(order, ts)
        resuming?.ordered()
    }

    /** Available from [init] on. */
    internal lateinit var boards: AgentBoards
        private set
    internal val perception by lazy { AgentPerception(boards) }
    internal val commands by lazy { CommandRouter(boards) }
    internal val awaited = AwaitedWork()

    /** Receives a person's orders to the agent. Available from [init] on. */
    internal lateinit var orders: Orders
        private set

    /** Holds the requests of observers to the agent. Available from [init] on. */
    internal lateinit var requests: CompletionInbox<() -> Unit>
        private set

    /** Available from [init] on. */
    internal lateinit var reloading: Reloading
        private set

    internal lateinit var policy: SensingPolicy
        private set

    /** Available from [init] on. */
    internal lateinit var pausing: AgentPausing
        private set
    private var isBeginning = false // only the agent's thread uses isBeginning and hasBegunCycle
    private var hasBegunCycle = false

    /** The boundary through which all inputs reach the agent. Any thread may read it. */
    @Volatile
    internal var boundary: Boundary = Live
        private set

    /** The agent, as its observers see it. Available from [init] on. Any thread may read it. */
    lateinit var observed: ObservedAgent
        private set

    private var resuming: Resuming? = null

    @Volatile
    private var observing = Observers(emptyList(), Logger.getLogger(Arch::class.java.name), platform.clock::nanos)

    /** The agent's observers, such as its live view. Available from [init] on. Any thread may read them. */
    val observers: List<AgentObserver> get() = observing.observers

    override fun init() {
        super.init()
        val log = Logger.getLogger("${Arch::class.java.name}.$agName")
        val options = ArchOptions(ts.settings, log, isReplay = platform.boundary != null)
        Infrastructure.check(log)
        Infrastructure.checkFleetOption(ts.settings.getUserParameter(Infrastructure.FLEET_OPTION), architectures(ts).last(), log)
        policy = options.policy
        val queues = ReasoningQueues(::isQueueStanding, { ts.c.runningIntentions }) { ts.c.events }
        boards = AgentBoards(agName, options.policy, options.maxPercepts, platform, waker, log, queues) { observing }
        pausing = AgentPausing(refusalToPause(architectures(ts)), ts, pauseWorld(options), log) { boundary.asking(it) }
        orders = Orders(log) { seen -> if (!pausing.meanwhile(::takeOrders)) waker.wake(seen) }
        requests = CompletionInbox(::wakeForRequest)
        reloading = Reloading(ts, boards, orders, ::perceiveThrough)
        observed = ObservedArch(this, waker, platform)
        resuming = options.resume?.let { Resuming.open(this, it, platform, log) }
        observing = Observers(options.observers.open(observed) + listOfNotNull(resuming), log, platform.clock::nanos)
        boundary = platform.boundary ?: observers.filterIsInstance<Boundary>().firstOrNull() ?: Live
        resuming?.begin(observed::order)
    }

    private fun pauseWorld(options: ArchOptions) = PauseWorld(
        platform.clock::nanos, { options.safe?.let { SafeCommand(it, boards).send() } }, ::standing, waker::wake, platform.standsStill,
    )

    private fun standing(isStanding: Boolean) {
        boards.stands(isStanding)
        if (isStanding) takeOrders()
    }

    private fun wakeForRequest(seen: () -> Boolean) {
        if (pausing.meanwhile(::takeOrders)) return
        ts.runAtBeginOfNextCycle { doRequests() }
        waker.wake(seen)
    }

    private fun doRequests() = requests.takeAll().forEach { it() }

    /** Returns true if events may stay in Jason's queue. An atomic plan holds back all events; `events=requeue` may put events back. */
    private fun isQueueStanding() = ts.c.hasAtomicIntention() || ts.c.atomicEvent != null || ts.settings.requeue()

    /**
     * Uses [filter] from the next perception on. If [filter] is null, the agent perceives without a filter. Called by the agent's thread.
     */
    internal fun perceiveThrough(filter: PerceptionFilter?) {
        boards.perceiveThrough(filter)
        environment.switchTo(filter)
        observing.each { it.filterChanged(filter) }
    }

    /** Wakes the agent, repeatedly if necessary, until [seen] returns true: see [Waker]. */
    internal fun wake(seen: () -> Boolean) = waker.wake(seen)

    override fun reasoningCycleStarting() {
        waker.cycleStarts()
        resuming?.cycleStarting()
        hasBegunCycle = false
        isBeginning = true
        pausing.cycleStarting()
        beginCycle()
        isBeginning = false
        super.reasoningCycleStarting()
    }

    private fun beginCycle() {
        if (!hasBegunCycle) boundary.cycleStarting(ts)
        hasBegunCycle = true
        boundary.orders(ordersLive, carryOut)
    }

    /**
     * Carries out the requests of observers while the agent is paused. Called by the agent's thread. If the agent is paused between two
     * cycles, waiting orders or requests begin the next cycle. If the agent is paused within a cycle, orders wait.
     */
    private fun takeOrders() {
        if (isBeginning && !(orders.isEmpty() && requests.isEmpty())) beginCycle()
        doRequests()
    }

    /** Returns all percepts. Returns null if neither boards, ports nor the Jason environment have news since the last call. */
    override fun perceive(): MutableCollection<Literal>? {
        waker.perceives()
        val perception = boundary.perceive(perceiveLive)
        waiting = perception.waiting
        return perception.percepts?.also { deleted.expect(ts.ag, it) }
    }

    private fun perceiveBoards(): Perception {
        val isEnvironmentNew = environment.update(super.perceive())
        val waiting = if (boards.areSeveral) ts.c.events.size else null
        val isBoardNew = perception.update()
        listOfNotNull(environment.dueInMs(), boards.dueInMs()).minOrNull()?.let(waker::wakeIn)
        if (!isEnvironmentNew && !isBoardNew) return NOTHING_NEW
        return Perception((environment.percepts + perception.beliefs()).toMutableList(), waiting)
    }

    /** Jason calls this function when it has added the events of the new percepts. */
    override fun checkMail() {
        deleted.mend(ts.c.events)
        waiting?.let { before -> takeTurns(ts.c.events, before) }
        waiting = null
        boundary.newlyCritical(criticalLive).takeIf { it.isNotEmpty() }?.let { bringForward(ts.c.events, it) }
        boundary.takeMail(mailLive)
    }

    override fun sendMsg(message: Message) = boundary.send(message) { super.sendMsg(message) }

    override fun broadcast(message: Message) = boundary.broadcast(message) { super.broadcast(message) }

    override fun act(action: ActionExec) = boundary.act(action) { super.act(it) }

    override fun canSleep(): Boolean = boundary.canSleep(sleepLive)

    /** Jason calls this function between the rules of its cycle. */
    override fun isRunning(): Boolean {
        val isRunning = super.isRunning()
        boundary.ruleApplied()
        return isRunning && !(waker.isInCycle && boundary.isHeld(holdLive))
    }

    override fun reasoningCycleFinished() {
        pausing.cycleFinished()
        boundary.cycleFinished()
        awaited.giveUpDropped(ts.c.pendingIntentions.keys)
        observing.each { it.cycleFinished() }
        waker.cycleEnds()
        if (ts.c.isAtomicIntentionSuspended) waker.sleepsUnasked()
        super.reasoningCycleFinished()
    }

    override fun stop() {
        observing.each { it.close() }
        if (::pausing.isInitialized) pausing.close()
        if (::boards.isInitialized) boards.ports.stop()
        if (!eachIsStopped) super.stop()
    }

    private val saved by lazy { SavedArch(this) }

    /** Java's serialization calls this function, and writes the returned object instead of the architecture. */
    protected fun writeReplace(): Any = saved

    /**
     * True if Jason itself stops each architecture of this agent. The Local infrastructure does; other infrastructures stop only the first
     * architecture. Some architectures cannot be stopped twice.
     */
    private val eachIsStopped get() = generateSequence(nextAgArch) { it.nextAgArch }.any { it is LocalAgArch }

    private companion object {
        val NOTHING_NEW = Perception(null)
    }
}
