package argo.lsp

import argo.tools.command.ToolCommand
import argo.tools.command.ToolProvider
import org.eclipse.lsp4j.launch.LSPLauncher
import picocli.CommandLine.Command
import java.io.FileDescriptor
import java.io.FileInputStream
import java.io.FileOutputStream

@Command(
    name = "lsp",
    description = [
        "Serves an editor by the language server protocol, on standard input and output, for agents (.asl), projects (.mas2j) and " +
            "filters (.xml, .json). An editor starts it.",
    ],
)
internal class LspCommand : ToolCommand() {
    override fun call(): Int {
        val protocol = FileOutputStream(FileDescriptor.out)
        System.setOut(System.err) // any other output would break the protocol
        return Server().use { server ->
            val launcher = LSPLauncher.createServerLauncher(server, FileInputStream(FileDescriptor.`in`).buffered(), protocol)
            server.connect(launcher.remoteProxy)
            server.awaitEnd(launcher.startListening())
        }
    }
}

/** Adds `lsp` to the tools. */
class LspCommandProvider : ToolProvider {
    override fun command(): Any = LspCommand()
}
