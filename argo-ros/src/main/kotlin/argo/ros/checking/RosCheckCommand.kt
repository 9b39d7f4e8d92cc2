package argo.ros.checking

import argo.filters.matching.perceptsOf
import argo.links.Wish
import argo.ros.RobotPort
import argo.ros.RosLink
import argo.ros.mapping.Mapping
import argo.ros.mapping.MappingException
import argo.ros.mapping.mappingIn
import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.ToolProvider
import argo.tools.command.counted
import argo.tools.command.refuseWithout
import argo.tools.command.requireWithin
import javino.LineClock
import javino.PortException
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import java.util.logging.Level

@Command(
    name = "ros",
    description = ["Commands for robots that speak ROS."],
    subcommands = [RosCheckCommand::class],
)
internal class RosCommand : ToolCommand() {
    override fun call(): Int = spec.refuseWithout("command")
}

class RosToolProvider : ToolProvider {
    override fun command(): Any = RosCommand()
}

/** `ros check`: checks a mapping, with or without a robot. */
@Command(
    name = "check",
    description = [
        "Checks the mapping of a robot, FILE.ros.yaml: by itself and, if ADDRESS is given, against the robot behind the bridge there.",
        "Tells types, fields, values, topics, services and actions that do not fit, and shows the percepts that the robot's messages make.",
        "Sends no commands.",
    ],
)
internal class RosCheckCommand : ToolCommand() {
    @Parameters(index = "0", paramLabel = "FILE", description = ["a mapping, as robot.ros.yaml"])
    private lateinit var file: Path

    @Parameters(
        index = "1", paramLabel = "ADDRESS", arity = "0..1",
        description = ["the bridge, as ros://robot:9090 or wss://robot/path, or a bag, replay:FILE.mcap"],
    )
    private var address: String? = null

    @Option(
        names = ["--seconds"], paramLabel = "S", defaultValue = "3",
        description = ["how long the robot is listened to (\${DEFAULT-VALUE})"],
    )
    private var seconds = 0

    private val found = ArrayList<String>()

    override fun call(): Int {
        spec.requireWithin("--seconds", seconds, 1..MAX_S, "s")
        val mapping = try {
            mappingIn(file)
        } catch (refused: MappingException) {
            refused.problems.forEach { err.println("$it") }
            return ExitStatus.FAILED
        }
        out.println("$file: ${counted(mapping.percepts.size, "percept")}, ${counted(mapping.commands.size, "command")}")
        address?.let { check(mapping, it) } ?: synchronized(found) { found += mapping.doubts }
        synchronized(found) { found.forEach { err.println(it) } }
        return if (found.isEmpty()) ExitStatus.DONE else ExitStatus.FAILED
    }

    private fun check(mapping: Mapping, address: String) {
        try {
            val clock = LineClock.system()
            val robot = RobotPort.of(if (SCHEME.containsMatchIn(address)) address else "ros://$address")
            val link = RosLink.over(address, mapping, true, clock, ::report) { robot.connect(it, clock) }
            link.use { listen(it, mapping) }
        } catch (refused: MappingException) {
            found += refused.message.orEmpty()
        } catch (trouble: PortException) {
            found += trouble.message.orEmpty()
        }
    }

    private fun report(level: Level, line: String) {
        if (level.intValue() < Level.WARNING.intValue()) return out.println(line)
        synchronized(found) { found += line }
    }

    private fun listen(link: RosLink, mapping: Mapping) {
        link.wants(Wish(mapping.percepts.isNotEmpty(), INTERVAL_MS, null))
        val seen = LinkedHashMap<String, Int>()
        listenFor(link, TimeUnit.SECONDS.toNanos(seconds.toLong())) { text -> perceptsOf(text).forEach { seen.merge(it, 1, Int::plus) } }
        link.explainSilence()
        listenFor(link, ANSWERING_NANOS) { }
        seen.keys.take(MAX_SHOWN).forEach { out.println("  $it") }
        if (seen.size > MAX_SHOWN) out.println("  and ${seen.size - MAX_SHOWN} other percepts")
        if (seen.isEmpty() && mapping.percepts.isNotEmpty()) out.println("  no percepts in $seconds s")
    }

    private fun listenFor(link: RosLink, nanos: Long, take: (String) -> Unit) {
        val end = System.nanoTime() + nanos
        while (end - System.nanoTime() > 0) link.listen(LISTENING_MS)?.let { take(it.text) }
    }

    private companion object {
        val SCHEME = Regex("^(ros|wss|replay):")
        const val MAX_S = 3_600
        const val MAX_SHOWN = 30
        const val INTERVAL_MS = 100
        const val LISTENING_MS = 1_000
        val ANSWERING_NANOS = TimeUnit.SECONDS.toNanos(1)
    }
}
