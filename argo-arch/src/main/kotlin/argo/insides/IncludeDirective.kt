package argo.insides

import jason.asSemantics.Agent
import jason.asSyntax.Pred
import jason.asSyntax.StringTerm
import jason.asSyntax.directives.DirectiveProcessor
import jason.asSyntax.directives.Include
import jason.runtime.SourcePath

/** Handles the files that an agent includes when it starts, at run time or at a reload. */
interface Includes {
    /** Returns the content that [directive] includes into [outer]; null if there is none. [live] makes Jason find and read the file. */
    fun include(directive: Pred, outer: Agent, live: () -> Agent?): Agent?

    /** Returns a new agent, which reads an included file. */
    fun agent(): Agent = Agent()
}

/**
 * Replaces Jason's directive `include`, which the action `.include` also calls. The calling thread's [current] handler does the work. If
 * the thread has no handler, Jason's own directive does the work.
 */
class IncludeDirective private constructor(private val below: Include) : Include() {
    override fun process(directive: Pred, outer: Agent?, inner: Agent?): Agent? {
        val includes = CURRENT.get()
        return if (outer == null || includes == null) below.process(directive, outer, inner)
        else includes.include(directive, outer) { below.process(directive, outer, inner) }
    }

    override fun setSourcePath(path: SourcePath) = below.setSourcePath(path)

    override fun getSourcePaths(): SourcePath = below.sourcePaths

    companion object {
        private const val NAME = "include"
        private val CURRENT = ThreadLocal<Includes?>()

        /** Handles the files that the calling thread includes. If null, Jason's own directive handles them. */
        var current: Includes?
            get() = CURRENT.get()
            set(includes) = if (includes == null) CURRENT.remove() else CURRENT.set(includes)

        inline fun <T> within(includes: Includes, work: () -> T): T {
            val around = current
            current = includes
            try {
                return work()
            } finally {
                current = around
            }
        }

        @Synchronized
        fun install() {
            val below = DirectiveProcessor.getDirective(NAME) as Include
            if (below is IncludeDirective) return
            Insides.directives[null][NAME] = IncludeDirective(below)
        }

        val sourcePath: SourcePath get() = (DirectiveProcessor.getDirective(NAME) as Include).sourcePaths

        /**
         * Returns a recording's name for the file from which [outer] is read. The name is empty for the agent's program and its blocks, and
         * `.` for the running agent [ag]. For an included file it is the file's address.
         */
        fun placeOf(outer: Agent, ag: Agent?): String = when {
            outer.aslSrc == null -> ""
            outer === ag -> RUNNING
            else -> outer.aslSrc
        }

        private const val RUNNING = "."

        fun fileOf(directive: Pred): String = (directive.getTerm(0) as StringTerm).string.replace('\\', '/')
    }
}
