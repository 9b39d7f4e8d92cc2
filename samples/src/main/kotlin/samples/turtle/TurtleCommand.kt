package samples.turtle

import argo.tools.command.ToolCommand
import jason.asSyntax.ASSyntax.createLiteral
import jason.asSyntax.ASSyntax.createString
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import samples.project.MasRun
import samples.project.SampleProject

@Command(
    name = "turtle",
    description = ["A turtle of turtlesim, which speaks ROS, drives to another one."],
    sortOptions = false,
)
internal class TurtleCommand : ToolCommand() {
    @Option(
        names = ["--port"], paramLabel = "port",
        description = ["turtlesim behind rosbridge_server, such as ros://192.168.1.20:9090#turtle/turtle (default: one that is simulated)"],
    )
    private var port: String? = null

    override fun call(): Int = port?.let(::run) ?: TurtleBridge().use { run("${it.port}#turtle/turtle") }

    private fun run(port: String): Int {
        val project = SampleProject("turtle").apply { believe("turtle", createLiteral("board", createString(port))) }
        return MasRun(project).toItsEnd()
    }
}
