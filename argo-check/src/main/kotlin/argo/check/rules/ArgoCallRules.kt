package argo.check.rules

import argo.check.project.Mention
import argo.check.project.Role
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.Missing
import argo.check.syntax.NumberTerm
import argo.check.syntax.StringTerm
import argo.check.syntax.Term
import argo.check.syntax.Variable
import javino.Frame
import javino.PerceptsRequest
import kotlin.math.roundToLong

/** Checks calls of ARGO's internal actions: arguments, options, and syntax of other ARGO versions. */
internal object ArgoCallRules : Rule {
    val CHECKED = setOf("port", "limit", "percepts", "act", "filter", "change_filter")

    override fun check(scene: Scene, report: Report) {
        val calls = scene.program.mentions[Role.INTERNAL].mapNotNull { call ->
            ArgoActions.actionIn(call.functor)?.let { Call(it, call, scene) }
        }
        calls.forEach { call(it, calls, report) }
        severalPorts(calls, report)
        slowLimit(calls, report)
        val literals = scene.program.program.nodes().filterIsInstance<Literal>().toList()
        literals.filter { it.indicator == "port/2" }.forEach { portBelief(it, calls, report) }
        literals.filter { it.indicator == "source/1" }.forEach { source(it, report) }
        literals.filter { it.indicator == "error/1" }.forEach { error(it, report) }
    }

    /** @property action the action's name without `argo.` */
    private class Call(val action: String, val mention: Mention, val scene: Scene) {
        val name: String get() = mention.functor
        val arguments: List<Term> get() = mention.literal.arguments

        fun textOf(term: Term): String = scene.program.program.text.substring(term.span.start, term.span.end)
    }

    private fun call(call: Call, calls: List<Call>, report: Report) {
        if (!ArgoActions.exists(call.name)) {
            val action = call.action.lowercase()
            val meant = SimilarNames.near(action, ArgoActions.NAMES) ?: action.takeIf { it in ArgoActions.NAMES }
            report.error(
                "internal-action", call.mention.span, "there is no internal action ${call.name}",
                "Jason takes it for an action of the environment",
                meant?.let { "did you mean argo.$it?" } ?: "the actions are ${ArgoActions.NAMES.joinToString { "argo.$it" }}",
            )
            return
        }
        when (call.action) {
            "port" -> port(call, report)
            "limit" -> limit(call, report)
            "percepts" -> percepts(call, report)
            "act" -> act(call, calls, report)
            "filter", "change_filter" -> filter(call, report)
        }
    }

    private fun port(call: Call, report: Report) {
        if (call.arguments.size !in 1..2) return arity(call, "the port, and optionally a list of options", report)
        val port = call.arguments.first()
        val options = call.arguments.getOrNull(1)
        val what = "the second argument of ${call.name} is a list of options"
        when {
            options is Literal && options.functor in TRUTH_VALUES -> report.error(
                "port-options", options.span, "$what here, not ${options.functor}", "the plan fails there",
                "remove it: an agent of ARGO sleeps while idle and wakes for its percepts",
            )
            options is ListTerm -> Options.check(options, KnownOption.OF_PORT, call.name, report)
            options != null && options !is Variable ->
                report.error("port-options", options.span, what, "the plan fails there", "such as [baud(115200), timeout(1000)]")
        }
        when {
            port is Variable && PORT_LIKE.matches(port.name.text) -> report.hint(
                "port-variable", port.span, "${port.name} is a variable to Jason", "while it is unbound, its name stands for the port",
                "write \"${port.name}\", with quotes",
            )
            port !is Literal && port !is StringTerm && port !is Variable && port !is Missing -> report.error(
                "port-name", port.span, "${call.textOf(port)} is not a term that Jason reads as a port", "the plan fails there",
                "put it in quotes",
            )
        }
    }

    private fun severalPorts(calls: List<Call>, report: Report) {
        val named = portsIn(calls).filter { nameOf(it) != "none" }
            .distinctBy(::nameOf)
        named.drop(1).forEach {
            report.hint(
                "several-ports", it.span, "${nameOf(it)} is another port than ${nameOf(named.first())} before",
                "both stay open, and switching resets no board", "argo.port(none) closes all ports",
            )
        }
    }

    private fun limit(call: Call, report: Report) {
        val argument = call.arguments.singleOrNull() ?: return arity(call, "the interval in milliseconds", report)
        val written = call.textOf(argument)
        val ms = written.toDoubleOrNull()
        when {
            argument is Literal || argument is StringTerm || argument is ListTerm -> report.error(
                "limit", argument.span, "the interval of ${call.name} is a number of milliseconds, not $written", "the plan fails there",
                "such as ${call.name}(100)",
            )
            ms == null -> {}
            ms < 0 || ms != Math.rint(ms) -> report.error(
                "limit", argument.span, "the interval of ${call.name} is a whole number of milliseconds from 0, not $written",
                "the plan fails there",
                "0 means as fast as the line allows",
            )
            ms >= MIN_NANOSECONDS -> report.error(
                "limit", argument.span,
                "${call.name}($written) is in milliseconds: one perception in ${(ms / MS_A_MINUTE).roundToLong()} minutes",
                "the agent perceives next to nothing", "for nanoseconds write ${call.name}(${(ms / NS_A_MS).roundToLong()})",
            )
        }
    }

    private fun portsIn(calls: List<Call>): List<Term> =
        calls.filter { it.action == "port" }.mapNotNull { it.arguments.firstOrNull() }.filter { it !is Variable }

    /** Reports a `.limit` with a long interval. Only programs for other ARGO versions write the dot. Such programs may mean nanoseconds. */
    private fun slowLimit(calls: List<Call>, report: Report) {
        val slow = calls.firstOrNull { call ->
            call.action == "limit" && call.name.startsWith(".") &&
                (call.arguments.singleOrNull()?.let(call::textOf)?.toDoubleOrNull() ?: 0.0) in MIN_SLOW_MS..<MIN_NANOSECONDS
        } ?: return
        val written = slow.textOf(slow.arguments.single())
        report.hint(
            "limit", slow.mention.span, "${slow.name}($written): one perception in $written ms",
            "some versions of ARGO read nanoseconds, without effect",
            "write a smaller number if the agent must be faster; 0 is as fast as the line allows",
        )
    }

    private fun percepts(call: Call, report: Report) {
        val word = call.arguments.singleOrNull() ?: return arity(call, "open, block or close", report)
        if (word is Variable || nameOf(word) in PERCEPTS) return
        report.error("percepts", word.span, "perception is set to open, block or close, not ${call.textOf(word)}", "the plan fails there",
            "use one of these words")
    }

    private fun act(call: Call, calls: List<Call>, report: Report) {
        val options = call.arguments.getOrNull(1)
        if (call.arguments.size !in 1..2 || options != null && options !is ListTerm && options !is Variable) {
            return arity(call, "one literal, as in ${call.name}(speed(120)), and optionally a list of options", report)
        }
        if (options is ListTerm) Options.check(options, KnownOption.OF_ACT, call.name, report)
        if (portsIn(calls).none { nameOf(it).startsWith("ros") }) unsendable(call.arguments.first(), report)
        val command = call.arguments.first() as? StringTerm ?: return
        if (!call.name.startsWith(".")) return
        report.hint(
            "act-string", command.span, "the string $command is sent without its quotes here", "some versions of ARGO sent them too",
            "if the board expects quotes, write a structure with a string: say($command)",
        )
    }

    /** Reports a command that cannot be sent to a board. */
    private fun unsendable(command: Term, report: Report) {
        val text = RobotRules.textOf(command) ?: return
        val why = if (PerceptsRequest.isIn(text)) "a board takes $text for the request for percepts" else try {
            Frame.ofCommand(text)
            return
        } catch (refused: IllegalArgumentException) {
            refused.message.orEmpty()
        }
        report.error("act", command.span, why, "the plan fails there", "send another command")
    }

    private fun filter(call: Call, report: Report) {
        val first = call.arguments.firstOrNull()
        val form = first?.let(::nameOf)
        val inPlan = "is a filter written into the plan"
        when {
            form == "remove" ->
                report.error("filter-call", call.mention.span, "${call.name}(remove) $inPlan", "the plan fails there",
                    "argo.change_filter(none)")
            form in FILTER_FORMS && call.arguments.size > 1 -> report.error(
                "filter-call", call.mention.span, "${call.name}($form, …) $inPlan", "the plan fails there",
                "write a filter file (docs/filters.md), and call argo.change_filter(NAME)",
            )
            call.arguments.size != 1 -> arity(call, "the name of a filter", report)
            first is ListTerm || first is NumberTerm -> report.error(
                "filter-call", call.mention.span, "${call.name} takes one name", "the plan fails there",
                "an atom or a string, such as argo.change_filter(front), or none",
            )
        }
    }

    private fun portBelief(belief: Literal, calls: List<Call>, report: Report) {
        val (port, status) = belief.arguments
        if (status is Literal && status.arity == 0 && status.functor !in STATUSES) {
            report.error("port-state", status.span, "a port is never ${status.functor}", "the plan is never used",
                "the states are ${STATUSES.joinToString()}")
        }
        if (status is ListTerm) Options.check(status, KnownOption.OF_PORT, "a port", report)
        val name = if (port is Literal || port is StringTerm) nameOf(port) else return
        val same = portsIn(calls).filter { shortName(nameOf(it)) == shortName(name) }
        if (same.isEmpty() || same.any { nameOf(it) == name && it is Literal == port is Literal }) return
        report.error(
            "port-name", port.span,
            "the belief has the name passed to argo.port, ${nameOf(same.first())}, so that ${nameOf(port)} never matches",
            "the plan is never used",
            "write the same in both places, or a variable here",
        )
    }

    private fun source(annotation: Literal, report: Report) {
        val source = (annotation.arguments.single() as? Literal)?.functor
        if (source !in BODY_SOURCES) return
        report.error(
            "belief-source", annotation.span, "no belief has source($source) here",
            "percepts of a board, and the states of ports, have source(percept)",
            "source(percept), or no annotation",
        )
    }

    /** Warns of a name that resembles an error of an action. Other unknown errors may come from the project's own `.fail`. */
    private fun error(annotation: Literal, report: Report) {
        val written = (annotation.arguments.single() as? Literal)?.takeIf { it.arity == 0 }?.functor ?: return
        if (written in ArgoActions.ERRORS || written in ArgoActions.JASON_ERRORS) return
        val meant = SimilarNames.near(written, ArgoActions.ERRORS + ArgoActions.JASON_ERRORS) ?: return
        report.warning("error-atom", annotation.span, "no action fails with error($written)",
            "the plan is never used, unless .fail makes it", "did you mean error($meant)?")
    }

    private fun arity(call: Call, expected: String, report: Report) =
        report.error("internal-action-arguments", call.mention.span, "${call.name} has ${call.arguments.size} arguments",
            "the plan fails there", "it takes $expected")

    private fun nameOf(term: Term): String = when (term) {
        is Literal -> term.functor
        is StringTerm -> term.text
        else -> "$term"
    }

    private fun shortName(name: String): String = name.substringAfterLast('/')

    private val TRUTH_VALUES = setOf("true", "false")
    private val STATUSES = listOf("on", "off", "timeout")
    private val PERCEPTS = setOf("open", "block", "close")
    private val FILTER_FORMS = setOf("only", "except", "value")
    private val BODY_SOURCES = setOf("interoception", "proprioception", "exteroception")
    private val PORT_LIKE = Regex("COM\\d+|[Tt][Tt][Yy]\\w+")

    /** From this number on, an interval is probably in nanoseconds. */
    private const val MIN_NANOSECONDS = 1_000_000.0
    private const val MIN_SLOW_MS = 200.0
    private const val MS_A_MINUTE = 60_000.0
    private const val NS_A_MS = 1_000_000.0
}
