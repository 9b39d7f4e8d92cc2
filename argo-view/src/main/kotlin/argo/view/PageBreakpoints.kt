package argo.view

import argo.observing.ObservedAgent
import kotlinx.serialization.Serializable

/** The breakpoints that the pages of [agent] have set. Safe for use by several threads. */
internal class PageBreakpoints(private val agent: ObservedAgent) {
    /** The lines with breakpoints, and the lines that a reload has removed. */
    val all: List<BreakpointState>
        get() = agent.pausing.breakpoints(this).map { BreakpointState(it.file, it.line ?: it.wanted, it.refusal) }
            .distinct().sortedWith(compareBy({ it.file }, { it.line }))

    /** Sets a breakpoint at [line] of [file], or at a later line of its plan. Returns where the agent stops, or why it does not stop. */
    @Synchronized
    fun set(file: String, line: Int): HttpResponse {
        val before = linesOf(file)
        val breakpoint = agent.pausing.breakAt(this, file, before + line).last()
        keep(file, (before + listOfNotNull(breakpoint.line)).distinct())
        return if (breakpoint.line == null) HttpResponse.message(422, "$file:$line: ${breakpoint.refusal}")
        else HttpResponse.message(200, "the agent stops at $file:${breakpoint.line}")
    }

    @Synchronized
    fun remove(file: String, line: Int): HttpResponse {
        keep(file, linesOf(file) - line)
        return HttpResponse.message(200, "the agent does not stop at $file:$line")
    }

    private fun linesOf(file: String) = all.filter { it.file == file && it.lost == null }.map { it.line }

    private fun keep(file: String, lines: List<Int>) {
        agent.pausing.breakAt(this, file, lines)
    }
}

/** A line at which the agent stops. [lost] is the reason why the agent no longer stops there, or null. */
@Serializable
internal data class BreakpointState(val file: String, val line: Int, val lost: String? = null)
