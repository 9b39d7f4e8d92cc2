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
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * The files that [agent] of [recording] has included: a replay takes them from the recording, and looks for no file.
 *
 * @param beside a program in the place of the recorded one, in whose folder included files are looked for first; null: there is none
 */
internal class RecordedIncludes(recording: Recording, private val agent: String, private val beside: Path? = null) : Includes {
    private val files = recording.includes(agent).groupBy { it.within to it.name }.mapValuesTo(HashMap()) { ArrayDeque(it.value) }

    val isOfRecordedProgram: Boolean get() = beside == null

    /** The watch that is asked about the code of the program and of its included files. */
    val watch = LateWatch(isCarryingOut = !isOfRecordedProgram)

    /** The running agent; null: its program is being read. */
    var running: Agent? = null

    private var isInRecorded = false // whether a recorded file is being read

    override fun include(directive: Pred, outer: Agent, live: () -> Agent?): Agent? {
        val name = KeptInclude.fileOf(directive)
        val own = ownFile(name)
        val file = own ?: recorded(name, KeptInclude.placeOf(outer, running))
        val around = isInRecorded
        isInRecorded = own == null
        try {
            return file.text?.let { text -> reading { read(text, file.address, namespaceOf(directive)) } }
        } finally {
            isInRecorded = around
        }
    }

    /**
     * Returns the file [name] of the user, if the user's own program includes it; recorded files include only recorded files. While the
     * agent runs, a recorded plan may include a file, so this function then takes only files in the folder of the program.
     */
    private fun ownFile(name: String): Recording.Include? {
        if (beside == null || isInRecorded) return null
        val file = try {
            beside.resolveSibling(name).normalize()
        } catch (_: InvalidPathException) {
            return null
        }
        if (running != null && !file.startsWith(beside.normalize().parent) || !Files.isRegularFile(file)) return null
        return Recording.Include("", name, "file:$file", Files.readAllBytes(file))
    }

    /** Returns the recorded file for [name] in [within]; a file that was included several times may have changed meanwhile. */
    private fun recorded(name: String, within: String): Recording.Include {
        val all = files[within to name]
            ?: throw RecordingException("the recording of agent $agent does not hold the file $name that it includes")
        return if (all.size > 1) all.removeFirst() else all.first()
    }

    /** Reads [text] as Jason's `include` reads a file; null: it cannot be read, and Jason goes on without it. */
    private fun read(text: ByteArray, address: String, namespace: Atom): Agent? = try {
        GuardedAgent(watch).apply {
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
