package argo

import argo.calls.ArgumentException
import argo.calls.Failure
import argo.orders.Offer
import jason.asSyntax.ListTerm
import jason.asSyntax.Term

/**
 * The internal action `argo.reload`: reads the agent's program and its active filters again, while the agent runs. Plans and rules that
 * have changed are exchanged between two reasoning cycles. All other plans and rules stay, even plans that were added at run time.
 * Intentions finish the plans that they have begun. No port is closed.
 *
 * The log lists the changes, and the initial beliefs and goals that are new. `argo.reload([beliefs, goals])` also adds these beliefs and
 * begins these goals. If the agent refuses one of them, such as a goal without a plan, the log says so. New beliefs and goals that are
 * refused or not added are reported again at the next reload.
 *
 * The intention waits until the program is exchanged. Another thread reads the files.
 *
 * Fails the plan, without any change, with `error(bad_program)` if the program or a filter cannot be read, `error(wrong_arguments)` or
 * `error(not_argo)`.
 */
@Suppress("ClassName")
open class reload : BoardInternalAction("argo.reload", 0..1) {
    override val suspends get() = true

    override fun run(call: Call) {
        val arch = call.arch
        val takes = call.args.getOrNull(0)?.let(::offersIn).orEmpty()
        val outcome = call.suspendIntention()
        arch.reloading.start(takes) {
            it.told.forEach(arch.boards.log::info)
            outcome(it.refusal?.let { why -> Failure("bad_program", why) }, null)
        }
    }

    private fun offersIn(list: Term): Set<Offer> {
        val known = Offer.entries.joinToString { it.word }
        val options = (list as? ListTerm)?.takeIf { it.isList && it.tail == null }?.asList
            ?: throw ArgumentException("the argument is a list of $known, not $list")
        return options.mapTo(HashSet()) { option ->
            Offer.entries.find { it.word == "$option" } ?: throw ArgumentException("$option is not an option; there are $known")
        }
    }
}
