package argo.recording.replay

import argo.boundary.Boundary
import argo.boundary.InternalCall
import argo.boundary.Perception
import argo.insides.Insides
import argo.observing.CommandFailure
import argo.observing.Order
import argo.recording.Call
import argo.recording.Course
import argo.recording.Cycle
import argo.recording.KeyFrame
import argo.recording.Mail
import argo.recording.agent.CallWatch
import argo.recording.agent.Counters
import argo.recording.agent.CourseWatch
import argo.recording.agent.Keeper
import argo.recording.agent.ProgramNames
import argo.recording.agent.ProgramParts
import argo.recording.agent.RecordedFailure
import argo.recording.agent.UnknownCodeException
import argo.recording.agent.UnrecordableTerm
import argo.recording.agent.WatchedCode
import argo.recording.agent.WatchedKind
import argo.recording.agent.complete
import argo.recording.agent.contentOf
import argo.recording.agent.exception
import argo.recording.agent.literalOf
import argo.recording.agent.mailOf
import argo.recording.agent.orderOf
import argo.recording.agent.triggerOf
import argo.recording.agent.watch
import jason.asSemantics.ActionExec
import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import jason.util.RunnableSerializable
import java.util.concurrent.Callable
import java.util.concurrent.ScheduledFuture

/** Gives an agent its recorded input, cycle by cycle. [answers] answers the agent's questions, and ends its operations. */
internal class ReplayedInputs(
    private val answers: Answers,
    private val sensed: ReplayedPercepts = RecordedPercepts(),
) : Boundary, Keeper, CallWatch {
    private val ids = HashMap<String, String>() // the id of each message in this replay, by its recorded id
    private var counters: List<Int> = emptyList() // counters after the agent's last cycle
    private var sleep = ArrayDeque<Char>()
    private var isAsking = false
    private lateinit var code: WatchedCode

    /** The agent's transition system. [begin] sets it. */
    lateinit var ts: TransitionSystem
        private set

    /** The replayed cycle, or an additional cycle of the agent. */
    lateinit var cycle: Cycle
        private set

    lateinit var course: CourseWatch
        private set

    /**
     * Begins the agent of [ts] at the beginning of its program or at [start]. Jason has already read the program. If the agent of [ts] has
     * another program, [recorded] is the agent with the recorded program.
     */
    fun begin(ts: TransitionSystem, start: KeyFrame? = null, recorded: TransitionSystem? = null) {
        this.ts = ts
        course = CourseWatch(ts)
        val program = ProgramParts((recorded ?: ts).ag)
        code = guarded(ts) { watch(ts) }
        if (recorded != null) guarded(recorded) { watch(recorded) } // started intentions consist of recorded plans
        val timers = start?.let { KeyFrameRestoration(it, ts, program, code, course, isProgram = recorded == null).restore() }
        start?.perceived?.map(::literalOf)?.let(sensed::begin)
        answers.begin(this, start, timers.orEmpty())
    }

    /**
     * Calls [watch] for the code of the agent of [ts], and watches the code that the agent looks up later. Throws [RecordingException] if
     * code cannot be watched.
     */
    private fun guarded(ts: TransitionSystem, watch: () -> WatchedCode): WatchedCode = try {
        watch().also { (ts.ag as GuardedAgent).begin(it, this) }
    } catch (unknown: UnknownCodeException) {
        throw RecordingException("the recording of agent ${ts.agArch.agName} cannot be replayed: ${unknown.message}")
    }

    fun next(cycle: Cycle) {
        this.cycle = cycle
        Counters.write(cycle.counters?.takeIf { answers.isAsRecorded } ?: counters) // another agent may have changed Jason's counters
        sleep = ArrayDeque(if (answers.isAsRecorded) cycle.input.sleep.toList() else emptyList())
        answers.next(cycle)
        cycle.input.events.forEachIndexed { number, text ->
            reading("events") { triggerOf(text) }?.let { addEvent(it, cycle.input.eventPlaces[number]) }
        }
    }

    private fun addEvent(trigger: Trigger, place: Int?) {
        ts.c.addExternalEv(trigger)
        if (place == null) return
        val queue = ts.c.events.toMutableList()
        queue.add(place.coerceIn(queue.indices), queue.removeAt(queue.lastIndex))
        ts.c.events.clear()
        ts.c.events.addAll(queue)
    }

    override fun cycleStarting(ts: TransitionSystem) {
        course.begin()
        guarded(ts) { code.apply { watchAdded() } }
        Keeper.within(this) { answers.carryOut(cycle) }
        Keeper.begin(this, ts)
    }

    override fun orders(live: () -> List<Order>, carryOut: (Order) -> Unit) {
        if (cycle.input.orders.isEmpty()) return
        val orders = cycle.input.orders.map(::orderOf).filter { answers.isOfRecordedProgram || it !is Order.Reload }
        orders.filterIsInstance<Order.Reload>().flatMap { it.files }.flatMap { ProgramNames(it.text).classes }
            .forEach(GuardedAgent::requireCode)
        Keeper.within(this) { orders.forEach(carryOut) }
        if (orders.none { it is Order.Reload }) return
        guarded(ts) {
            code.apply {
                included()
                watchAdded()
            }
        }
        course.forgetPlaces()
    }

    override fun perceive(live: () -> Perception): Perception {
        val percepts = reading("percepts") { sensed.perceive(cycle) } ?: return Perception(null)
        return Perception(percepts.toMutableList(), if (cycle.input.isOfSeveralBoards) ts.c.events.size else null)
    }

    override fun newlyCritical(live: () -> List<Literal>) = sensed.takeNewlyCritical()

    override fun takeMail(live: () -> Unit) {
        cycle.input.mail.forEach { mail -> reading("message of ${mail.sender}") { messageOf(mail) }?.let(ts.c::addMsg) }
        Keeper.current = this
    }

    private fun messageOf(mail: Mail): Message {
        val content = contentOf(mail.content, ts.ag)
        return Message(mail.performative, mail.sender, mail.receiver, content, mail.id).apply {
            inReplyTo = mail.inReplyTo?.let { ids[it] ?: it }
        }
    }

    /** Returns the result of [read], which reads recorded texts. Returns null if a text replaces a term that no recording can contain. */
    private fun <T : Any> reading(what: String, read: () -> T?): T? = try {
        read()
    } catch (refused: UnrecordableTerm) {
        null.also { answers.refused(what, refused) }
    }

    /**
     * Calls [ask], which only reads, and changes nothing. The calls in [ask] get the results recorded in this cycle, and do not count as
     * the agent's calls. For the agent's thread.
     */
    override fun <T> asking(ask: () -> T): T {
        val around = isAsking
        val counters = Counters.read()
        isAsking = true
        try {
            return ask()
        } finally {
            isAsking = around
            Counters.write(counters)
        }
    }

    override fun call(call: InternalCall, live: () -> Any): Any = call(call, WatchedKind.OUTSIDE) { live() }

    override fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any {
        if (!isAsking) return reading("result of ${call.name}") { answers.call(call, code, live) } ?: false
        val recorded = asked(call.name, call.args)
        return if (recorded == null || recorded.failure != null || recorded.number != null) false else answer(recorded, call)
    }

    override fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double {
        if (!isAsking) return answers.evaluate(name, args, isOfProject, live)
        return asked(name, args)?.valueOrFailure() ?: if (isOfProject) Double.NaN else live()
    }

    private fun asked(name: String, args: Array<Term>): Call? =
        compared(args.asList()).let { texts -> cycle.input.calls.find { it.isOf(name, texts) } }

    override fun suspended(complete: (CommandFailure?, String?) -> Unit): (CommandFailure?, String?) -> Unit {
        answers.begun(BegunWork(cycle, "call", answers.suspending, 0) { complete(it.failure?.let(::RecordedFailure), it.answer) })
        return { _, _ -> }
    }

    override fun <V> timer(work: Callable<V>, delayNs: Long, schedule: (Callable<V>) -> ScheduledFuture<V>): ScheduledFuture<V> {
        val future = Unscheduled(work)
        answers.begun(BegunWork(cycle, "timer", "$delayNs", delayNs, future::isCancelled) { work.call() })
        return future
    }

    override fun left(work: RunnableSerializable) = answers.left(work)

    override fun act(action: ActionExec, live: (ActionExec) -> Unit) {
        val work = BegunWork(cycle, "action", "${action.actionTerm}", 0) { end ->
            complete(action, end)
            ts.c.addFeedbackAction(action)
        }
        answers.begun(work)
    }

    override fun send(message: Message, live: () -> Unit) = sending(message)

    override fun broadcast(message: Message, live: () -> Unit) = sending(message.clone().apply { receiver = receiver ?: "everybody" })

    private fun sending(message: Message) {
        val now = mailOf(message)
        val recorded = answers.sent(now)
        recorded?.let { ids[it.id] = message.msgId }
        course.sent(now.copy(failure = recorded?.failure, errors = recorded?.errors.orEmpty()))
        recorded?.exception()?.let { throw it }
    }

    override fun canSleep(live: () -> Boolean): Boolean = sleep.removeFirstOrNull() != 'n' && !answers.isHeldAwake

    override fun ruleApplied() {
        if (::course.isInitialized && Keeper.current === this) course.ruleApplied()
    }

    override fun isHeld(live: () -> Boolean): Boolean {
        live() // a debugger may pause the replay here
        return cycle.input.isHeld && Insides.isBeforeIntention(ts)
    }

    override fun cycleFinished() {
        Keeper.current = null
        counters = Counters.read()
        answers.cycleFinished()
    }

    fun end(): Course {
        sleep.clear()
        return course.end().course()
    }
}
