package argo.acting

import argo.calls.ArgumentException
import argo.calls.whole
import argo.calls.withOptions
import jason.asSyntax.Literal
import jason.asSyntax.Term

/**
 * The options of a command: the second argument of `argo.act`.
 *
 * @property timeoutMs the time limit for the outcome, in ms from the call; null if there is no limit
 * @property urgent whether the command overtakes waiting commands that are not urgent
 * @property latest whether the command replaces waiting commands with its functor
 * @property port the port of the command's board; null if the options name no port
 * @property answer the term with which the board's answer must unify; null if no answer is requested
 */
internal data class CommandOptions(
    val timeoutMs: Int? = null,
    val urgent: Boolean = false,
    val latest: Boolean = false,
    val port: Term? = null,
    val answer: Term? = null,
) {
    companion object {
        private const val MAX_MS = 600_000
        private const val KNOWN = "timeout(Ms), urgent, latest, port(P) and answer(R)"

        /** Reads a list such as `[timeout(200), latest]`. Throws [ArgumentException] if [term] is no list of known options. */
        fun of(term: Term): CommandOptions = withOptions(CommandOptions(), term, "[timeout(200), latest]", KNOWN) { with(it) }

        private fun CommandOptions.with(option: Term): CommandOptions? {
            val literal = (option as? Literal)?.takeUnless { it.isVar }
            return when {
                literal?.functor == "urgent" && literal.arity == 0 -> copy(urgent = true)
                literal?.functor == "latest" && literal.arity == 0 -> copy(latest = true)
                literal?.functor == "timeout" && literal.arity == 1 -> copy(timeoutMs = whole(literal, 1..MAX_MS))
                literal?.functor == "port" && literal.arity == 1 -> copy(port = literal.getTerm(0))
                literal?.functor == "answer" && literal.arity == 1 -> copy(answer = literal.getTerm(0))
                else -> null
            }
        }
    }
}
