package argo.pausing

import argo.acting.CommandOptions
import argo.acting.commandText
import argo.boards.AgentBoards
import argo.boards.Board
import argo.calls.ArgumentException
import argo.calls.Failure
import argo.calls.wrongArgument
import jason.asSyntax.Term
import java.util.concurrent.CompletableFuture

/** Makes [boards] safe by [command] before their agent is paused. */
internal class SafeCommand(private val command: Term, private val boards: AgentBoards) {
    /**
     * Sends the command to each board that the agent perceives, ahead of all waiting commands. If commands wait, sends it once more after
     * them. Only for the agent's thread.
     *
     * @return the result at each board, in words for a person; completed within [LIMIT_MS] ms, by any thread
     */
    fun send(): List<CompletableFuture<String>> = boards.current.map(::send)

    private fun send(board: Board): CompletableFuture<String> {
        val end = CompletableFuture<String>()
        val told = { failure: Failure? -> end.complete(words(board, failure)).let { } }
        try {
            val areOthers = boards.current.any { it.ledger.isPending(board.port) }
            send(board, isUrgent = true, if (areOthers) ({ }) else told)
            if (areOthers) send(board, isUrgent = false, told)
        } catch (wrong: ArgumentException) {
            told(wrongArgument(wrong.message.orEmpty()))
        }
        return end
    }

    private fun send(board: Board, isUrgent: Boolean, ended: (Failure?) -> Unit) {
        val text = commandText(command, board.port.link.isLine)
        boards.send(board.port, text, CommandOptions(LIMIT_MS, isUrgent)).follow({ }) { failure, _ -> ended(failure) }
    }

    private fun words(board: Board, failure: Failure?) =
        if (failure == null) "the board on ${board.term} has got $command"
        else "the board on ${board.term} has not got $command: ${failure.cause}"

    companion object {
        /** The time limit in ms for the command. After it, the board is reported as not safe. */
        const val LIMIT_MS = 2000
    }
}
