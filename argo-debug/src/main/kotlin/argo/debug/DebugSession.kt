package argo.debug

import argo.observing.BreakpointOwner
import argo.observing.PauseState
import argo.observing.StopAt
import argo.observing.StopAt.Way
import org.eclipse.lsp4j.debug.Breakpoint
import org.eclipse.lsp4j.debug.BreakpointEventArguments
import org.eclipse.lsp4j.debug.Capabilities
import org.eclipse.lsp4j.debug.ConfigurationDoneArguments
import org.eclipse.lsp4j.debug.ContinueArguments
import org.eclipse.lsp4j.debug.ContinueResponse
import org.eclipse.lsp4j.debug.ContinuedEventArguments
import org.eclipse.lsp4j.debug.DisconnectArguments
import org.eclipse.lsp4j.debug.EvaluateArguments
import org.eclipse.lsp4j.debug.EvaluateResponse
import org.eclipse.lsp4j.debug.InitializeRequestArguments
import org.eclipse.lsp4j.debug.NextArguments
import org.eclipse.lsp4j.debug.OutputEventArguments
import org.eclipse.lsp4j.debug.PauseArguments
import org.eclipse.lsp4j.debug.ScopesArguments
import org.eclipse.lsp4j.debug.ScopesResponse
import org.eclipse.lsp4j.debug.SetBreakpointsArguments
import org.eclipse.lsp4j.debug.SetBreakpointsResponse
import org.eclipse.lsp4j.debug.SetExceptionBreakpointsArguments
import org.eclipse.lsp4j.debug.SetExceptionBreakpointsResponse
import org.eclipse.lsp4j.debug.StackTraceArguments
import org.eclipse.lsp4j.debug.StackTraceResponse
import org.eclipse.lsp4j.debug.StepInArguments
import org.eclipse.lsp4j.debug.StepOutArguments
import org.eclipse.lsp4j.debug.StoppedEventArguments
import org.eclipse.lsp4j.debug.TerminatedEventArguments
import org.eclipse.lsp4j.debug.Thread
import org.eclipse.lsp4j.debug.ThreadEventArguments
import org.eclipse.lsp4j.debug.ThreadsResponse
import org.eclipse.lsp4j.debug.VariablesArguments
import org.eclipse.lsp4j.debug.VariablesResponse
import org.eclipse.lsp4j.debug.services.IDebugProtocolClient
import org.eclipse.lsp4j.debug.services.IDebugProtocolServer
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode
import java.util.concurrent.CompletableFuture
import java.util.concurrent.Executors
import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.atomic.AtomicInteger
import java.util.logging.Level
import java.util.logging.Logger

/**
 * The session of one debugger. For the debugger, each agent is a thread. An intention of the agent is the stack of this thread, and the
 * intention's plans are the frames. The thread that reads from the debugger calls the functions of the protocol. Agents call back on their
 * threads. Another thread sends messages to the debugger, so agents do not wait for the debugger.
 *
 * @param agents the current agents; the list changes when agents begin or end
 */
internal class DebugSession(private val agents: List<AgentThread>) :
    IDebugProtocolServer,
    BreakpointOwner {
    /** The breakpoints in [file]: their [lines], by the number of the breakpoint. */
    private class InFile(val file: String, val lines: Map<Int, Int>)

    private val telling = Executors.newSingleThreadExecutor { run -> java.lang.Thread(run, "argo-debug-telling").apply { isDaemon = true } }
    private val followed = HashMap<AgentThread, AutoCloseable>() // guarded by itself
    private val numbers = AtomicInteger()
    private val frames = Frames { name -> files.keys.find { it.endsWith("/$name") || it.endsWith("\\$name") } }
    private lateinit var client: IDebugProtocolClient
    private var hangUp: () -> Unit = { }

    @Volatile
    private var files: Map<String, InFile> = emptyMap()

    /** Begins the session with [client]. [hangUp] ends the connection. */
    fun begin(client: IDebugProtocolClient, hangUp: () -> Unit) {
        this.client = client
        this.hangUp = hangUp
    }

    /** Tells the debugger that all agents have ended, and ends the connection. */
    fun hangUp() {
        tell { it.terminated(TerminatedEventArguments()) }
        tell { hangUp.invoke() }
    }

    override fun initialize(args: InitializeRequestArguments) = answer {
        Capabilities().apply {
            supportsConfigurationDoneRequest = true
            supportsEvaluateForHovers = true
            supportsSingleThreadExecutionRequests = true
        }
    }

    override fun attach(args: Map<String, Any>?) = answer<Void?> {
        tell { it.initialized() }
        null
    }

    override fun launch(args: Map<String, Any>?) =
        answer<Void?> { throw DebugException("start the agents yourself, with argo_debug=PORT, and have the debugger attach to that port") }

    override fun configurationDone(args: ConfigurationDoneArguments?) = answer<Void?> {
        agents.forEach(::follow)
        null
    }

    private fun follow(thread: AgentThread) {
        synchronized(followed) { followed.getOrPut(thread) { thread.pausing.follow { changed(thread, it) } } }
        thread.pausing.refusal?.let { why -> say("agent ${thread.agent.name} cannot be paused: $why") }
        if (thread.isPaused()) changed(thread, thread.pausing.state)
    }

    private fun changed(thread: AgentThread, state: PauseState) {
        if (thread.isPaused(state)) return stopped(thread, state)
        if (state.why != null) return // it will be paused when its boards are safe
        frames.forget(thread)
        tell { it.continued(ContinuedEventArguments().apply { threadId = thread.number }) }
    }

    private fun stopped(thread: AgentThread, state: PauseState) {
        say("${thread.agent.name}: ${state.why}; ${state.boards.joinToString("; ")}")
        val stop = StoppedEventArguments().apply {
            threadId = thread.number
            reason = state.why.takeIf { it == "breakpoint" || it == "step" } ?: "pause"
            description = state.why
            text = state.boards.joinToString("\n")
            allThreadsStopped = false
        }
        tell { it.stopped(stop) }
    }

    private fun say(line: String) = tell { it.output(OutputEventArguments().apply { output = "$line\n" }) }

    @Synchronized
    override fun setBreakpoints(args: SetBreakpointsArguments) = answer {
        val file = args.source.path ?: args.source.name ?: throw DebugException("a breakpoint is in a file")
        val lines = args.breakpoints.orEmpty().map { it.line }
        val its = InFile(file, lines.associateBy { numbers.incrementAndGet() })
        files = files + (file to its)
        val found = agents.map { it.pausing.breakAt(this, file, lines) }
        val answers = its.lines.keys.mapIndexed { place, number -> shown(number, args, found.map { it[place] }) }
        SetBreakpointsResponse().apply { breakpoints = answers.toTypedArray() }
    }

    /** Returns the breakpoint with this [number]. [found] are the agents' answers: where they have set it, or why not. */
    private fun shown(number: Int, args: SetBreakpointsArguments?, found: List<argo.observing.Breakpoint>) = Breakpoint().apply {
        id = number
        isVerified = found.any { it.line != null }
        line = found.firstNotNullOfOrNull { it.line } ?: found.firstOrNull()?.wanted
        source = args?.source
        if (!isVerified) message = found.firstOrNull()?.refusal ?: "no agent is there"
    }

    /** Tells the debugger the current lines of its breakpoints, and which breakpoints are lost. */
    @Synchronized
    override fun breakpointsChanged() {
        for (its in files.values) {
            val found = agents.map { agent -> agent.pausing.breakpoints(this).filter { it.file == its.file } }
            val now = its.lines.keys.mapIndexed { place, number -> shown(number, null, found.mapNotNull { it.getOrNull(place) }) }
            files = files + (its.file to InFile(its.file, now.associate { it.id to it.line }))
            now.forEach { breakpoint -> tell { it.breakpoint(changed(breakpoint)) } }
        }
    }

    override fun setExceptionBreakpoints(args: SetExceptionBreakpointsArguments?) = answer { SetExceptionBreakpointsResponse() }

    override fun threads() = answer {
        ThreadsResponse().apply { threads = agents.map(::shown).toTypedArray() }
    }

    private fun shown(thread: AgentThread) = Thread().apply {
        id = thread.number
        name = thread.agent.name
    }

    override fun stackTrace(args: StackTraceArguments) = answer {
        val all = thread(args.threadId).let { it.asking { frames.of(it) } }
        val first = args.startFrame ?: 0
        val levels = args.levels?.takeIf { it > 0 } ?: all.size
        StackTraceResponse().apply {
            stackFrames = all.drop(first).take(levels).toTypedArray()
            totalFrames = all.size
        }
    }

    override fun scopes(args: ScopesArguments) = answer { ScopesResponse().apply { scopes = frames.scopes(args.frameId).toTypedArray() } }

    override fun variables(args: VariablesArguments) =
        answer { VariablesResponse().apply { variables = frames.variables(args.variablesReference).toTypedArray() } }

    override fun evaluate(args: EvaluateArguments) = answer {
        val frame = args.frameId?.let(frames::frame)
        val thread = frame?.thread ?: agents.find { it.isPaused() } ?: throw DebugException("no agent is paused; pause one first")
        EvaluateResponse().apply { result = thread.asking { valueOf(args.expression, thread.agent.reasoning.ag, frame?.means?.unif) } }
    }

    override fun continue_(args: ContinueArguments) = answer {
        thread(args.threadId).pausing.goOn()
        ContinueResponse().apply { allThreadsContinued = false }
    }

    override fun next(args: NextArguments) = step(args.threadId, Way.OVER)

    override fun stepIn(args: StepInArguments) = step(args.threadId, Way.INTO)

    override fun stepOut(args: StepOutArguments) = step(args.threadId, Way.OUT)

    private fun step(number: Int, way: Way) = answer<Void?> {
        val thread = thread(number)
        val intention = thread.asking { thread.shown?.id }
        thread.pausing.goOnUntil(if (intention == null) StopAt.NextCycle else StopAt.Step(intention, way), this)
        null
    }

    override fun pause(args: PauseArguments) = answer<Void?> {
        val thread = thread(args.threadId)
        thread.pausing.refusal?.let { throw DebugException(it) }
        thread.pausing.pause(this)
        null
    }

    override fun disconnect(args: DisconnectArguments?) = answer<Void?> {
        end()
        null
    }

    private fun thread(number: Int) = agents.find { it.number == number } ?: throw DebugException("there is no agent $number any more")

    /** Tells the debugger that the agent [thread] has begun, and sets the breakpoints in this agent. */
    fun joined(thread: AgentThread) {
        for (its in files.values) {
            val found = thread.pausing.breakAt(this, its.file, its.lines.values.toList())
            its.lines.keys.zip(found).filter { (_, breakpoint) -> breakpoint.line != null }.forEach { (number, breakpoint) ->
                tell { it.breakpoint(changed(shown(number, null, listOf(breakpoint)))) }
            }
        }
        tell { it.thread(event("started", thread)) }
        if (synchronized(followed) { followed.isNotEmpty() }) follow(thread)
    }

    private fun changed(shown: Breakpoint) = BreakpointEventArguments().apply {
        reason = "changed"
        breakpoint = shown
    }

    private fun event(what: String, thread: AgentThread) = ThreadEventArguments().apply {
        reason = what
        threadId = thread.number
    }

    /** Tells the debugger that the agent [thread] has ended. */
    fun left(thread: AgentThread) {
        synchronized(followed) { followed.remove(thread) }?.close()
        tell { it.thread(event("exited", thread)) }
    }

    /** Ends the session. Agents forget its breakpoints. An agent continues if only this session has paused it. May be called twice. */
    fun end() {
        synchronized(followed) { followed.values.forEach(AutoCloseable::close) }
        agents.forEach { it.pausing.release(this) }
        telling.shutdown()
    }

    private fun tell(event: (IDebugProtocolClient) -> Unit) = try {
        telling.execute { event(client) }
    } catch (_: RejectedExecutionException) {
        // the session has ended
    }

    private fun <T> answer(find: () -> T): CompletableFuture<T> = try {
        CompletableFuture.completedFuture(find())
    } catch (refused: DebugException) {
        failed(refused.message)
    } catch (refused: IllegalArgumentException) {
        failed(refused.message)
    } catch (broken: Throwable) { // the agent's code may throw any exception
        LOG.log(Level.WARNING, "a request of a debugger has failed", broken)
        failed("$broken")
    }

    private fun <T> failed(why: String?): CompletableFuture<T> =
        CompletableFuture.failedFuture(ResponseErrorException(ResponseError(ResponseErrorCode.RequestFailed, why, null)))

    private companion object {
        val LOG: Logger = Logger.getLogger(DebugSession::class.java.name)
    }
}
