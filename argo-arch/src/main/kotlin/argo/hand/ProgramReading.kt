package argo.hand

import argo.insides.Includes
import argo.insides.KeptInclude
import argo.observing.ProgramFile
import jason.JasonException
import jason.asSemantics.Agent
import jason.asSyntax.Atom
import jason.asSyntax.Literal
import jason.asSyntax.Pred
import jason.asSyntax.VarTerm
import jason.asSyntax.parser.ParseException
import jason.asSyntax.parser.TokenMgrError
import jason.asSyntax.parser.as2j
import java.io.StringReader

/**
 * Has the agent [into] read a program as Jason reads one at the agent's beginning, but with the included files that [find] returns: the one
 * called `name` in the file at `within`, or in the program itself if that is empty. For the agent's thread, or the only thread of the agent.
 */
internal class ProgramReading(private val into: Agent, private val find: (within: String, name: String) -> ProgramFile) : Includes {
    private val around = KeptInclude.current

    /** Reads [program]. Throws [OrderRefusedException], with the file and the line, if Jason cannot read it. */
    fun read(program: ProgramFile) {
        KeptInclude.install()
        val work = { parse(program, into, Literal.DefaultNS) }
        KeptInclude.within(this, work)
    }

    override fun include(directive: Pred, outer: Agent, live: () -> Agent?): Agent {
        val file = find(if (outer === into) "" else outer.aslSrc.orEmpty(), KeptInclude.fileOf(directive))
        return agent().apply {
            initAg()
            aslSrc = file.address
            parse(file, this, namespaceOf(directive))
        }
    }

    override fun agent(): Agent = around?.agent() ?: Agent()

    private fun namespaceOf(directive: Pred): Atom = when (val wanted = if (directive.arity > 1) directive.getTerm(1) else null) {
        is VarTerm -> throw OrderRefusedException("$directive has a namespace that Jason names anew at each reading; name it to reload it")
        is Atom -> Atom(wanted.functor)
        else -> directive.ns
    }

    private fun parse(file: ProgramFile, agent: Agent, namespace: Atom) {
        val parser = as2j(StringReader(file.text))
        parser.setASLSource(file.address)
        parser.ns = namespace
        try {
            parser.agent(agent)
        } catch (unreadable: ParseException) {
            refuse(file, unreadableAt(unreadable))
        } catch (unreadable: TokenMgrError) {
            refuse(file, unreadable.message.orEmpty().trim())
        } catch (unreadable: JasonException) { // two plans with one label
            refuse(file, unreadable.message.orEmpty())
        }
    }

    private fun refuse(file: ProgramFile, why: String): Nothing = throw OrderRefusedException("${file.shortName}: $why")
}

/** The name of the file without its folder. */
internal val ProgramFile.shortName: String get() = address.substringAfterLast('/').substringAfterLast('\\')
