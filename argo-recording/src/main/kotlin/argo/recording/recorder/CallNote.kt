package argo.recording.recorder

import argo.observing.IssuedCommand
import argo.recording.Call
import argo.recording.CallFailure
import argo.recording.Sent
import argo.recording.agent.laterText
import argo.recording.agent.textOf
import jason.asSyntax.Term

/**
 * A call whose result becomes known later, perhaps in parts during the cycle.
 *
 * @param args the arguments that the action or function gets: Jason has copied them, but code of the project may change them
 */
internal class CallNote(val name: String, args: Array<Term>, val isOfProject: Boolean) {
    private val args: () -> List<String> = laterText(args.asList(), isOfProject) { args.map(::textOf) }
    private val answers = ArrayList<Map<Int, String>>()
    private val commands = ArrayList<Sent>()
    private var hasEnded = false
    var value: String? = null
    var isBacktracking = false
    var failure: CallFailure? = null
    var number: Int? = null

    /** Adds another answer to the call. Ignores answers that a loop finds in a later cycle. */
    fun answered(answer: Map<Int, String>) {
        if (!hasEnded) answers += answer
    }

    fun sent(command: IssuedCommand) {
        commands += Sent(command.number, command.port, command.text)
    }

    /** Ends the call with its cycle. */
    fun end() {
        hasEnded = true
    }

    fun call() = Call(name, args(), answers, isBacktracking, failure, number, commands, isOfProject, value)
}
