package argo.recording.replay

import argo.insides.IncludeDirective
import argo.insides.Includes
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
 * The files that [agent] of [recording] has included. A replay takes these files from the recording instead of the disk. [beside] is the
 * user's own program, which replaces the recorded one; null if there is none. Included files are first searched in its folder.
 */
internal class RecordedIncludes(recording: Recording, private val agent: String, private val beside: Path? = null) : Includes {
    private val files = recording.includes(agent).groupBy { it.within to it.name }.mapValuesTo(HashMap()) { ArrayDeque(it.value) }

    val isOfRecordedProgram: Boolean get() = beside == null

    /** The watch for the code of the program and of its included files. */
    val watch = LateWatch(isCarryingOut = !isOfRecordedProgram)

    var running: Agent? = null

    override fun agent() = GuardedAgent(watch)

    private var isInRecorded = false // whether a recorded file is being read

    override fun include(directive: Pred, outer: Agent, live: () -> Agent?): Agent? {
        val name = IncludeDirective.fileOf(directive)
        val own = ownFile(name)
        val file = own ?: recorded(name, IncludeDirective.placeOf(outer, running))
        val around = isInRecorded
        isInRecorded = own == null
        try {
            return file.text?.let { text -> reading { read(text, file.address, namespaceOf(directive)) } }
        } finally {
            isInRecorded = around
        }
    }

    /**
     * Returns the user's file [name] if the user's own program includes it. Recorded files include only recorded files. At run time a
     * recorded plan may include a file, so only files in the folder of the program are valid.
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

    /** Returns the recorded file for [name] in [within]. A file that was included twice may have changed in between. */
    private fun recorded(name: String, within: String): Recording.Include {
        val all = files[within to name]
            ?: throw RecordingException("the recording of agent $agent does not hold the file $name that it includes")
        return if (all.size > 1) all.removeFirst() else all.first()
    }

    /** Reads [text] as Jason's `include` reads a file. Returns null if it cannot be read; Jason ignores an unreadable file. */
    private fun read(text: ByteArray, address: String, namespace: Atom): Agent? = try {
        agent().apply {
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
