package argo.recording.agent

import argo.insides.Insides
import jason.asSemantics.Agent
import jason.asSyntax.Pred
import jason.asSyntax.StringTerm
import jason.asSyntax.directives.DirectiveProcessor
import jason.asSyntax.directives.Include
import jason.runtime.SourcePath

/** Who watches over the files that an agent includes, at the beginning or as it runs: a recorder or a replay. */
internal fun interface Includes {
    /** What [directive] includes into [outer]; [live] has Jason look for the file and read it. */
    fun include(directive: Pred, outer: Agent, live: () -> Agent?): Agent?
}

/** Jason's directive `include`, which the action `.include` calls too: on a thread that has [current] it is theirs, on others Jason's. */
internal class KeptInclude private constructor(private val below: Include) : Include() {
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

        /** Who watches over what the calling thread includes; null: nobody. */
        var current: Includes?
            get() = CURRENT.get()
            set(includes) = if (includes == null) CURRENT.remove() else CURRENT.set(includes)

        /** Does [work], which [includes] watch over. */
        inline fun <T> within(includes: Includes, work: () -> T): T {
            val around = current
            current = includes
            try {
                return work()
            } finally {
                current = around
            }
        }

        /** Puts it in the place of Jason's, for the whole program. */
        @Synchronized
        fun install() {
            val below = DirectiveProcessor.getDirective(NAME) as Include
            if (below is KeptInclude) return
            Insides.directives[null][NAME] = KeptInclude(below)
        }

        /** Where Jason looks for included files. */
        val sourcePath: SourcePath get() = (DirectiveProcessor.getDirective(NAME) as Include).sourcePaths

        /** How a recording calls the file that [outer] is read from: the agent [ag] itself, or a file that it includes. */
        fun placeOf(outer: Agent, ag: Agent?): String = when {
            outer.aslSrc == null -> "" // it is being read, or a block of it
            outer === ag -> RUNNING
            else -> outer.aslSrc
        }

        private const val RUNNING = "."

        /** The file that [directive] names. */
        fun fileOf(directive: Pred): String = (directive.getTerm(0) as StringTerm).string.replace('\\', '/')
    }
}
