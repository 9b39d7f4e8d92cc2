package argo.recording.replay

import argo.boundary.InternalCall
import argo.recording.agent.CallWatch
import argo.recording.agent.WatchedKind
import jason.asSemantics.Unifier
import jason.asSyntax.Term

/**
 * Asks [watch] about each call of the code that Jason has looked up as it read a program. As long as [watch] is null, it carries out no
 * code that touches the outside, except the project's own code if [isCarryingOut].
 */
internal class LateWatch(private val isCarryingOut: Boolean) : CallWatch {
    /** The watch that is asked; null: the program is being read. */
    var watch: CallWatch? = null

    override fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any =
        watch?.call(call, code, live) ?: if (isCarryingOut && code != WatchedKind.OUTSIDE) live(call.un) else false

    override fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double =
        watch?.evaluate(name, args, isOfProject, live) ?: if (isOfProject && !isCarryingOut) Double.NaN else live()
}
