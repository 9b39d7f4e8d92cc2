package argo.tools.migration

import argo.tools.command.closest
import java.nio.file.Path
import kotlin.math.roundToLong
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.minutes
import kotlin.time.Duration.Companion.nanoseconds

internal class AgentCheck(private val file: Path, private val text: String) {
    private val advices = Advices("$file")
    private val tokens = if (text.any(::isForeign)) emptyList() else tokensOf(text)
    private val calls = callsIn(tokens)
    private val ports = calls.filter { ArgoActions.actionIn(it.name) == "port" }.mapNotNull { it.arguments.firstOrNull()?.singleOrNull() }

    /** The first interval that may be meant in nanoseconds: only programs for other versions write the dot. */
    private val firstSlow = calls.find {
        it.name.startsWith('.') && ArgoActions.actionIn(it.name) == "limit" && (intervalIn(it) ?: 0.0) in MIN_SLOW_MS..<MIN_NANOSECONDS
    }

    /** The names of the filters that it changes to, with their lines. */
    val filters = ArrayList<Pair<String, Int>>()

    /** True if it has calls that only programs for other versions need. */
    val isForOtherVersion: Boolean = calls.any { it.name.startsWith('.') && ArgoActions.actionIn(it.name) != null }

    val needsArch: Boolean = calls.any { ArgoActions.actionIn(it.name) in ArgoActions.OF_BOARDS }

    fun advices(): List<Advice> {
        program()
        calls.forEach { call -> ArgoActions.actionIn(call.name)?.let { action(it, call) } }
        severalPorts()
        calls.filter { it.name == "port" && it.arguments.size == 2 }.forEach(::portBelief)
        calls.filter { it.name == "port" && it.arguments.size == 2 }
            .forEach { advices.options(it.arguments[1], KnownOption.OF_PORT, "a port") }
        calls.filter { it.name == "source" }.forEach(::source)
        calls.filter { it.name == "error" }.forEach(::error)
        return advices.all
    }

    /** Finds text that Jason cannot parse; then no further checks are made. */
    private fun program() {
        val foreign = text.indexOfFirst(::isForeign)
        val last = tokens.lastOrNull()
        val bracket = wrongBracketIn(tokens)
        if (foreign >= 0) {
            val line = 1 + text.take(foreign).count { it == '\n' }
            val code = "U+%04X".format(text[foreign].code)
            advices.change(line, "this is no program of AgentSpeak: it contains the control character $code", "use text in UTF-8")
        } else if (last != null && !last.isSymbol('.') && !last.isSymbol('}')) {
            val what = "no program of AgentSpeak ends like this: a belief, a goal and a plan end with a full stop"
            advices.change(last.line, what, "check whether the file is complete, and of the right kind")
        } else if (bracket != null) {
            advices.change(bracket.line, "Jason cannot read this: the bracket ${bracket.text} has no counterpart", "balance the brackets")
        } else if (last != null && last.isSymbol('}') && !isStatement(lastStatementIn(tokens))) {
            val what = "this is no program of AgentSpeak: no belief, goal, plan or directive begins with ${lastStatementIn(tokens).text}"
            advices.change(lastStatementIn(tokens).line, what, "check whether the file is of the right kind")
        }
    }

    private fun action(action: String, call: Call) {
        if (!ArgoActions.exists(call.name)) {
            advices.change(
                call.line, "there is no internal action ${call.name}: Jason would take it for an action of the environment",
                meant(action, ArgoActions.NAMES).replace("probably ", "probably argo.") +
                    "the actions are ${ArgoActions.NAMES.joinToString { "argo.$it" }}",
            )
            return
        }
        when (action) {
            "port" -> port(call)
            "limit" -> limit(call)
            "percepts" -> percepts(call)
            "act" -> act(call)
            "filter", "change_filter" -> filter(call)
        }
    }

    private fun port(call: Call) {
        val port = call.arguments.firstOrNull() ?: return arity(call, "the port")
        val options = call.arguments.getOrNull(1)
        if (call.arguments.size > 2) return arity(call, "the port and a list of options")
        val what = "the second argument of ${call.name} is a list of options here"
        if (options?.singleOrNull()?.text in TRUTH_VALUES) {
            val remedy = "remove it: an agent of ARGO sleeps while idle and wakes for its percepts"
            advices.change(call.line, "$what, not ${options?.single()?.text}", remedy)
        } else if (options != null && !mayBeList(options)) {
            advices.change(call.line, what, "such as [baud(115200), timeout(1000)]")
        } else if (options != null) {
            advices.options(options, KnownOption.OF_PORT, call.name)
        }
        val name = port.singleOrNull()
        if (name == null) {
            advices.change(call.line, "${port.joinToString("") { it.text }} is not a term that Jason reads as a port", "put it in quotes")
        } else if (name.isVariable && PORT_LIKE.matches(name.text)) {
            val unbound = "${name.text} is a variable to Jason; while it is unbound, its name stands for the port"
            advices.note(call.line, unbound, "write \"${name.text}\", with quotes")
        }
    }

    private fun severalPorts() {
        val named = ports.filter { !it.isVariable && it.text != "none" }.distinctBy { nameOf(it) }
        named.drop(1).forEach {
            val what = "${it.text} is another port than ${named.first().text} before: both stay open here, and switching resets no board"
            advices.note(it.line, what, "argo.port(none) closes all ports")
        }
    }

    private fun limit(call: Call) {
        val argument = call.arguments.singleOrNull() ?: return arity(call, "the interval in milliseconds")
        val written = argument.joinToString("") { it.text }
        val single = argument.singleOrNull()
        if (single != null && !single.isVariable && single.kind != Token.Kind.NUMBER) {
            advices.change(call.line, "the interval of ${call.name} is a number of milliseconds, not $written", "such as ${call.name}(100)")
            return
        }
        val ms = intervalIn(call) ?: return
        when {
            ms < 0 || ms != Math.rint(ms) -> advices.change(
                call.line, "the interval of ${call.name} is a whole number of milliseconds from 0, not $written",
                "0 means as fast as the line allows",
            )
            ms >= MIN_NANOSECONDS -> {
                val minutes = (ms.milliseconds / 1.minutes).roundToLong()
                val fromNanos = (ms.nanoseconds / 1.milliseconds).roundToLong()
                val what = "${call.name}($written) is in milliseconds: one perception in $minutes minutes"
                advices.change(call.line, what, "for nanoseconds write ${call.name}($fromNanos)")
            }
            ms >= MIN_SLOW_MS && call == firstSlow -> advices.note(
                call.line, "${call.name}($written): one perception in $written ms. Some versions of ARGO read nanoseconds, without effect",
                "write a smaller number if the agent must be faster; 0 is as fast as the line allows",
            )
        }
    }

    private fun percepts(call: Call) {
        val word = call.arguments.singleOrNull()?.singleOrNull() ?: return arity(call, "open, block or close")
        if (!word.isVariable && word.text !in PERCEPTS) {
            advices.change(call.line, "perception is set to open, block or close, not ${word.text}", "use one of these words")
        }
    }

    private fun act(call: Call) {
        val options = call.arguments.getOrNull(1)
        if (call.arguments.size !in 1..2 || options != null && !mayBeList(options)) {
            return arity(call, "one literal, as in ${call.name}(speed(120)), and optionally a list of options")
        }
        options?.let { advices.options(it, KnownOption.OF_ACT, call.name) }
        val command = call.arguments.first()
        val string = command.singleOrNull()?.takeIf { it.kind == Token.Kind.STRING && it.text.startsWith('"') } ?: return
        val what = "the string ${string.text} is sent without its quotes here; some versions of ARGO sent them too"
        advices.note(call.line, what, "if the board expects quotes, write a structure with a string: say(${string.text})")
    }

    private fun filter(call: Call) {
        val first = call.arguments.firstOrNull()?.singleOrNull()
        val form = first?.text
        when {
            form == "remove" -> advices.change(call.line, "${call.name}(remove) $IN_PLAN", "argo.change_filter(none)")
            form in FILTER_FORMS && call.arguments.size > 1 -> advices.change(
                call.line, "${call.name}($form, …) $IN_PLAN", "write a filter file (docs/filters.md), and call argo.change_filter(NAME)",
            )
            call.arguments.size != 1 -> arity(call, "the name of a filter")
            call.arguments.single().first().isSymbol('[') || first?.kind == Token.Kind.NUMBER ->
                advices.change(call.line, "${call.name} takes one name", "an atom or a string, such as argo.change_filter(front), or none")
            first != null && !first.isVariable && form != "none" -> filters += nameOf(first) to call.line
        }
    }

    private fun portBelief(call: Call) {
        val (port, status) = call.arguments.map { it.singleOrNull() }
        if (status != null && status.kind == Token.Kind.WORD && !status.isVariable && status.text !in STATUSES) {
            advices.change(call.line, "a port is never ${status.text} here", "the states are ${STATUSES.joinToString()}")
        }
        if (port == null || port.isVariable || port.kind == Token.Kind.NUMBER) return
        val same = ports.filter { !it.isVariable && shortName(it) == shortName(port) }
        if (same.isNotEmpty() && same.none { it.text == port.text }) {
            val what = "the belief has the name passed to argo.port, ${same.first().text}, so that ${port.text} never matches"
            advices.change(call.line, what, "write ${same.first().text} in both places, or a variable here")
        }
    }

    private fun source(call: Call) {
        val source = call.arguments.singleOrNull()?.singleOrNull()?.text
        if (source !in BODY_SOURCES) return
        val what = "no belief has source($source) here: percepts of a board, and the states of ports, have source(percept)"
        advices.change(call.line, what, "source(percept), or no annotation")
    }

    /** Advises on a name that is nearly an action's error; names unlike all errors may come from the project's own `.fail`. */
    private fun error(call: Call) {
        val written = call.arguments.singleOrNull()?.singleOrNull()?.takeIf { it.kind == Token.Kind.WORD && !it.isVariable }?.text ?: return
        val meant = closest(written, ArgoActions.ERRORS).takeIf { written !in ArgoActions.ERRORS } ?: return
        val remedy = "probably error($meant); no change is needed if .fail makes it"
        advices.note(call.line, "no action of ARGO fails with error($written)", remedy)
    }

    private fun arity(call: Call, expected: String) =
        advices.change(call.line, "${call.name} has ${call.arguments.size} arguments", "it takes $expected")

    private companion object {
        val TRUTH_VALUES = setOf("true", "false")
        val STATUSES = listOf("on", "off", "timeout")
        val PERCEPTS = setOf("open", "block", "close")
        val FILTER_FORMS = setOf("only", "except", "value")
        const val IN_PLAN = "is a filter written into the plan, which is unknown here"
        val BODY_SOURCES = setOf("interoception", "proprioception", "exteroception")
        val PORT_LIKE = Regex("COM\\d+|[Tt][Tt][Yy]\\w+")

        /** An interval of at least this number was meant in nanoseconds. */
        const val MIN_NANOSECONDS = 1_000_000.0
        const val MIN_SLOW_MS = 200.0

        /** Returns the number in [call], a call of `argo.limit`. */
        fun intervalIn(call: Call): Double? = call.arguments.singleOrNull()?.joinToString("") { it.text }?.toDoubleOrNull()

        const val BLANKS = "\t\n\u000B\u000C\r"

        fun isForeign(character: Char): Boolean = character < ' ' && character !in BLANKS

        /** Returns true if a statement that ends with a brace may begin with [first]: a directive, a plan or its label. */
        fun isStatement(first: Token) = first.kind == Token.Kind.SYMBOL && first.text[0] in "{+-@"

        fun mayBeList(argument: List<Token>) = argument.firstOrNull()?.let { it.isSymbol('[') || it.isVariable } == true

        /** Returns the text of an atom or a string without quotes. */
        fun nameOf(token: Token): String = token.text.removeSurrounding("\"").removeSurrounding("'")

        fun shortName(token: Token): String = nameOf(token).substringAfterLast('/')
    }
}
