package argo.recording.agent

import argo.filters.GroundTerm
import jason.asSyntax.ArithExpr
import jason.asSyntax.ArithFunctionTerm
import jason.asSyntax.Atom
import jason.asSyntax.CyclicTerm
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.LiteralImpl
import jason.asSyntax.LogExpr
import jason.asSyntax.MapTermImpl
import jason.asSyntax.NumberTermImpl
import jason.asSyntax.ObjectTerm
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.PlanBodyImpl
import jason.asSyntax.Pred
import jason.asSyntax.RelExpr
import jason.asSyntax.Rule
import jason.asSyntax.SetTermImpl
import jason.asSyntax.SourceInfo
import jason.asSyntax.StringTermImpl
import jason.asSyntax.Structure
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import jason.asSyntax.UnnamedVar
import jason.asSyntax.VarTerm
import kotlin.math.abs
import kotlin.math.floor

/**
 * Writes a term so that [TermReader] can read it back. Uses Jason's notation if it has only one meaning, else `#kind(…)`. In Jason's
 * notation no term begins with `#`.
 *
 * | written | is |
 * |---|---|
 * | `-1`, `(-1)` | a negative number, an expression that Jason has not evaluated |
 * | `#NaN`, `#Infinity`, `#-Infinity` | numbers |
 * | `hello`, `hello()` | an atom, a literal without arguments, which can get annotations |
 * | `#structure(f(1))`, `#pred(f)`, `#atom(f)` | terms that Java code has made; Jason does not believe them |
 * | `#"Upper Case"(1)` | a structure with a functor that is no word |
 * | `#string("a\\b")` | a string that Jason's syntax cannot hold |
 * | `_12`, `#var("_12",-12)` | a variable that is named after its number; a variable with another name or number |
 * | `#set(a)`, `#map(a,1)` | a set, a map of keys and values |
 * | `#fun("math.max",1,2)` | a function that is not evaluated |
 * | `#plan(…)`, `#rule(…)`, `#body(…)`, `#event(…)` | parts of programs |
 * | `#refused("why")` | a term that cannot be written |
 */
internal class TermWriter {
    private val out = StringBuilder()

    fun text(term: Term): String = written { term(term) }

    fun literalText(literal: Literal): String = written {
        when {
            !isBare(literal) -> term(literal)
            literal is LiteralImpl -> functor(literal.functor)
            else -> marked("atom") { literal(literal) }
        }
    }

    private inline fun written(write: () -> Unit): String = try {
        write()
        "$out"
    } catch (refused: UnrecordableTerm) {
        refusedText(refused.message)
    } catch (_: StackOverflowError) {
        refusedText("a term that is nested too deep")
    }

    private fun term(term: Term?) {
        when (term) {
            null -> refuse("a term without a value in it")
            is VarTerm -> variable(term)
            is NumberTermImpl -> number(term.solve())
            is StringTermImpl -> term.string?.let(::string) ?: append("#null")
            is ListTerm -> list(term)
            is SetTermImpl -> marked("set") { items(term) }
            is MapTermImpl -> marked("map") { items(term.keys().flatMap { listOf(it, term.get(it)) }) }
            is ObjectTerm -> refuse("a Java object of the class ${term.`object`?.javaClass?.name}")
            is Plan -> plan(term)
            is PlanBody -> body(term)
            is Trigger -> event(term)
            is Rule -> rule(term)
            is CyclicTerm -> refuse("a term that holds itself")
            is Literal -> literal(term)
            else -> refuse("a term of the class ${term.javaClass.name}")
        }
    }

    private fun refuse(what: String): Nothing = throw UnrecordableTerm(what)

    private fun append(text: String) {
        out.append(text)
    }

    private inline fun marked(kind: String, content: () -> Unit) {
        append("#$kind(")
        content()
        append(")")
    }

    private fun items(terms: Iterable<Term?>) = terms.forEachIndexed { place, term ->
        if (place > 0) append(",")
        term(term)
    }

    private fun number(value: Double) = append(
        when {
            value.isNaN() || value.isInfinite() -> "#$value"
            value == floor(value) && abs(value) < LARGEST_WHOLE && 1 / value != Double.NEGATIVE_INFINITY -> "${value.toLong()}"
            else -> "$value"
        },
    )

    /** Writes a string. Jason's notation cannot express every string, since Jason resolves some escapes and drops some characters. */
    private fun string(text: String) {
        if (text.none { it == '\\' || it == '\r' || it.isSurrogate() }) append("${GroundTerm.Text(text)}")
        else marked("string") { append(quoted(text)) }
    }

    private fun list(list: ListTerm) {
        append("[")
        var rest = list
        while (!rest.isVar && !(rest.term == null && rest.next == null)) { // Jason finds the end of a list by recursion
            if (rest !== list) append(",")
            if (rest.term != null) term(rest.term)
            rest = rest.next
        }
        if (rest.isVar) {
            append("|")
            variable(rest as VarTerm)
        }
        append("]")
    }

    private fun variable(variable: VarTerm) {
        val name = variable.functor
        namespace(variable)
        val number = (variable as? UnnamedVar)?.myId
        when {
            number == null && variable.javaClass != VarTerm::class.java -> refuse("a variable of the class ${variable.javaClass.name}")
            number == null -> if (VARIABLE.matches(name)) append(name) else marked("var") { append(quoted(name)) }
            NUMBERED.matchEntire(name)?.groupValues?.get(1) == "$number" -> append(name)
            else -> marked("var") { append("${quoted(name)},$number") }
        }
        annotations(variable)
    }

    private fun literal(literal: Literal) {
        when {
            literal === Literal.LTrue || literal === Literal.LFalse || literal === Literal.DefaultNS -> append(literal.functor)
            literal is LogExpr || literal is RelExpr -> operation(literal as Structure)
            literal is ArithExpr -> operation(literal)
            literal is ArithFunctionTerm -> marked("fun") { items(listOf(StringTermImpl(literal.functor)) + literal.terms.orEmpty()) }
            literal is InternalActionLiteral && !CALL.matches(literal.functor) -> refuse("an internal action called ${literal.functor}")
            literal.javaClass == Structure::class.java -> marked("structure") { structure(literal) }
            literal.javaClass == Pred::class.java -> marked("pred") { structure(literal) }
            literal.javaClass in KNOWN -> structure(literal)
            else -> refuse("a term of the class ${literal.javaClass.name}")
        }
    }

    private fun isBare(literal: Literal) = (literal.javaClass == Atom::class.java || literal.javaClass == LiteralImpl::class.java) &&
        !literal.hasTerm() && !literal.hasAnnot() && !literal.negated() && literal.ns == Literal.DefaultNS

    private fun structure(literal: Literal) {
        namespace(literal)
        if (literal is InternalActionLiteral) append(literal.functor) else functor(literal.functor)
        if (literal.hasTerm()) {
            append("(")
            items(literal.terms)
            append(")")
        } else if (literal.javaClass == LiteralImpl::class.java && !literal.hasAnnot() && !literal.negated()) {
            append("()")
        }
        annotations(literal)
    }

    private fun namespace(literal: Literal) {
        val space = literal.ns
        if (space != Literal.DefaultNS) {
            if (space is VarTerm) variable(space) else functor(space.functor)
            append("::")
        }
        if (literal.negated()) append("~")
    }

    private fun functor(functor: String) = append(if (isPlain(functor)) functor else "#${quoted(functor)}")

    private fun annotations(literal: Literal) {
        if (literal.hasAnnot()) list(literal.annots)
    }

    private fun operation(operation: Structure) {
        val sign = operation.functor
        if (operation.arity == 1) {
            append(if (operation is LogExpr) "not (" else "($sign")
            term(operation.getTerm(0))
        } else {
            append("(")
            term(operation.getTerm(0))
            append(sign)
            term(operation.getTerm(1))
        }
        append(")")
    }

    private fun plan(plan: Plan) = marked("plan") {
        if (plan.hasSubPlans()) refuse("a plan that has plans within")
        append("${flag(plan.isPlanTerm)},${quoted(plan.sourceFile.orEmpty())},${place(plan.srcInfo)}")
        for (part in listOf(plan.label, plan.trigger, plan.context as Term?, plan.goalCondition as Term?, plan.body)) {
            append(",")
            if (part == null) append(NONE) else term(part)
        }
    }

    private fun rule(rule: Rule) = marked("rule") {
        append("${flag(rule.isTerm)},")
        structure(rule)
        append(",")
        term(rule.body)
    }

    private fun event(event: Trigger) = marked("event") {
        append("${flag("$event".startsWith("{"))},${event.operator.name},${event.type.name},${place(event.literal.srcInfo)},")
        term(event.literal)
    }

    private fun body(body: PlanBody) = marked("body") {
        append(flag(body.isBodyTerm))
        for (step in generateSequence(body) { it.bodyNext }) {
            if (step !is PlanBodyImpl) refuse("a plan with a step of the class ${step.javaClass.name}")
            append(",${step.bodyType.name},${place(step.srcInfo)},")
            if (step.bodyTerm == null) append(NONE) else term(step.bodyTerm)
        }
    }

    private fun flag(isSet: Boolean) = if (isSet) "1" else "0"

    private fun place(source: SourceInfo?) =
        source?.run { "#at(${srcFile?.let(::quoted) ?: NONE},$beginSrcLine,$endSrcLine)" } ?: NONE

    companion object {
        const val NONE = "#none"

        private val KNOWN: Set<Class<*>> = setOf(
            Atom::class.java, LiteralImpl::class.java, InternalActionLiteral::class.java,
            Rule::class.java, // its head
            Pred.createSource(Atom("self")).javaClass, // the class of an annotation that Jason never copies
        )

        /** Doubles can express each smaller whole number. */
        private const val LARGEST_WHOLE = 1e15
        private const val REFUSED = "#refused("
        private val VARIABLE = Regex("""\p{Lu}[\p{L}\p{N}_]*""")

        /** Matches a name that Jason has made for a variable, and captures the variable's number. */
        val NUMBERED = Regex("""_([1-9]\d{0,9})(?!\d)[\p{L}\p{N}_]*""")
        private val CALL = Regex("""(?:\p{Ll}[\p{L}\p{N}_]*)?(?:\.[\p{L}_][\p{L}\p{N}_]*)+""")
        private val WORD = Regex("""\p{Ll}[\p{L}\p{N}_]*|'[^'\\\n\r"]*'""")

        /** Words with a special meaning, which are not functors. */
        val RESERVED = setOf("true", "false", "default", "not")

        /** Returns true if [functor] needs no quotes. */
        fun isPlain(functor: String) = WORD.matches(functor) && functor !in RESERVED

        /** Returns the text for a term that cannot be written because of [why]. */
        fun refusedText(why: String) = "$REFUSED${quoted(why)})"

        fun isRefused(text: String) = text.startsWith(REFUSED)

        fun refusalOf(text: String) = text.removePrefix(REFUSED).removeSuffix(")").trim('"')

        /** Returns [text] in quotes. The result has no surrogates and no control characters, so each encoding of Unicode can express it. */
        fun quoted(text: String): String = buildString {
            append('"')
            for (sign in text) when {
                sign == '"' || sign == '\\' -> append('\\').append(sign)
                sign == '\n' -> append("\\n")
                sign.isSurrogate() || sign.isISOControl() -> append("\\u%04x".format(sign.code))
                else -> append(sign)
            }
            append('"')
        }
    }
}

/** Reports that a recording cannot contain a term. [message] describes the term. */
internal class UnrecordableTerm(override val message: String) : IllegalArgumentException(message)
