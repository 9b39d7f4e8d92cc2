package argo.tools.board

import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.ToolException
import argo.tools.command.printable
import javino.Link
import javino.Protocol
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters

/** A command that says one thing to a board. */
@Command
internal abstract class MessageCommand : ToolCommand() {
    @Mixin
    protected lateinit var line: LineOptions

    @Option(names = ["--json"], description = ["prints an object of JSON"])
    protected var json = false

    @Parameters(index = "0", paramLabel = "PORT", description = ["ttyACM0, COM8, /dev/pts/3, replay:FILE"])
    private lateinit var port: String

    @Parameters(index = "1", paramLabel = "MESSAGE", description = ["the message's text, as in \"speed(120)\""])
    protected lateinit var message: String

    final override fun call(): Int = try {
        line.open(port).use(::exchange)
        ExitStatus.DONE
    } catch (unsendable: IllegalArgumentException) { // a message that fits into no frame
        throw ToolException(unsendable.message.orEmpty())
    }

    protected abstract fun exchange(link: Link)
}

/** `request`: asks a board and prints its answer. */
@Command(name = "request", description = ["Sends a request, such as getPercepts, and prints the answer. Opening a port resets most boards."])
internal class RequestCommand : MessageCommand() {
    override fun exchange(link: Link) {
        val answer = link.request(message, line.timeoutMs).text()
        if (!json) return out.println(printable(answer))
        out.println(
            buildJsonObject {
                put("port", link.port())
                put("request", message)
                put("answer", answer)
                put("protocol", versionSpoken(link.protocol()))
            },
        )
    }
}

/** `send`: sends a command. */
@Command(
    name = "send",
    description = [
        "Sends a command. A board of version 2 says whether it has acted; one of version 1 says nothing.",
        "Opening a port resets most boards.",
    ],
)
internal class SendCommand : MessageCommand() {
    override fun exchange(link: Link) {
        link.sendAndAwait(message, line.timeoutMs)
        val acted = link.protocol() == Protocol.V2
        if (!json) return out.println(if (acted) "the board has acted" else "sent; a board of version 1 does not tell whether it acted")
        out.println(
            buildJsonObject {
                put("port", link.port())
                put("sent", message)
                put("acted", if (acted) true else null)
                put("protocol", versionSpoken(link.protocol()))
            },
        )
    }
}
