package argo.testkit

import jason.asSemantics.Agent
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.LogicalFormula
import jason.asSyntax.Trigger
import jason.asSyntax.directives.DirectiveProcessor
import jason.asSyntax.directives.Include
import jason.asSyntax.parser.ParseException
import jason.asSyntax.parser.TokenMgrError
import jason.runtime.Settings
import jason.runtime.SourcePath
import jason.util.Config
import java.nio.file.Path

internal class AgentInspector(private val ts: TransitionSystem) {
    val beliefs: List<String>
        get() = ts.ag.bb.filterNot { it.isRule || it.ns.functor == KQML }.map { it.copy().apply { clearAnnots() }.toString() }.sorted()

    /** The agent's intentions in alphabetical order. Each one lists its goals, the latest first, and its next step. */
    val intentions: List<String>
        get() = ts.c.allIntentions.asSequence().toList().distinctBy { it.id }.map(::described).filter(String::isNotEmpty).sorted()

    fun believes(formula: LogicalFormula): Boolean = ts.ag.believes(formula, Unifier())

    fun intends(goal: Trigger): Boolean = ts.c.allIntentions.asSequence().any { it.hasTrigger(goal, Unifier()) }

    private fun described(intention: Intention) = intention.joinToString(" for ") { means ->
        val step = means.currentStep?.head?.let { " at $it" }.orEmpty()
        "${means.trigger.type}${means.trigger.literal.copy().apply { clearAnnots() }}$step"
    }
}

private const val KQML = "kqml"

/** @throws IllegalArgumentException if [text] is no condition as in a plan's context */
internal fun formula(text: String): LogicalFormula = parsed(text, "a belief or a formula such as dist(front,X) & X < 40") {
    ASSyntax.parseFormula(text)
}

/** @throws IllegalArgumentException if [text] is not a goal */
internal fun goal(text: String): Trigger = parsed(text, "a goal such as patrol or goto(3,_)") {
    ASSyntax.parseTrigger("+!" + text.removePrefix("+").removePrefix("!"))
}

internal fun literalIn(text: String): Literal? = try {
    ASSyntax.parseLiteral(text)
} catch (_: ParseException) {
    null
} catch (_: TokenMgrError) {
    null
}

internal fun <T> parsed(text: String, expected: String, parse: () -> T): T = try {
    parse()
} catch (unreadable: ParseException) {
    throw IllegalArgumentException("\"$text\" is not $expected: ${unreadable.message.orEmpty().lineSequence().first()}", unreadable)
} catch (unreadable: TokenMgrError) {
    throw IllegalArgumentException("\"$text\" is not $expected: ${unreadable.message.orEmpty().lineSequence().first()}", unreadable)
}

/**
 * Makes the agent in [file] on the infrastructure [infra], as Jason does. Changes Jason's source path for the whole Java program.
 *
 * @throws IllegalArgumentException if Jason cannot read the file
 */
@Synchronized
internal fun create(file: Path?, called: String, setUp: AgentSetUp, infra: InfraArch, counter: PerceptionCounter): TransitionSystem {
    Config.get()[Config.START_WEB_MI] = "false"
    val paths = SourcePath().apply { (listOfNotNull(file?.parent?.toString()) + setUp.sourcePaths).forEach(::addPath) }
    (DirectiveProcessor.getDirective("include") as Include).setSourcePath(paths)
    val settings = Settings().apply { setOptions(HashMap<String, Any>(setUp.options)) }
    reading(file, called) { Agent.create(infra, setUp.agentClass.name, setUp.beliefBase, file?.toString(), settings) }
    val ts = infra.ts
    infra.insertAgArch(infra)
    setUp.arch?.invoke(setUp.platform)?.let {
        it.ts = ts
        infra.insertAgArch(it)
        it.init()
    }
    infra.insertAgArch(counter)
    ts.setLogger(infra)
    ts.ag.setLogger(infra)
    return ts
}
