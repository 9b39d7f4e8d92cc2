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
        "Two robots and a coordinator on three computers, which are processes here. The process of a robot is killed, and the other one",
        "gets what it had to do; then the coordinator's, which goes on on another computer. The boards are simulated, and everything",
        "listens on 127.0.0.1 only.",
    ],
    sortOptions = false,
)
internal class FleetCommand : ToolCommand() {
    @Option(
        names = ["--seconds"], paramLabel = "n", defaultValue = "6",
        description = ["how long the robots run between two events (default: \${DEFAULT-VALUE})"],
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
            listOf("scout2", "base").forEach { computer ->
                pause()
                fleet.kill(computer)
                println("the process of $computer has been killed")
                pause()
                fleet.start(computer)
                println("the process of $computer has been started again")
            }
            pause()
        }
        return 0
    }

    private fun pause() = TimeUnit.SECONDS.sleep(seconds.toLong())

    private companion object {
        const val SCOUTS = 2
        const val START_LIMIT_S = 60L
    }
}
