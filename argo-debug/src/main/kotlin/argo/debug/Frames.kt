package argo.debug

import argo.observing.isHidden
import argo.observing.placeOf
import jason.asSemantics.IntendedMeans
import jason.asSemantics.Intention
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import org.eclipse.lsp4j.debug.Scope
import org.eclipse.lsp4j.debug.Source
import org.eclipse.lsp4j.debug.StackFrame
import org.eclipse.lsp4j.debug.Variable
import java.io.File
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicInteger

/**
 * The frames and variables of paused agents, by numbers that are valid until the agent continues. Safe for use by several threads.
 *
 * @param pathOf returns the debugger's path for a file with this name; null if the debugger has not named the file yet
 */
internal class Frames(private val pathOf: (name: String) -> String?) {
    /** A frame of [thread]. If [means] is null, the agent has no intentions. */
    class Frame(val thread: AgentThread, val means: IntendedMeans?)

    private class Children(val thread: AgentThread, val list: () -> List<Variable>)

    private val numbers = AtomicInteger()
    private val frames = ConcurrentHashMap<Int, Frame>()
    private val children = ConcurrentHashMap<Int, Children>()

    fun frame(number: Int): Frame = frames[number] ?: throw DebugException("the agent has gone on since")

    fun forget(thread: AgentThread) {
        frames.values.removeIf { it.thread === thread }
        children.values.removeIf { it.thread === thread }
    }

    /** Returns the frames of [thread], the latest plan first. Call this function on the agent's thread. */
    fun of(thread: AgentThread): List<StackFrame> {
        val intention = thread.shown ?: return listOf(frame(Frame(thread, null), "no intention"))
        return intention.map { means -> frame(Frame(thread, means), described(means)).at(means) }
    }

    private fun frame(frame: Frame, title: String) = StackFrame().apply {
        id = numbers.incrementAndGet().also { frames[it] = frame }
        name = title
    }

    private fun StackFrame.at(means: IntendedMeans) = apply {
        val place = placeOf(means.currentStep?.takeUnless { means.isFinished }, means.plan) ?: placeOf(means.plan) ?: return@apply
        line = place.line
        column = 1
        val file = File(place.file.removePrefix("file:"))
        source = Source().apply {
            name = file.name
            path = if (file.exists()) file.absoluteFile.normalize().path else pathOf(file.name) ?: place.file
        }
    }

    fun scopes(number: Int): List<Scope> {
        val frame = frame(number)
        val variables = frame.means?.let { means -> scope("Variables", frame.thread) { variablesOf(means.unif) } }
        return listOfNotNull(
            variables,
            scope("Beliefs", frame.thread) { beliefsOf(frame.thread) },
            scope("Intentions", frame.thread) { intentionsOf(frame.thread) },
        )
    }

    private fun scope(title: String, thread: AgentThread, list: () -> List<Variable>) = Scope().apply {
        name = title
        variablesReference = numbers.incrementAndGet().also { children[it] = Children(thread, list) }
        if (title == "Variables") presentationHint = "locals" else isExpensive = true
    }

    fun variables(number: Int): List<Variable> {
        val those = children[number] ?: throw DebugException("the agent has gone on since")
        return those.thread.asking(those.list)
    }

    private fun variablesOf(un: Unifier) =
        un.filterNot { it.functor.startsWith("_") }.sortedBy { it.functor }.map { variable(it.functor, "${it.capply(un)}") }

    private fun beliefsOf(thread: AgentThread) =
        thread.agent.beliefs.filterNot { it.isRule || it.isHidden }.map(::beliefOf).sortedBy { it.name }.limited()

    private fun beliefOf(belief: Literal) =
        variable("${belief.copy().apply { clearAnnots() }}", if (belief.hasAnnot()) "${belief.annots}" else "")

    private fun intentionsOf(thread: AgentThread) =
        thread.intentions.map { variable("${it.id}", "${it.joinToString(" for ", transform = ::described)}${stateOf(it)}") }.limited()

    private fun stateOf(intention: Intention) = if (intention.isSuspended) ", waits for ${intention.suspendedReason}" else ""

    private fun described(means: IntendedMeans) = means.trigger.run { "$operator$type${literal.copy().apply { clearAnnots() }}" }

    private fun variable(title: String, text: String) = Variable().apply {
        name = title
        value = text
    }

    private fun List<Variable>.limited() =
        if (size <= MOST) this else take(MOST) + variable("…", "${size - MOST} more; ask for some by a formula, such as dist(_,X)")

    private companion object {
        const val MOST = 500
    }
}
