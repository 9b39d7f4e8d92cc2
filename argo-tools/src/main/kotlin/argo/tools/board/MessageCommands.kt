package argo.tools.board

import argo.filters.withControlsShown
import argo.links.BoardLink
import argo.tools.command.DataCommand
import argo.tools.command.ExitStatus
import argo.tools.command.ToolException
import argo.tools.command.jsonOf
import javino.ActionRefusedException
import javino.PerceptsRequest
import javino.Protocol
import javino.link.Link
import javino.link.SendOptions
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Parameters

@Command
internal abstract class MessageCommand : DataCommand() {
    @Mixin
    protected lateinit var line: LineOptions

    @Parameters(index = "0", paramLabel = "PORT", description = ["ttyACM0, COM8, /dev/pts/3, replay:FILE; of send also ros://robot:9090"])
    protected lateinit var port: String

    @Parameters(index = "1", paramLabel = "MESSAGE", description = ["the message's text, as in \"speed(120)\""])
    protected lateinit var message: String

    final override fun call(): Int = try {
        exchange()
        ExitStatus.DONE
    } catch (unsendable: IllegalArgumentException) { // the message does not fit into a frame
        throw ToolException(unsendable.message.orEmpty())
    }

    protected abstract fun exchange()
}

@Command(name = "request", description = ["Sends a request, as getPercepts, and prints the answer. Opening a port resets most boards."])
internal class RequestCommand : MessageCommand() {
    override fun exchange() = line.open(port).use { link ->
        val answer = link.request(message, line.timeoutMs).text()
        val members = arrayOf("port" to link.port(), "request" to message, "answer" to answer, "protocol" to versionSpoken(link.protocol()))
        out.println(if (json) jsonOf(*members) else withControlsShown(answer))
    }
}

@Command(
    name = "send",
    description = [
        "Sends a command. A board of version 2 acknowledges it; one of version 1 does not.",
        "A board that lists its actions acknowledges only what it has carried out.",
        "Opening a port resets most boards.",
    ],
)
internal class SendCommand : MessageCommand() {
    override fun exchange() {
        if (message.isEmpty()) misuse("a command has at least one character")
        if (PerceptsRequest.isIn(message)) {
            misuse("$message is the request for percepts and no command: \"request $port $message\" sends it")
        }
        line.openElsewhere(port)?.use(::exchange) ?: line.open(port).use(::exchange)
    }

    private fun exchange(link: BoardLink) {
        val answer = link.sendAndAwait(message, SendOptions(false, line.givenTimeoutMs))
        if (json) return out.println(jsonOf("port" to link.port, "sent" to message, "acted" to true, "answer" to answer?.text))
        out.println(withControlsShown("done" + answer?.text?.let { "; the answer is $it" }.orEmpty()))
    }

    private fun exchange(link: Link) {
        try {
            link.sendAndAwait(message, line.timeoutMs)
        } catch (refused: ActionRefusedException) {
            throw ToolException("${refused.message}; \"ports --describe ${link.port()}\" shows what the board can do")
        }
        val taken = true.takeIf { link.protocol() == Protocol.V2 }
        val acted = taken.takeUnless { actionsOf(link).isNullOrEmpty() }
        if (!json) return out.println(if (acted != null) "the board has acted" else if (taken != null) TAKEN else UNCONFIRMED)
        val protocol = versionSpoken(link.protocol())
        out.println(jsonOf("port" to link.port(), "sent" to message, "taken" to taken, "acted" to acted, "protocol" to protocol))
    }

    private companion object {
        /** The answer for a sketch without action table. The sketch acknowledges every message, even an unknown one. */
        const val TAKEN = "the board has taken the command; it lists no actions, so nobody knows whether it acted or has ignored it"

        /** The answer for a port that does not respond. The port may have no board, or a version 1 board. */
        const val UNCONFIRMED = "sent; no board of version 2 has answered, and one of version 1 does not report whether it acted. " +
            "\"request PORT getPercepts\" shows whether there is one"
    }
}
