package argo.behaviour

import argo.testkit.VirtualTime
import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.NumberTerm
import jason.asSyntax.Term
import java.util.concurrent.TimeUnit

/** Keeps the reasoning cycle busy for its argument, in ms of virtual time: `argo.behaviour.busy(500)`. */
@Suppress("ClassName")
class busy : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        val time = checkNotNull(VirtualTime.active()) { "only an agent under test can be busy" }
        time.block(time.nanos() + TimeUnit.MILLISECONDS.toNanos((args.single() as NumberTerm).solve().toLong()), false) { false }
        return true
    }
}
