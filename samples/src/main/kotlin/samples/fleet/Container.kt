package samples.fleet

import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/**
 * A JADE container with Jason's agents, in another process: `jason.infra.jade.RunJadeMAS` in the directory of the project.
 *
 * @property name the container's name in the `.mas2j`, behind `at`
 * @param printed receives each line that it prints, on its own thread
 */
internal class Container private constructor(
    val name: String, val port: Int, private val process: Process, printed: (String) -> Unit,
) : AutoCloseable {
    private val reader = thread(isDaemon = true, name = "container $name") {
        try {
            process.inputStream.bufferedReader().forEachLine(printed)
        } catch (_: IOException) {
            // a destroyed process loses its unread output
        }
    }

    val isAlive: Boolean get() = process.isAlive

    /** Ends the container's process at once, like a power failure. */
    fun kill() {
        process.destroyForcibly().waitFor()
        reader.join()
    }

    /** Asks the container's process to end. Kills it if it does not end in time. */
    override fun close() {
        process.destroy()
        if (!process.waitFor(PATIENCE_S, TimeUnit.SECONDS)) process.destroyForcibly().waitFor()
        reader.join()
    }

    companion object {
        private const val PATIENCE_S = 5L

        /**
         * Starts a container of [project], a `.mas2j` file. The container listens only on [HOST]. [mainPort] is the port of the main
         * container, even if this is the main container.
         */
        fun start(project: Path, name: String, port: Int, mainPort: Int, printed: (String) -> Unit): Container {
            val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
            val command = listOf(java, "-cp", System.getProperty("java.class.path")) +
                program("${project.fileName}", name, Address(HOST, port), Address(HOST, mainPort))
            val process = ProcessBuilder(command).directory(project.parent.toFile()).redirectErrorStream(true).start()
            return Container(name, port, process, printed)
        }

        /**
         * Returns the arguments of Java for the container [name] of [project] that listens at [own]. The main container listens at [main].
         */
        fun program(project: String, name: String, own: Address, main: Address): List<String> {
            val role = if (own == main) emptyList() else listOf("-container")
            return listOf("jason.infra.jade.RunJadeMAS", project) + role +
                listOf(
                    "-container-name", name, "-host", main.host, "-port", "${main.port}", "-local-host", own.host, "-local-port",
                    "${own.port}", "-nomtp",
                ) +
                listOf("-jade_imtp_leap_JICP_JICPServer_acceptlocalhostonly", "true", "--no-net", "true")
        }

        const val HOST = "127.0.0.1"
    }

    data class Address(val host: String, val port: Int)
}
