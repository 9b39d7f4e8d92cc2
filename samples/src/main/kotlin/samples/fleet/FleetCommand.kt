package samples.fleet

import argo.tools.command.ToolCommand
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

@Command(
    name = "fleet",
    description = [
        "Two robots and a coordinator, each in a process of its own, on Jason's JADE infrastructure. One robot's process is killed, and",
        "the other one gets what it had to do. The boards are simulated, and everything listens on 127.0.0.1 only.",
    ],
    sortOptions = false,
)
internal class FleetCommand : ToolCommand() {
    @Option(
        names = ["--seconds"], paramLabel = "n", defaultValue = "8",
        description = ["how long the robots run before the process is killed, and after it (default: \${DEFAULT-VALUE})"],
    )
    private var seconds = 0

    override fun call(): Int {
        if (seconds < 1) misuse("--seconds is at least 1, not $seconds")
        val ready = CountDownLatch(SCOUTS)
        val fleet = Fleet.start {
            println(it)
            if (it.endsWith(" is there")) ready.countDown()
        }
        Runtime.getRuntime().addShutdownHook(thread(start = false) { fleet.close() })
        fleet.use {
            if (!ready.await(START_LIMIT_S, TimeUnit.SECONDS)) {
                System.err.println("the scouts have not started within $START_LIMIT_S s")
                return 1
            }
            TimeUnit.SECONDS.sleep(seconds.toLong())
            fleet.kill("scout2")
            println("the process of scout2 has been killed")
            TimeUnit.SECONDS.sleep(seconds.toLong())
        }
        return 0
    }

    private companion object {
        const val SCOUTS = 2
        const val START_LIMIT_S = 60L
    }
}
