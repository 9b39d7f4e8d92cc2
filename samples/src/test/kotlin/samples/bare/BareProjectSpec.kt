package samples.bare

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.string.shouldContain
import jason.asSemantics.Agent
import javino.sim.PseudoTerminals
import java.io.File
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText

/**
 * Runs a Jason project that adds only `argo.jar`, in its own process, with a board on a pseudo-terminal. The agent is that of the EMAS 2016
 * paper, with another port.
 */
@Tags("Thorough")
class BareProjectSpec : FunSpec({
    val pairs: EnabledOrReasonIf = {
        if (PseudoTerminals.available()) Enabled.enabled else Enabled.disabled(
            "there is no socat for a pseudo-terminal: install it with your package manager",
        )
    }
    val recentJava: EnabledOrReasonIf = { test ->
        if (newestJava().feature >= 21) pairs(test) else Enabled.disabled(
            "Jason 3.3.0 needs Java 21 or newer, the newest here is ${newestJava().feature}",
        )
    }

    test("the published agent stops its robot with Jason 3.2.1 and argo.jar").config(enabledOrReasonIf = pairs) {
        stopsTheRobot(thisJava(), jarOf(Agent::class.java))
    }

    test("the same jar does it with Jason 3.3.0 on Java 21 or newer").config(enabledOrReasonIf = recentJava) {
        stopsTheRobot(newestJava(), Path.of(System.getProperty("newest.jason.jar")))
    }

    test("a drive that was recorded with Jason 3.3.0 is replayed with it").config(enabledOrReasonIf = recentJava) {
        val jason = Path.of(System.getProperty("newest.jason.jar"))
        stopsTheRobot(newestJava(), jason, "[argo_record=\"drive.mcap\"] ") { project ->
            val replay = ProcessBuilder(newestJava().program, "-cp", classPath(jason), "argo.tools.MainKt", "replay", "drive.mcap")
                .directory(project.toFile()).redirectErrorStream(true).start()
            replay.inputReader().readText() shouldContain "identical: the same events"
        }
    }
})

private fun stopsTheRobot(
    java: InstalledJava, jason: Path, options: String = "", examine: (project: Path) -> Unit = {},
) = PseudoTerminals.open().use { line ->
    val project = project(line.computer(), options)
    val log = project.resolve("log").toFile()
    WallBoard(line.board()).use { board ->
        val command = arrayOf("-XX:TieredStopAtLevel=1", "-cp", classPath(jason), "jason.infra.local.RunLocalMAS", "bare.mas2j", "--no-net")
        val process = ProcessBuilder(java.program, *command)
            .directory(project.toFile()).redirectErrorStream(true).redirectOutput(log).start()
        try {
            val stoppedAt = io.kotest.assertions.withClue({ log.readText() }) { board.stoppedAt.get(60, TimeUnit.SECONDS) }
            stoppedAt shouldBeInRange 1..40 // each answer during a halt of the agent by a busy machine costs a centimetre
            board.commands.toList() shouldContain "front"
        } finally {
            process.destroy()
            process.waitFor(10, TimeUnit.SECONDS)
        }
    }
    io.kotest.assertions.withClue({ log.readText() }) { examine(project) }
    project.toFile().deleteRecursively()
}

private fun classPath(jason: Path): String {
    val own = listOf(Class.forName("javax.json.Json"), Class.forName("org.glassfish.json.JsonProviderImpl")).map(::jarOf)
    return listOf(jason, *own.toTypedArray(), Path.of(System.getProperty("argo.jar"))).joinToString(File.pathSeparator)
}

internal fun jarOf(type: Class<*>): Path = Path.of(type.protectionDomain.codeSource.location.toURI())

private fun project(port: File, options: String): Path {
    val project = createTempDirectory("bare-project")
    fun file(name: String, text: String) = project.resolve(name).writeText(text)
    file("bare.mas2j", "MAS bare {\n    agents: robot ${options}agentArchClass argo.Arch;\n}\n")
    file("robot.asl", publishedAgent(port))
    file(
        "byValue.xml",
        "<PerceptionFilter><filter><predicate>dist</predicate><parameter operator=\"EQ\" " +
            "id=\"0\">b</parameter></filter></PerceptionFilter>\n",
    )
    file("logging.properties", "handlers = java.util.logging.ConsoleHandler\n.level = INFO\n") // by default, Jason opens a window
    return project
}

private fun publishedAgent(port: File) = """
value(40).
!config.

+!config: true <-
    .port("$port");
    .limit(20);
    .filter(byValue);
    .percepts(open);
    !start.

+!start : true <-
    .act(front);
    +status(front);
    !moving.

+!moving: dist(f, X) & value(J) & X>J & status(front) <-
    .act(front);
    !moving.

+!moving: dist(f, X) & value(J) & X<=J & status(front) <-
    .act(stop).

-!moving <-
    !!moving.

+light(X,Y) : Y>100 <- .act(ledLightOn).
+light(X,Y) : Y<=100 <- .act(ledLightOn).
+temp(X,Y) : Y>25 <- .act(ledTempOff).
+temp(X,Y) : Y<=25 <- .act(ledTempOn).
"""
