package argo.debug

import org.eclipse.lsp4j.debug.BreakpointEventArguments
import org.eclipse.lsp4j.debug.ConfigurationDoneArguments
import org.eclipse.lsp4j.debug.ContinuedEventArguments
import org.eclipse.lsp4j.debug.DisconnectArguments
import org.eclipse.lsp4j.debug.EvaluateArguments
import org.eclipse.lsp4j.debug.InitializeRequestArguments
import org.eclipse.lsp4j.debug.OutputEventArguments
import org.eclipse.lsp4j.debug.ScopesArguments
import org.eclipse.lsp4j.debug.SetBreakpointsArguments
import org.eclipse.lsp4j.debug.Source
import org.eclipse.lsp4j.debug.SourceBreakpoint
import org.eclipse.lsp4j.debug.StackFrame
import org.eclipse.lsp4j.debug.StackTraceArguments
import org.eclipse.lsp4j.debug.StoppedEventArguments
import org.eclipse.lsp4j.debug.ThreadEventArguments
import org.eclipse.lsp4j.debug.Variable
import org.eclipse.lsp4j.debug.VariablesArguments
import org.eclipse.lsp4j.debug.launch.DSPLauncher
import org.eclipse.lsp4j.debug.services.IDebugProtocolClient
import org.eclipse.lsp4j.debug.services.IDebugProtocolServer
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException
import java.net.InetAddress
import java.net.Socket
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.ExecutionException
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit

/** A debugger at [port]. */
internal class Debugger(port: Int) : IDebugProtocolClient, AutoCloseable {
    private val socket = Socket(InetAddress.getLoopbackAddress(), port)
    private val launcher = DSPLauncher.createClientLauncher(this, socket.getInputStream(), socket.getOutputStream())
    val server: IDebugProtocolServer = launcher.remoteProxy
    val stops = LinkedBlockingQueue<StoppedEventArguments>()
    val told: MutableList<String> = CopyOnWriteArrayList()
    private val isReady = CompletableFuture<Unit>()

    init {
        launcher.startListening()
        server.initialize(InitializeRequestArguments()).value()
        server.attach(emptyMap()).value()
        isReady.value()
    }

    override fun initialized() {
        isReady.complete(Unit)
    }

    override fun stopped(args: StoppedEventArguments) = stops.put(args)

    override fun continued(args: ContinuedEventArguments) {
        told += "continued ${args.threadId}"
    }

    override fun thread(args: ThreadEventArguments) {
        told += "${args.reason} ${args.threadId}"
    }

    override fun breakpoint(args: BreakpointEventArguments) {
        told += args.breakpoint.run { "${args.reason} $id: " + if (isVerified) "$line" else message }
    }

    override fun output(args: OutputEventArguments) {
        told += args.output.trim()
    }

    /** Sets breakpoints. Returns for each its line, or the reason why there is none. */
    fun breakAt(file: String, vararg lines: Int): List<String> {
        val args = SetBreakpointsArguments().apply {
            source = Source().apply { path = file }
            breakpoints = lines.map { SourceBreakpoint().apply { line = it } }.toTypedArray()
        }
        return server.setBreakpoints(args).value().breakpoints.map { if (it.isVerified) "${it.line}" else it.message }
    }

    fun configured() = server.configurationDone(ConfigurationDoneArguments()).value()

    fun stop(): StoppedEventArguments = checkNotNull(stops.poll(PATIENCE_S, TimeUnit.SECONDS)) { "the agent has not stopped; $told" }

    fun frames(thread: Int): List<StackFrame> =
        server.stackTrace(StackTraceArguments().apply { threadId = thread }).value().stackFrames.toList()

    /** Returns the variables in [scope] of [frame], as text. */
    fun read(frame: StackFrame, scope: String): List<String> {
        val scopes = server.scopes(ScopesArguments().apply { frameId = frame.id }).value().scopes
        val reference = scopes.single { it.name == scope }.variablesReference
        val variables = server.variables(VariablesArguments().apply { variablesReference = reference }).value().variables
        return variables.map { it: Variable -> "${it.name} = ${it.value}" }
    }

    fun evaluate(text: String, frame: StackFrame? = null): String = said {
        val args = EvaluateArguments().apply {
            expression = text
            frameId = frame?.id
        }
        server.evaluate(args).value().result
    }

    fun disconnect() = server.disconnect(DisconnectArguments()).value()

    override fun close() {
        if (!socket.isOutputShutdown) socket.shutdownOutput()
    }
}

/** Returns the result of [ask], or the reason why it is refused. */
internal fun said(ask: () -> String): String = try {
    ask()
} catch (refused: ExecutionException) {
    (refused.cause as? ResponseErrorException)?.responseError?.message ?: throw refused
}

internal fun <T> CompletableFuture<T>.value(): T = get(PATIENCE_S, TimeUnit.SECONDS)

private const val PATIENCE_S = 60L
