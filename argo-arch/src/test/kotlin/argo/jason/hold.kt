package argo.jason

import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Term
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/** An internal action that keeps its agent busy until the test lets it go: `argo.jason.hold`. */
@Suppress("ClassName")
class hold : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        val hold = current
        hold.begun.countDown()
        return hold.over.await(20, TimeUnit.SECONDS)
    }

    /** One time of being busy. */
    class Hold {
        val begun = CountDownLatch(1)
        val over = CountDownLatch(1)

        fun awaitBegin() = check(begun.await(20, TimeUnit.SECONDS)) { "the agent never became busy" }
    }

    companion object {
        @Volatile
        private var current = Hold()

        /** The next agent that calls the action is busy until the result's end. */
        fun next(): Hold = Hold().also { current = it }
    }
}
