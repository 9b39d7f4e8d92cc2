package argo.check.rules

import argo.check.project.Mention
import argo.check.project.Role
import argo.check.syntax.Block
import argo.check.syntax.Bracketed
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.NumberTerm
import argo.check.syntax.Operation
import argo.check.syntax.Prefixed
import argo.check.syntax.StringTerm
import argo.check.syntax.Term
import argo.check.syntax.Variable

/** Finds calls of internal actions that do not exist or have other arguments. */
internal object InternalActionRules : Rule {
    private val PERFORMATIVES = setOf(
        "tell", "untell", "achieve", "unachieve", "askOne", "askAll", "askHow", "tellHow", "untellHow", "signal", "untellAll", "ask",
        "tellRule",
    )

    override fun check(scene: Scene, report: Report) {
        for (call in scene.program.mentions[Role.ACTION]) {
            InternalAction.of(call.literal)?.let { kinds(call, it, scene, report) }
            if (call.functor == "makeArtifact") artifact(call, report)
        }
        val often = scene.facts.often(Role.INTERNAL)
        for (call in scene.program.mentions[Role.INTERNAL]) {
            val action = InternalAction.ALL[call.functor]
            when {
                ArgoActions.actionIn(call.functor) in ArgoCallRules.CHECKED -> {}
                action != null -> arguments(call, action, scene, report)
                call.functor in InternalAction.FUNCTIONS -> {}
                call.functor.startsWith(".") && call.functor.count { it == '.' } == 1 ->
                    if (call.functor !in scene.project.javaActions) unknown(call, report)
                else -> foreign(call, often, scene, report)
            }
        }
    }

    private fun unknown(call: Mention, report: Report) {
        if (ArgoActions.actionIn(call.functor) != null) return
        val meant = SimilarNames.near(call.functor, InternalAction.ALL.keys.filter { it.startsWith(".") })
        report.error(
            "internal-action", call.span, "there is no internal action ${call.functor}", "the plan fails there",
            meant?.let { "did you mean $it?" } ?: "a project's own actions have a package in front, as my.act",
        )
    }

    /** Checks an action with a package. The project's own classes are known, but not those of libraries. */
    private fun foreign(call: Mention, often: Map<String, Int>, scene: Scene, report: Report) {
        if (call.functor in scene.project.javaActions || ArgoActions.actionIn(call.functor) != null) return
        val others = often.filter { it.value > often.getValue(call.functor) }.keys + scene.project.javaActions + InternalAction.FUNCTIONS +
            InternalAction.ALL.keys
        val meant = SimilarNames.near(call.functor, others) ?: return
        report.warning("internal-action", call.span, "there is no internal action ${call.functor} in the project", "the plan fails there",
            "did you mean $meant?")
    }

    private fun arguments(call: Mention, action: InternalAction, scene: Scene, report: Report) {
        if (call.arity !in action.arities) {
            report.error(
                "internal-action-arguments", call.span, "${call.functor} has ${call.arity} arguments", "the plan fails there",
                "it takes ${action.takes}",
            )
            return
        }
        if (action.since != null) {
            val what = "${call.functor} is there since Jason ${action.since}"
            report.hint("internal-action", call.span, what, "an older Jason fails there", "no change is needed for Jason ${action.since}")
        }
        kinds(call, action, scene, report)
        if (call.functor == ".send") receiver(call, scene, report)
        emptyRange(call, report)
    }

    private fun kinds(call: Mention, action: InternalAction, scene: Scene, report: Report) =
        action.kinds.zip(call.literal.arguments).forEachIndexed { index, (kind, argument) ->
            if (kind == 'p') performative(call, index, argument, report) else if (!mayBe(kind, argument)) {
                report.error(
                    "internal-action-arguments", argument.span,
                    "argument ${index + 1} of ${call.functor} is ${InternalAction.WORDS[kind]}, not ${textOf(argument, scene)}",
                    "the plan fails there", "correct the arguments, or their order",
                )
            }
        }

    private fun artifact(call: Mention, report: Report) {
        val (name, type) = call.literal.arguments.take(2).map { it as? StringTerm ?: return }.takeIf { it.size == 2 } ?: return
        if (isTypeName(type.text) || !isTypeName(name.text)) return
        report.warning("internal-action-arguments", name.span + type.span,
            "argument 2 of makeArtifact is the name of a Java class, and $name looks like one, not $type", "the action fails",
            "correct the order of the arguments")
    }

    private fun isTypeName(text: String) = '.' in text || text.firstOrNull()?.isUpperCase() == true

    /** Reports a `.range` whose start is greater than its end. */
    private fun emptyRange(call: Mention, report: Report) {
        if (call.functor != ".range" || call.arity != RANGE_WITHOUT_STEP) return
        val (from, to) = call.literal.arguments.drop(1).map { it as? NumberTerm ?: return }
        if (from.value <= to.value) return
        report.warning("internal-action-arguments", from.span + to.span, "the range from $from to $to is empty", "nothing is done",
            "correct the order of the arguments")
    }

    private fun performative(call: Mention, index: Int, argument: Term, report: Report) {
        val written = (argument as? Literal)?.takeIf { it.arity == 0 }?.functor
        if (written == null) {
            if (argument is ListTerm || argument is NumberTerm || argument is Literal || argument is Block) {
                report.error("performative", argument.span, "a performative is an atom, as tell or achieve", "the plan fails there",
                    "correct the order of the arguments")
            }
            return
        }
        if (written in PERFORMATIVES) return
        val content = call.literal.arguments.getOrNull(index + 1) as? Literal
        if (content?.functor in PERFORMATIVES) {
            report.warning(
                "performative", argument.span, "$written is no performative of Jason, and ${content?.functor} behind it is one",
                "the receiver takes no notice",
                "correct the order of the arguments",
            )
        }
        val meant = SimilarNames.near(written, PERFORMATIVES) ?: return
        report.warning(
            "performative", argument.span, "$written is no performative of Jason",
            "the receiver takes no notice, unless it has plans for it",
            "did you mean $meant?",
        )
    }

    private fun receiver(call: Mention, scene: Scene, report: Report) {
        val receiver = call.literal.arguments.first() as? Literal ?: return
        if (receiver.functor in PERFORMATIVES && (call.literal.arguments[1] as? Literal)?.functor !in PERFORMATIVES) {
            report.warning(
                "internal-action-arguments", receiver.span, "argument 1 of .send is the receiver, and here ${receiver.functor}",
                "the plan fails there",
                "correct the order of the arguments",
            )
        }
        val names = scene.project.masFiles.flatMap { mas -> mas.agents.flatMap { it.names + it.name.text } } + "self"
        if (receiver.arity > 0 || receiver.functor in names || receiver.functor in scene.project.foreignNames) return
        val what = "there is no agent ${receiver.functor}"
        val remedy = SimilarNames.near(receiver.functor, names)?.let { "did you mean $it?" }
            ?: scene.facts.agentNames?.let { "there are ${it.joinToString()}" } ?: return
        report.warning("receiver", receiver.span, what, "the plan fails there", remedy)
    }

    /** Returns false if [argument] cannot be of [kind]. A term that Jason may evaluate can be of every kind. */
    private fun mayBe(kind: Char, argument: Term): Boolean = (kind in OF_FORMULAS || !isFormula(argument)) && when (kind) {
        'l' -> !isNumber(argument) && argument !is StringTerm && argument !is Block && !isAtom(argument) && !isStructure(argument)
        'n' -> argument !is ListTerm && argument !is Block && argument !is StringTerm && !isAtom(argument) && !isStructure(argument)
        's' -> argument !is ListTerm && argument !is Block
        'e' -> !isNumber(argument) && !isAtom(argument)
        'v' -> argument is Variable
        'a' -> argument is Variable || isAtom(argument) && !(argument as Literal).isNegated
        'b' -> argument is Variable || argument is Literal && argument.indicator in PLACES
        'd' -> !(argument is Literal && argument.isInternal)
        'f' -> argument !is NumberTerm && argument !is ListTerm
        't' -> argument !is NumberTerm && argument !is ListTerm
        else -> true
    }

    private fun isFormula(term: Term): Boolean = when (term) {
        is Bracketed -> isFormula(term.term)
        is Operation -> !term.isArithmetic
        else -> false
    }

    private fun isNumber(term: Term): Boolean =
        term is NumberTerm || term is Operation && term.isArithmetic || term is Prefixed ||
            term is Literal && term.functor in InternalAction.FUNCTIONS

    private fun isAtom(term: Term) = term is Literal && term.arity == 0 && !term.isInternal

    private fun isStructure(term: Term) = term is Literal && term.arity > 0 && !term.isInternal

    private fun textOf(term: Term, scene: Scene) = scene.program.program.text.substring(term.span.start, term.span.end).take(MAX_TEXT)

    private const val OF_FORMULAS = "ft_"
    private val PLACES = setOf("begin/0", "end/0")
    private const val MAX_TEXT = 40
    private const val RANGE_WITHOUT_STEP = 3
}
