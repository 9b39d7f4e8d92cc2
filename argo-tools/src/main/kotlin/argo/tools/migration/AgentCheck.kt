package argo.tools.migration

import java.nio.file.Path

/** What would be otherwise in an agent's program. */
internal class AgentCheck(private val file: Path, private val text: String) {
    private val advices = Advices("$file")
    private val tokens = if (text.any(::isForeign)) emptyList() else tokensOf(text)
    private val calls = callsIn(tokens)
    private val ports = calls.filter { ArgoActions.actionIn(it.name) == "port" }.mapNotNull { it.arguments.firstOrNull()?.singleOrNull() }

    /** The names of the filters that it changes to, with their lines. */
    val filters = ArrayList<Pair<String, Int>>()

    /** Whether it needs `argo.Arch`. */
    val needsArch: Boolean = calls.any { ArgoActions.actionIn(it.name) in ArgoActions.OF_BOARDS }

    /** All that is to be said. */
    fun advices(): List<Advice> {
        program()
        calls.forEach { call -> ArgoActions.actionIn(call.name)?.let { action(it, call) } }
        severalPorts()
        calls.filter { it.name == "port" && it.arguments.size == 2 }.forEach(::portBelief)
        calls.filter { it.name == "source" }.forEach(::source)
        return advices.all
    }

    /** What Jason would not even read, and what need not be looked into further. */
    private fun program() {
        val foreign = text.indexOfFirst(::isForeign)
        val last = tokens.lastOrNull()
        if (foreign >= 0) {
            val line = 1 + text.take(foreign).count { it == '\n' }
            advices.change(line, "this is no program of AgentSpeak: it holds the character U+${"%04X".format(text[foreign].code)}, as no text does", "text in UTF-8 can be checked")
        } else if (last != null && !last.isSymbol('.') && !last.isSymbol('}')) {
            advices.change(last.line, "no program of AgentSpeak ends so: a belief, a goal and a plan end with a full stop", "see whether the file is whole, and what it should be")
        }
    }

    private fun action(action: String, call: Call) {
        if (!ArgoActions.exists(call.name)) {
            advices.change(
                call.line, "there is no internal action ${call.name}: Jason would take it for an action of the environment",
                "there are ${ArgoActions.NAMES.joinToString { "argo.$it" }}",
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
        if (options?.singleOrNull()?.text in TRUTH_VALUES) {
            advices.change(call.line, "the second argument of ${call.name} is a list of options here, not ${options?.single()?.text}", "leave it out: an agent of ARGO sleeps when there is nothing to do and wakes for its percepts")
        } else if (options != null && options.firstOrNull()?.let { it.isSymbol('[') || it.isVariable } != true) {
            advices.change(call.line, "the second argument of ${call.name} is a list of options here", "such as [baud(115200), timeout(1000)]")
        }
        val name = port.singleOrNull()
        when {
            name == null -> advices.change(call.line, "${port.joinToString("") { it.text }} is not a term that Jason reads as a port", "put it in quotes")
            name.isVariable && PORT_LIKE.matches(name.text) -> advices.note(
                call.line, "${name.text} is a variable to Jason; its name is taken for the port as long as it has no value", "\"${name.text}\" in quotes means the same and is never something else",
            )
        }
    }

    private fun severalPorts() {
        val named = ports.filter { !it.isVariable && it.text != "none" }.distinctBy { nameOf(it) }
        named.drop(1).forEach {
            advices.note(it.line, "${it.text} is another port than ${named.first().text} before: ports stay open here, and the agent goes back to one without resetting its board", "argo.port(none) closes all of them")
        }
    }

    private fun limit(call: Call) {
        val argument = call.arguments.singleOrNull() ?: return arity(call, "the interval in milliseconds")
        val written = argument.joinToString("") { it.text }
        val ms = written.toDoubleOrNull() ?: return
        when {
            ms < 0 || ms != Math.rint(ms) -> advices.change(call.line, "the interval of ${call.name} is a whole number of milliseconds from 0, not $written", "0 means as fast as the line allows")
            ms >= NANOSECONDS_MEANT -> advices.change(call.line, "${call.name}($written) is in milliseconds: one perception in ${Math.round(ms / MS_PER_MINUTE)} minutes", "if nanoseconds were meant: ${call.name}(${Math.round(ms / NANOS_PER_MS)})")
            ms >= SLOW_MS -> advices.note(
                call.line, "${call.name}($written): one perception in $written ms. Some versions of ARGO took the number for nanoseconds, so that it had no effect",
                "if the agent relied on being faster, a smaller number; 0 is as fast as the line allows",
            )
        }
    }

    private fun percepts(call: Call) {
        val word = call.arguments.singleOrNull()?.singleOrNull() ?: return arity(call, "open, block or close")
        if (!word.isVariable && word.text !in listOf("open", "block", "close")) advices.change(call.line, "perception is set to open, block or close, not ${word.text}", "open and block it with these words")
    }

    private fun act(call: Call) {
        val options = call.arguments.getOrNull(1)
        val areOptions = options == null || options.firstOrNull()?.let { it.isSymbol('[') || it.isVariable } == true
        if (call.arguments.size !in 1..2 || !areOptions) return arity(call, "one literal, as in ${call.name}(speed(120)), and a list of options if there are any")
        val command = call.arguments.first()
        val string = command.singleOrNull()?.takeIf { it.kind == Token.Kind.STRING && it.text.startsWith('"') } ?: return
        advices.note(call.line, "the string ${string.text} is sent without its quotes here; some versions of ARGO sent them too", "if the board expects quotes, a structure with a string in it: say(${string.text})")
    }

    private fun filter(call: Call) {
        val first = call.arguments.firstOrNull()?.singleOrNull()
        val form = first?.text
        when {
            form in FILTER_FORMS && (call.arguments.size > 1 || form == "remove") -> advices.change(
                call.line, "${call.name}($form${if (call.arguments.size > 1) ", …" else ""}) is a filter written into the plan, which is not known here",
                if (form == "remove") "argo.change_filter(none)" else "write it as a file (docs/filters.md), and change to it with argo.change_filter(NAME)",
            )
            call.arguments.size != 1 -> arity(call, "the name of a filter")
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
            advices.change(call.line, "the belief names the port as argo.port was given it, ${same.first().text}, so that ${port.text} never matches", "write ${same.first().text} in both places, or a variable here")
        }
    }

    private fun source(call: Call) {
        val source = call.arguments.singleOrNull()?.singleOrNull()?.text
        if (source in BODY_SOURCES) advices.change(call.line, "no belief has source($source) here: what a board says, and the states of ports, have source(percept)", "source(percept), or no annotation")
    }

    private fun arity(call: Call, expected: String) =
        advices.change(call.line, "${call.name} is given ${call.arguments.size} arguments", "it takes $expected")

    private companion object {
        val TRUTH_VALUES = setOf("true", "false")
        val STATUSES = listOf("on", "off", "timeout")
        val FILTER_FORMS = setOf("only", "except", "value", "remove")
        val BODY_SOURCES = setOf("interoception", "proprioception", "exteroception")
        val PORT_LIKE = Regex("COM\\d+|[Tt][Tt][Yy]\\w+")
        const val NANOSECONDS_MEANT = 1_000_000.0
        const val NANOS_PER_MS = 1_000_000.0
        const val MS_PER_MINUTE = 60_000.0
        const val SLOW_MS = 200.0

        const val BLANKS = "\t\n\u000B\u000C\r"

        fun isForeign(character: Char): Boolean = character < ' ' && character !in BLANKS

        /** What an atom or a string names. */
        fun nameOf(token: Token): String = token.text.removeSurrounding("\"").removeSurrounding("'")

        fun shortName(token: Token): String = nameOf(token).substringAfterLast('/')
    }
}
