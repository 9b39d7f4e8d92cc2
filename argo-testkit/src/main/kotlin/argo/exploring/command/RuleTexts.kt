package argo.exploring.command

import argo.exploring.ReadyRule
import argo.exploring.Rule
import argo.exploring.actsAgain
import argo.exploring.handlesFailures
import argo.exploring.losesNoCommand
import argo.exploring.neverActsOnStalePercepts
import argo.exploring.neverFloods
import argo.exploring.neverOscillates
import argo.exploring.neverSends
import argo.exploring.neverWaitsForever
import argo.exploring.perceivesAgain
import argo.exploring.reactsTo
import argo.exploring.sendsAgain
import argo.exploring.sendsOnly
import argo.exploring.staysAlive
import argo.exploring.staysSmall
import argo.exploring.stopsWhenBlind
import argo.testkit.literalIn
import jason.asSyntax.ListTerm
import jason.asSyntax.NumberTerm
import jason.asSyntax.StringTerm
import jason.asSyntax.Term

/** A kind of rule with the syntax [usage]. [make] returns the rule for its arguments, or null if they are wrong. */
private class RuleText(val usage: String, val make: (List<Term>) -> Rule?)

private fun plain(usage: String, make: () -> Rule) = RuleText(usage) { if (it.isEmpty()) make() else null }

/** A kind of rule whose arguments, if any, are whole numbers. */
private fun numbers(usage: String, make: (List<Int>) -> Rule?) = RuleText(usage) { terms ->
    val numbers = terms.mapNotNull { (it as? NumberTerm)?.solve()?.toInt() }
    if (numbers.size == terms.size) make(numbers) else null
}

/** A kind of rule whose only argument, if any, is a list of commands. */
private fun except(usage: String, make: (List<String>) -> Rule) = RuleText(usage) { terms ->
    when (terms.size) {
        0 -> make(emptyList())
        1 -> words(terms[0])?.let(make)
        else -> null
    }
}

private val RULES: Map<String, RuleText> = listOf(
    plain("staysAlive", ::staysAlive),
    plain("handlesFailures", ::handlesFailures),
    plain("losesNoCommand", ::losesNoCommand),
    plain("perceivesAgain", ::perceivesAgain),
    plain("actsAgain", ::actsAgain),
    except("neverWaitsForever([patrol])") { neverWaitsForever(except = it) },
    except("neverActsOnStalePercepts([stop])") { neverActsOnStalePercepts(except = it) },
    numbers("staysSmall(20,200,50)") { if (it.size == 3) staysSmall(it[0], it[1], it[2]) else if (it.isEmpty()) staysSmall() else null },
    numbers("neverFloods(20)") { if (it.size == 1) neverFloods(it[0]) else if (it.isEmpty()) neverFloods() else null },
    numbers("neverOscillates(3)") { if (it.size == 1) neverOscillates(it[0]) else if (it.isEmpty()) neverOscillates() else null },
    RuleText("stopsWhenBlind(stop,[front])") { pair(it) { safe, moving -> stopsWhenBlind(word(safe), words(moving) ?: return@pair null) } },
    RuleText("reactsTo(\"dist(front,D) & D < 20\",[stop])") {
        pair(it) { percept, commands -> reactsTo(word(percept), words(commands) ?: return@pair null) }
    },
    RuleText("neverSends([front],\"dist(front,D) & D < 20\")") {
        pair(it) { commands, percept -> neverSends(words(commands) ?: return@pair null, word(percept)) }
    },
    RuleText("sendsAgain([stop])") { terms -> terms.singleOrNull()?.let(::words)?.let { sendsAgain(it) } },
    RuleText("sendsOnly([front,\"speed/1\"])") { terms -> terms.singleOrNull()?.let(::words)?.let(::sendsOnly) },
).associateBy { it.usage.substringBefore('(') }

/**
 * Makes the rule for [text], a Jason term such as `stopsWhenBlind(stop,[front])`.
 *
 * @throws IllegalArgumentException if there is no such rule
 */
internal fun ruleOf(text: String): Rule {
    val call = requireNotNull(literalIn(text)) { noSuchRule(text) }
    val rule = requireNotNull(RULES[call.functor]) { noSuchRule(text) }
    return requireNotNull(rule.make(call.terms.orEmpty())) { "the rule ${call.functor} is written as ${rule.usage}, not $text" }
}

internal fun isKnownRule(name: String) = name in RULES

internal fun isNamed(rule: Rule, name: String) = rule is ReadyRule && rule.function == name

internal fun noSuchRule(text: String) = "there is no rule $text; there are ${RULES.values.joinToString { it.usage }}"

private fun pair(terms: List<Term>, make: (Term, Term) -> Rule?): Rule? = if (terms.size == 2) make(terms[0], terms[1]) else null

private fun word(term: Term) = if (term is StringTerm) term.string else "$term"

private fun words(term: Term): List<String>? = (term as? ListTerm)?.map(::word)
