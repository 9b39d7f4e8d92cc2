package argo.recording.recorder

import argo.observing.IssuedCommand
import argo.recording.Call
import argo.recording.CallFailure
import argo.recording.Sent
import argo.recording.agent.laterText
import argo.recording.agent.textOf
import jason.asSyntax.Term

/** A call whose result is not known yet, or may become known later in the cycle. */
internal class CallNote private constructor(
    private val name: String,
    private val args: () -> List<String>,
    private val isOfProject: Boolean,
) {
    private val answers = ArrayList<Map<Int, String>>()
    private val commands = ArrayList<Sent>()
    private var hasEnded = false
    var value: String? = null
    var isBacktracking = false
    var failure: CallFailure? = null
    var number: Int? = null

    /** Another way to answer it has been found. What a loop finds in a later cycle is not recorded. */
    fun answered(answer: Map<Int, String>) {
        if (!hasEnded) answers += answer
    }

    fun sent(command: IssuedCommand) {
        commands += Sent(command.number, command.port, command.text)
    }

    /** The cycle is over. */
    fun end() {
        hasEnded = true
    }

    fun call() = Call(name, args(), answers, isBacktracking, failure, number, commands, isOfProject, value)

    companion object {
        /** A call of Jason or ARGO, which do not change its [args]: Jason has copied them. */
        fun of(name: String, args: Array<Term>) = CallNote(name, laterText(args.asList()) { args.map(::textOf) }, false)

        /** A call of the project, which may do with [args] what it wants. */
        fun ofProject(name: String, args: Array<Term>): CallNote {
            val texts = args.map(::textOf)
            return CallNote(name, { texts }, true)
        }
    }
}
