package argo.fleet

import argo.fleet.cluster.JGroupsCluster
import argo.fleet.node.Fleet
import argo.tools.command.ToolCommand
import argo.tools.command.ToolException
import argo.tools.command.requireFile
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.io.IOException
import java.nio.file.Path
import java.util.logging.Logger

@Command(
    name = "fleet",
    description = ["Runs the agents of one computer of a fleet: those that the project has \"at\" its name."],
    sortOptions = false,
)
internal class FleetCommand : ToolCommand() {
    @Parameters(paramLabel = "PROJECT.mas2j", description = ["the project, the same on all computers"])
    private lateinit var project: Path

    @Option(names = ["--at"], paramLabel = "NAME", required = true, description = ["this computer's name in the project"])
    private lateinit var here: String

    @Option(
        names = ["--bind"], paramLabel = "ADDRESS",
        description = ["the address at which this computer listens, if the project has no hosts; 127.0.0.1 unless given"],
    )
    private var bind: String? = null

    @Option(names = [CLASS_PATH], paramLabel = "PATH", description = ["the project's classes and jars, and Jason's, as for java -cp"])
    @Suppress("unused") // for the help; `main` reads this option before it loads Jason
    private var classPath: String? = null

    override fun call(): Int {
        requireFile(project)
        val mas = FleetMas()
        try {
            val described = mas.read("$project")
            val settings = described.settings(here, bind)
            val fleet = Fleet(
                JGroupsCluster.open(settings), described.planned, described.hosts, Logger.getLogger(FleetMas.LOG), described.views,
            )
            Runtime.getRuntime().addShutdownHook(Thread(fleet::close, "argo-fleet-leaving"))
            mas.run(fleet, described.agents, described.hosts.size)
        } catch (refused: FleetProjectException) {
            throw ToolException("$project: ${refused.message}")
        } catch (broken: IOException) {
            throw ToolException("$here cannot join the fleet: ${broken.message}")
        }
        Thread.currentThread().join() // the end of the agents' system ends the program
        return 0
    }

    companion object {
        const val CLASS_PATH = "--class-path"
    }
}
