package argo.recording.recorder

import argo.boundary.Boundary
import argo.boundary.CompletionInbox
import argo.boundary.InternalCall
import argo.boundary.Overlaps
import argo.boundary.Perception
import argo.filters.PerceptionFilter
import argo.insides.IncludeDirective
import argo.insides.Includes
import argo.insides.Insides
import argo.observing.AgentObserver
import argo.observing.CommandFailure
import argo.observing.EndedReflex
import argo.observing.IssuedCommand
import argo.observing.ObservedAgent
import argo.observing.Order
import argo.observing.PerceivedMessage
import argo.observing.RuleWatcher
import argo.recording.CallFailure
import argo.recording.CommandEnd
import argo.recording.End
import argo.recording.FilterChange
import argo.recording.PerceivedSnapshot
import argo.recording.ReflexEnd
import argo.recording.agent.CallWatch
import argo.recording.agent.Counters
import argo.recording.agent.CourseWatch
import argo.recording.agent.JasonActions
import argo.recording.agent.Keeper
import argo.recording.agent.KeptAction
import argo.recording.agent.PendingOperations
import argo.recording.agent.ProgramNames
import argo.recording.agent.RecordedFailure
import argo.recording.agent.UnknownCodeException
import argo.recording.agent.WatchedCode
import argo.recording.agent.WatchedKind
import argo.recording.agent.bound
import argo.recording.agent.callFailure
import argo.recording.agent.complete
import argo.recording.agent.errorsOf
import argo.recording.agent.evaluationFailure
import argo.recording.agent.failureOf
import argo.recording.agent.given
import argo.recording.agent.literalText
import argo.recording.agent.mailOf
import argo.recording.agent.thrownFailure
import argo.recording.agent.triggerText
import argo.recording.agent.watch
import jason.JasonException
import jason.asSemantics.ActionExec
import jason.asSemantics.Agent
import jason.asSemantics.ConcurrentInternalAction
import jason.asSemantics.Event
import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.Pred
import jason.asSyntax.Term
import jason.util.RunnableSerializable
import java.util.concurrent.Callable
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.atomic.AtomicInteger
import java.util.logging.Logger

/**
 * Records the cycles of one agent to [channels]. Notes all input of a cycle at the agent's boundary. An operation that the agent has begun
 * outside of its thread ends only at the beginning of a cycle.
 */
internal class Recorder(
    private val agent: ObservedAgent,
    private val program: StoredProgram,
    private val channels: AgentChannels,
    private val log: Logger,
) : AgentObserver, Boundary, Keeper, CallWatch, Includes {
    /** The end of an operation, which waits for the next cycle. If another thread left the operation, [work] carries it out. */
    private class Arrived(val end: End, val work: Runnable? = null)

    private val inbox = CompletionInbox<Arrived>(agent::wakeUntil)
    private val pending = PendingOperations()
    private val works = AtomicInteger() // the number of works that wait in the inbox
    private var running: Running? = null

    @Volatile
    private var isRefused = false
    private val filters = StoredFilters(agent.name, channels::attach)
    private val inCalls: MutableSet<Long> = ConcurrentHashMap.newKeySet() // numbers of unfinished commands that calls have sent

    @Volatile
    private var inCycle: Thread? = null

    @Volatile
    private var unstored: Thread? = null // the thread of a cycle that the channels have not received yet

    @Volatile
    private var isStopped = false

    private inner class Running(val ts: TransitionSystem, val code: WatchedCode) {
        val course = CourseWatch(ts)
        val keyFrames = KeyFrames(ts, course)
        var percepts: List<Literal> = emptyList()
        var counters: List<Int> = emptyList()
        val events = ForeignEvents({ ts.c.events + listOfNotNull(Insides.atomicEvent[ts.c]) }) { inCycle === Thread.currentThread() }
            .also(ts.c::addEventListener)
        var isLast = false // whether the recording ends with the current cycle
        var beliefs = -1
        var cycles = 0L
        var number = 0 // Jason's number of the current cycle
        var overlap = 0L
        lateinit var now: CycleNotes // notes of the current cycle
    }

    override fun cycleStarting(ts: TransitionSystem) {
        val agent = running ?: begin(ts) ?: return
        if (inCycle != null) endOpenCycle(agent)
        if (isRefused) return carryOutEnds(agent)
        agent.now = CycleNotes(this.agent.nanos())
        noteUnknownCode(agent)
        agent.number = ts.agArch.cycleNumber
        agent.overlap = Overlaps.begin()
        inCycle = Thread.currentThread()
        unstored = inCycle
        IncludeDirective.current = this
        if (!Counters.isAt(agent.counters)) agent.counters = Counters.read().also { agent.now.counters = it }
        agent.now.isChangedOutside = agent.beliefs >= 0 && ts.ag.bb.size() != agent.beliefs
        refuseForeignBeliefs(agent)
        noteEvents(agent.now, agent.events.take(), ts)
        agent.now.isAtWork = ts.c.hasRunningIntention() || ts.c.hasEvent() || ts.c.hasMsg() || ts.c.hasFeedbackAction()
        agent.course.begin()
        carryOutEnds(agent)
        Keeper.begin(this, ts)
    }

    private fun noteEvents(now: CycleNotes, events: List<Event>, ts: TransitionSystem) {
        if (events.isEmpty()) return
        val queue = ts.c.events.toList()
        now.events = events.map { triggerText(it.trigger) }
        now.eventPlaces = events.indices.associateWith { number -> queue.indexOfFirst { it === events[number] } }
            .filter { (number, place) -> place >= 0 && place != queue.size - events.size + number }
    }

    /** Ends the agent's recording with a cycle that an error has ended. The rest of the cycle is not known. */
    private fun endOpenCycle(agent: Running) {
        finishCycle(agent, isEnding = true)
        log.severe("argo_record: an error ended cycle ${agent.number} of agent ${this.agent.name}; its recording ends there")
        end(agent)
    }

    private fun end(agent: Running) {
        isRefused = true
        unstored = null
        agent.ts.c.removeEventListener(agent.events)
        channels.close()
    }

    /** If added code cannot be watched, notes that the recording of the agent ends with this cycle. */
    private fun noteUnknownCode(agent: Running) = try {
        agent.code.watchAdded()
    } catch (unknown: UnknownCodeException) {
        agent.now.refuse("${unknown.message}", isOfProject = false)
        agent.isLast = true
        channels.told += "${unknown.message}"
        log.severe("argo_record: ${unknown.message}$WITHOUT")
    }

    /**
     * Refuses the cycle if a thread of the project has changed the agent's beliefs. Events of another thread are no obstacle, since a
     * replay has all events.
     */
    private fun refuseForeignBeliefs(agent: Running) {
        if (agent.now.isChangedOutside || agent.events.addBeliefs(agent.ts.ag.bb)) {
            agent.now.refuse("a thread of the project has changed what agent ${this.agent.name} believes")
        }
    }

    /**
     * Carries out the arrived ends of operations, before Jason begins the cycle. If an end resumes an intention, the intention continues in
     * this cycle, as it would without a recording.
     */
    private fun carryOutEnds(agent: Running) {
        if (inbox.isEmpty()) return
        Keeper.within(this) {
            for (arrived in inbox.takeAll()) {
                if (!isRefused) {
                    agent.now.ends += arrived.end
                    agent.keyFrames.ended(arrived.end.number)
                }
                val work = arrived.work
                if (work == null) pending.carryOut(arrived.end) else carryOut(agent, arrived.end, work)
            }
        }
    }

    private fun carryOut(agent: Running, end: End, work: Runnable) {
        works.decrementAndGet()
        if (end.kind != WORK) work.run()
        else unchanged(agent, { "work that the thread ${end.thread} left has changed the agent" }, work::run)
    }

    /** Does the project's [work]. If the work changes the agent, refuses the cycle with [why], since a replay does not repeat the work. */
    private inline fun <T> unchanged(agent: Running, why: () -> String, work: () -> T): T {
        if (isRefused) return work()
        val before = MindSizes.of(agent.ts)
        val events = agent.events.size
        return work().also {
            val isOfThread = agent.events.size != events
            if (!isOfThread && MindSizes.of(agent.ts) != before) agent.now.refuse(why())
        }
    }

    private fun begin(ts: TransitionSystem): Running? {
        if (isRefused) return null
        refusal(ts)?.let { return refused(it) }
        val code = try {
            watch(ts)
        } catch (unknown: UnknownCodeException) {
            return refused("${unknown.message}")
        }
        return Running(ts, code).also { running = it }
    }

    private fun refused(why: String): Running? {
        log.severe("argo_record: $why$WITHOUT")
        isRefused = true
        return null
    }

    override fun include(directive: Pred, outer: Agent, live: () -> Agent?): Agent? {
        current()?.let {
            program.include(IncludeDirective.fileOf(directive), outer.aslSrc, IncludeDirective.placeOf(outer, it.ts.ag))
            it.code.included()
        }
        return live()
    }

    override fun orders(live: () -> List<Order>, carryOut: (Order) -> Unit) {
        val agent = current() ?: return live().forEach(carryOut)
        val orders = live()
        if (orders.isEmpty()) return
        agent.now.orders += orders.map(::given)
        Keeper.within(this) { orders.forEach(carryOut) }
        orders.filterIsInstance<Order.Reload>().forEach { reloaded(agent, it) }
    }

    private fun reloaded(agent: Running, order: Order.Reload) {
        order.files.firstNotNullOfOrNull { foreignDirective(ProgramNames(it.text)) }?.let { agent.now.refuse(it, isOfProject = false) }
        agent.code.included()
        noteUnknownCode(agent)
        agent.course.forgetPlaces()
        agent.keyFrames.reloaded()
    }

    override fun perceive(live: () -> Perception): Perception = live().also { perception ->
        val agent = current() ?: return@also
        val percepts = perception.percepts?.toList() ?: return@also
        agent.now.percepts = changed(agent.percepts, percepts)
        agent.now.isOfSeveralBoards = perception.waiting != null
        agent.percepts = percepts
        agent.keyFrames.perceived(percepts.size)
    }

    override fun newlyCritical(live: () -> List<Literal>) = live().also { current()?.now?.critical = it.map(::literalText) }

    override fun takeMail(live: () -> Unit) {
        val agent = current() ?: return live()
        val before = agent.ts.c.mailBox.size
        live()
        if (agent.ts.c.mailBox.size > before) {
            for (message in agent.ts.c.mailBox.drop(before)) {
                agent.now.mail += mailOf(message)
                agent.code.received(message.propCont)
            }
        }
        Keeper.current = this
    }

    override fun call(call: InternalCall, live: () -> Any): Any = call(call, WatchedKind.OUTSIDE) { live() }

    override fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any {
        val agent = current() ?: return live(call.un)
        val note = CallNote(call.name, call.args, code.isOfProject)
        agent.now.calls += note
        val around = agent.now.underWay
        agent.now.underWay = note
        try {
            return noting(note, call, if (code.isOfProject) ofProject(agent, call, code, live) else live(call.un))
        } catch (failed: JasonException) {
            note.failure = callFailure(failed)
            throw failed
        } catch (broken: Exception) { // a mistake in an action: Jason logs it, and the plan fails
            note.failure = thrownFailure(broken)
            throw broken
        } finally {
            agent.now.underWay = around
        }
    }

    private fun ofProject(agent: Running, call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any {
        if (code == WatchedKind.SUSPENDING) {
            agent.now.refuse("the project's action ${call.name} has a thread resume its intention")
            return live(call.un)
        }
        return unchanged(agent, { "the project's action ${call.name} changes the agent besides its result" }) { live(call.un) }
    }

    /**
     * Refuses the cycle if an action of the project is under way, since a replay does not carry it out. [does] is the effect of the action.
     */
    private fun refuseIfOfProject(agent: Running, does: String) {
        val call = agent.now.underWay?.takeIf { it.isOfProject } ?: return
        agent.now.refuse("the project's action ${call.name} $does besides its result")
    }

    private fun noting(note: CallNote, call: InternalCall, result: Any): Any {
        if (result == true) note.answered(bound(call))
        if (result !is Iterator<*>) return result
        note.isBacktracking = true
        return iterator {
            for (un in result) {
                if (!note.answered(bound(call, un as Unifier))) {
                    current()?.now?.refuse("a loop goes on with results of ${note.name} from an earlier cycle", isOfProject = false)
                }
                yield(un)
            }
        }
    }

    override fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double {
        val agent = current() ?: return live()
        val note = CallNote(name, args, isOfProject)
        try {
            return live().also { note.value = "$it" }
        } catch (failed: Exception) { // Jason reports the failure and continues
            note.failure = evaluationFailure(failed)
            throw failed
        } finally {
            agent.now.calls += note
        }
    }

    override fun suspended(complete: (CommandFailure?, String?) -> Unit): (CommandFailure?, String?) -> Unit {
        val agent = current() ?: return complete
        val number = pending.begin { end -> complete(end.failure?.let(::RecordedFailure), end.answer) }
        agent.now.underWay?.number = number
        return { failure, answer -> inbox.put(Arrived(End(number, CALL, failure?.run { CallFailure(error, cause) }, answer = answer))) }
    }

    override fun <V> timer(work: Callable<V>, delayNs: Long, schedule: (Callable<V>) -> ScheduledFuture<V>): ScheduledFuture<V> {
        val number = pending.begin { work.call() }
        current()?.run { keyFrames.timer(number, now.ns, delayNs) }
        return schedule(Callable { null.also { inbox.put(Arrived(End(number, TIMER))) } })
    }

    /** Takes [work]. In a replay Jason's own classes leave this work again, except the end of an action of the project. */
    override fun left(work: RunnableSerializable) {
        val type = work.javaClass
        val isOfProject = !JasonActions.isOwn(type) || type.name.startsWith(ConcurrentInternalAction::class.java.name)
        works.incrementAndGet()
        inbox.put(Arrived(End(0, if (isOfProject) WORK else THREAD, thread = Thread.currentThread().name), work))
    }

    override fun act(action: ActionExec, live: (ActionExec) -> Unit) {
        val agent = current() ?: return live(action)
        refuseIfOfProject(agent, "acts in the environment")
        val number = pending.begin { end ->
            complete(action, end)
            running?.ts?.c?.addFeedbackAction(action)
        }
        live(KeptAction(action) { inbox.put(Arrived(End(number, ACTION, failureOf(it)))) })
    }

    override fun send(message: Message, live: () -> Unit) = sending(message, live)

    override fun broadcast(message: Message, live: () -> Unit) = sending(message.clone().apply { receiver = receiver ?: EVERYBODY }, live)

    private fun sending(message: Message, live: () -> Unit) {
        val agent = current()
        if (agent == null || agent.now.isSending) return live() // an infrastructure may split a broadcast into single messages
        refuseIfOfProject(agent, "sends a message")
        agent.now.isSending = true
        val mail = mailOf(message) // noted first, since the receiver's thread may change the terms
        try {
            live()
            agent.course.sent(mail.copy(sender = message.sender))
        } catch (failed: JasonException) {
            agent.course.sent(mail.copy(sender = message.sender, failure = failed.message.orEmpty(), errors = errorsOf(failed)))
            throw failed
        } finally {
            agent.now.isSending = false
        }
    }

    override fun canSleep(live: () -> Boolean): Boolean =
        (live() && inbox.isEmpty()).also { current()?.now?.sleep?.append(if (it) 'y' else 'n') }

    override fun ruleApplied() {
        current()?.course?.ruleApplied()
    }

    override fun isHeld(live: () -> Boolean): Boolean = live().also { if (it) current()?.now?.isHeld = true }

    override fun <T> asking(ask: () -> T): T {
        val around = inCycle
        inCycle = null
        try {
            return ask()
        } finally {
            inCycle = around
        }
    }

    override fun cycleFinished() {
        val agent = current() ?: return
        finishCycle(agent, isEnding = !agent.ts.agArch.isRunning)
        unstored = null
        if (isStopped) leave()
    }

    private fun finishCycle(agent: Running, isEnding: Boolean) {
        inCycle = null
        Keeper.current = null
        IncludeDirective.current = null
        val course = agent.course.end()
        val now = agent.now
        agent.ts.c.selectedEvent?.takeIf(agent.events::takeSelected)?.let { now.events += triggerText(it.trigger) }
        agent.beliefs = agent.ts.ag.bb.size()
        refuseForeignBeliefs(agent)
        val isAlone = Overlaps.end(agent.overlap)
        if (!isAlone) noteCounters(agent, course.firstMessage)
        val isRecorded = !now.isNothing() || now.isAtWork || course.hasHappened
        agent.counters = whereLeft(agent, isAlone, isRecorded)
        if (!isRecorded) return
        now.end()
        val cycle = CycleNote(++agent.cycles, agent.number, now, course, isEnding, agent.course.missesPrints)
        channels.cycle(cycle)
        if (agent.isLast) end(agent) else if (!isEnding) takeKeyFrame(agent, cycle)
    }

    /** Returns the counters that a replay has after this cycle. An empty list means that the next recorded cycle must contain them. */
    private fun whereLeft(agent: Running, isAlone: Boolean, isRecorded: Boolean): List<Int> = when {
        !isAlone || !isRecorded && agent.now.counters != null -> emptyList()
        Counters.isAt(agent.counters) -> agent.counters
        else -> if (isRecorded) Counters.read() else emptyList()
    }

    /** Notes the counters as they were before this agent took its own numbers. Other agents have also taken numbers in this cycle. */
    private fun noteCounters(agent: Running, message: String?) {
        val start = agent.counters
        val c = agent.ts.c
        val last = Counters.lastIntention(start)
        val own = c.allIntentions.asSequence() + listOfNotNull(c.selectedIntention)
        val first = if (Counters.hasNewIntentions(start)) own.map { it.id }.filter { it > last }.minOrNull() else null
        Counters.before(start, first, message).let { if (it != start) agent.now.counters = it }
    }

    private fun takeKeyFrame(agent: Running, cycle: CycleNote) {
        if (agent.events.size > 0 || works.get() > 0) return // waiting events and work belong to the next cycle
        val note = agent.keyFrames.take(cycle, pending.last, pending.numbers, agent.percepts) ?: return
        channels.keyFrame(note)
        if (note.isThere) agent.counters = emptyList() // the next cycle then contains all counters, for a replay that begins with it
    }

    private fun current() = if (inCycle === Thread.currentThread()) running else null

    override fun messagePerceived(message: PerceivedMessage) {
        val agent = current() ?: return
        val kept = message.kept.takeIf { it != message.texts }
        agent.now.snapshots += PerceivedSnapshot(message.portName, message.namespace, message.receivedNanos, message.texts, kept)
    }

    override fun filterChanged(filter: PerceptionFilter?) = changed(null, filter)

    override fun boardFilterChanged(port: String, filter: PerceptionFilter?) = changed(port, filter)

    private fun changed(port: String?, filter: PerceptionFilter?) {
        val agent = current() ?: return
        val change = FilterChange(port, filter?.name, filter?.let(filters::store))
        agent.now.filters += change
        agent.keyFrames.filterChanged(change)
    }

    override fun commandIssued(command: IssuedCommand) {
        val call = current()?.now?.underWay ?: return
        call.sent(command)
        inCalls += command.number
    }

    override fun commandEnded(command: IssuedCommand, failure: CommandFailure?) {
        val isInCall = inCalls.remove(command.number)
        val end = CommandEnd(command.number, ns = agent.nanos(), failure = failure?.run { CallFailure(error, cause) })
        channels.ended(if (isInCall) end else end.copy(port = command.port, text = command.text, issuedNs = command.issuedNanos))
    }

    override fun reflexEnded(reflex: EndedReflex) {
        val (rule, watcher, failure, ns) = reflex
        val command = rule.reflex ?: return
        channels.ended(
            ReflexEnd(command, "${rule.rule}", watcher == RuleWatcher.BOARD, ns, failure?.run { CallFailure(error, cause) }),
        )
    }

    override fun recordWanted(why: String): Boolean = channels.save(why, agent.nanos())

    /**
     * Ends this agent's part of the recording. During a cycle of the agent, waits for the cycle's end: the agent's thread ends the part.
     */
    override fun close() {
        isStopped = true
        if (unstored?.isAlive == true) return
        if (inCycle != null) running?.let(::endOpenCycle) // an error ended the cycle and the agent's thread
        leave()
    }

    private fun leave() {
        running?.course?.close()
        channels.close()
    }

    companion object {
        const val CALL = "call"
        const val TIMER = "timer"
        const val ACTION = "action"
        const val THREAD = "thread"
        const val WORK = "work"
        const val EVERYBODY = "everybody"
        const val WITHOUT = "; the agent runs without a recording from now on"
    }
}

internal fun changed(before: List<Literal>, now: List<Literal>): PerceptNote {
    val most = minOf(before.size, now.size)
    var keep = 0
    while (keep < most && isSame(before[keep], now[keep])) keep++
    var keepLast = 0
    while (keepLast < most - keep && isSame(before[before.size - 1 - keepLast], now[now.size - 1 - keepLast])) keepLast++
    return PerceptNote(keep, now.subList(keep, now.size - keepLast), keepLast)
}

private fun isSame(one: Literal, other: Literal) = one === other || one == other && !one.hasAnnot() && !other.hasAnnot()
