package argo.orders

import argo.insides.IncludeDirective
import argo.insides.Includes
import argo.observing.ProgramFile
import jason.JasonException
import jason.asSemantics.Agent
import jason.asSyntax.Atom
import jason.asSyntax.Literal
import jason.asSyntax.Pred
import jason.asSyntax.VarTerm
import jason.asSyntax.parser.ParseException
import jason.asSyntax.parser.SimpleCharStream
import jason.asSyntax.parser.TokenMgrError
import jason.asSyntax.parser.as2j
import jason.asSyntax.parser.as2jConstants
import jason.asSyntax.parser.as2jTokenManager
import java.io.StringReader

/**
 * Lets the agent [into] read a program as Jason does when an agent starts, but with the included files that [find] returns. The arguments
 * of [find] are the address of the including file and the name of the included file. The address of the program itself is empty. Only the
 * thread of [into] may use this object.
 *
 * @param around called for each part of a file (a plan, a belief, a goal or a directive); calls `read` to read the part
 */
internal class ProgramReading(
    private val into: Agent,
    private val find: (within: String, name: String) -> ProgramFile,
    private val around: (file: ProgramFile, agent: Agent, read: () -> ProgramPart) -> Unit = { _, _, read -> read() },
) : Includes {
    private val outer = IncludeDirective.current

    /** Reads [program]. If Jason cannot read it, throws [OrderRefusedException] with the file and the line. */
    fun read(program: ProgramFile) {
        IncludeDirective.install()
        IncludeDirective.within(this) { parse(program, into, Literal.DefaultNS) }
    }

    override fun include(directive: Pred, outer: Agent, live: () -> Agent?): Agent {
        val file = find(if (outer === into) "" else outer.aslSrc.orEmpty(), IncludeDirective.fileOf(directive))
        return agent().apply {
            initAg()
            aslSrc = file.address
            parse(file, this, namespaceOf(directive))
        }
    }

    override fun agent(): Agent = outer?.agent() ?: Agent()

    private fun namespaceOf(directive: Pred): Atom = when (val wanted = if (directive.arity > 1) directive.getTerm(1) else null) {
        is VarTerm -> throw OrderRefusedException("$directive has a namespace that Jason names anew at each reading; name it to reload it")
        is Atom -> Atom(wanted.functor)
        else -> directive.ns
    }

    private fun parse(file: ProgramFile, agent: Agent, namespace: Atom) {
        val parser = as2j(StringReader(file.text))
        parser.setASLSource(file.address)
        parser.ns = namespace
        parser.setAg(agent)
        try {
            while (parser.getToken(1).kind != as2jConstants.EOF) around(file, agent) { part(parser, agent) }
            parser.agent(agent) // reads the end
        } catch (unreadable: ParseException) {
            refuse(file, unreadableAt(unreadable))
        } catch (unreadable: TokenMgrError) {
            refuse(file, unreadable.message.orEmpty().trim())
        } catch (unreadable: JasonException) { // two plans have one label
            refuse(file, unreadable.message.orEmpty())
        }
    }

    private fun part(parser: as2j, agent: Agent): ProgramPart {
        val first = parser.getToken(1)
        parser.agent_component(agent)
        return ProgramPart(Place(first.beginLine, first.beginColumn), parser.token.run { Place(endLine, endColumn) })
    }

    private fun refuse(file: ProgramFile, why: String): Nothing = throw OrderRefusedException("${file.shortName}: $why")
}

/** A part of a file, from its first character to its last one. */
internal class ProgramPart(val first: Place, val last: Place)

/** The place of a character. Line and column count from 1, as in Jason's parser. */
internal data class Place(val line: Int, val column: Int) : Comparable<Place> {
    override fun compareTo(other: Place) = compareValuesBy(this, other, Place::line, Place::column)
}

/** The number of columns between two tab stops of Jason's parser. */
private val TAB = as2jTokenManager(SimpleCharStream(StringReader("\ta"))).nextToken.beginColumn - 1

/** Returns this text with blanks in place of the characters of [parts]. The parts must not overlap. */
internal fun String.without(parts: List<ProgramPart>): String {
    if (parts.isEmpty()) return this
    val text = StringBuilder(this)
    val left = ArrayDeque(parts.sortedBy { it.first })
    var line = 1
    var column = 0
    for ((index, char) in withIndex()) {
        val isBreak = char == '\n' || char == '\r' && getOrNull(index + 1) != '\n'
        column += if (char == '\t') TAB - column % TAB else 1
        val place = Place(line, column)
        while (left.isNotEmpty() && left.first().last < place) left.removeFirst()
        if (!isBreak && char != '\r' && left.isNotEmpty() && left.first().first <= place) text[index] = ' '
        if (isBreak) {
            line++
            column = 0
        }
    }
    return "$text"
}

internal val ProgramFile.shortName: String get() = address.substringAfterLast('/').substringAfterLast('\\')
