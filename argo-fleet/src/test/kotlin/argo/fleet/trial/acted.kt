@file:Suppress("ClassName") // Jason finds internal actions by these names

package argo.fleet.trial

import argo.fleet.agents.FleetAgArch
import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Term
import java.io.File

/** The internal action `argo.fleet.trial.acted` notes an action of the agent and its reign. */
internal class acted : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        val arch = generateSequence(ts.agArch) { it.nextAgArch }.filterIsInstance<FleetAgArch>().first()
        val event = Event(System.nanoTime(), System.getProperty(SESSION), Kind.ACTED, listOf(arch.agName, "${arch.term}"))
        File(NOTES).appendText("$event\n")
        return true
    }

    companion object {
        /** The file of the notes in the program's directory. */
        const val NOTES = "acts.txt"

        /** The property with the name of the program's run, such as `scout1#2`. */
        const val SESSION = "argo.fleet.trial.session"
    }
}
