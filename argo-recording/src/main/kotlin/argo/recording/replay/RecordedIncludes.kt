package argo.recording.replay

import argo.recording.agent.Includes
import argo.recording.agent.KeptInclude
import jason.asSemantics.Agent
import jason.asSyntax.Atom
import jason.asSyntax.Pred
import jason.asSyntax.VarTerm
import jason.asSyntax.directives.NameSpace
import jason.asSyntax.parser.ParseException
import jason.asSyntax.parser.TokenMgrError
import jason.asSyntax.parser.as2j
import java.nio.file.Files
import java.nio.file.Path

/**
 * What [agent] of [recording] has included: a replay takes it from there, and looks for no file.
 *
 * @param beside a program in the place of the recorded one, beside which files are looked for first; null: there is none
 */
internal class RecordedIncludes(recording: Recording, private val agent: String, private val beside: Path? = null) : Includes {
    private val files = recording.includes(agent).groupBy { it.within to it.name }.mapValuesTo(HashMap()) { ArrayDeque(it.value) }

    /** Whether the program is the recorded one. */
    val isOfRecordedProgram: Boolean get() = beside == null

    /** The agent that runs; null: it is being read. */
    var running: Agent? = null

    override fun include(directive: Pred, outer: Agent, live: () -> Agent?): Agent? {
        val name = KeptInclude.fileOf(directive)
        val file = ownFile(name) ?: recorded(name, KeptInclude.placeOf(outer, running))
        return file.text?.let { read(it, file.address, namespaceOf(directive)) }
    }

    private fun ownFile(name: String): Recording.Include? {
        val file = beside?.resolveSibling(name)?.takeIf(Files::isRegularFile) ?: return null
        return Recording.Include("", name, "file:$file", Files.readAllBytes(file))
    }

    /** The one that was recorded for it; a file that was included several times may have changed between. */
    private fun recorded(name: String, within: String): Recording.Include {
        val all = files[within to name]
            ?: throw RecordingException("the recording of agent $agent does not hold the file $name that it includes")
        return if (all.size > 1) all.removeFirst() else all.first()
    }

    /** As Jason's `include` reads one; of a file that cannot be read it takes nothing, and goes on. */
    private fun read(text: ByteArray, address: String, namespace: Atom): Agent? = try {
        GuardedAgent().apply {
            initAg()
            aslSrc = address
            val parser = as2j(text.inputStream())
            parser.setASLSource(address)
            parser.ns = namespace
            parser.agent(this)
        }
    } catch (_: ParseException) {
        null
    } catch (_: TokenMgrError) {
        null
    }

    private fun namespaceOf(directive: Pred): Atom {
        if (directive.arity < 2) return directive.ns
        val wanted = directive.getTerm(1)
        return when {
            wanted is VarTerm -> Atom("ns${NameSpace.getUniqueID()}").also { directive.setTerm(1, it) }
            wanted.isAtom -> Atom((wanted as Atom).functor)
            else -> directive.ns
        }
    }
}
