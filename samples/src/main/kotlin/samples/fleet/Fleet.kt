package samples.fleet

import java.io.IOException
import java.net.InetAddress
import java.net.ServerSocket
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.io.path.createTempDirectory
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * The computers of the sample `fleet`, one process each: `base` with the coordinator, and two scouts.
 *
 * @property ports the ports of the computers, by computer name
 */
internal class Fleet private constructor(
    private val project: Path,
    val ports: Map<String, Int>,
    private val java: String,
    private val classPath: String,
    private val printed: (String) -> Unit,
) : AutoCloseable {
    private val computers = ports.keys.associateWithTo(LinkedHashMap(), ::Computer)

    /** Kills the process of [computer] at once, like a power failure. */
    fun kill(computer: String) = computers.getValue(computer).kill()

    fun start(computer: String) {
        computers[computer] = Computer(computer)
    }

    fun isAlive(computer: String) = computers.getValue(computer).process.isAlive

    override fun close() {
        computers.values.forEach { it.close() }
        project.parent.toFile().deleteRecursively()
    }

    /** The computer that the `.mas2j` names [name] behind `at`. Each computer is a process in the directory of the project. */
    private inner class Computer(name: String) {
        val process: Process = ProcessBuilder(
            java, "-XX:TieredStopAtLevel=1", "-cp", classPath, "argo.fleet.MainKt", "${project.fileName}", "--at", name,
        ).directory(project.parent.toFile()).redirectErrorStream(true).start()

        private val reader = thread(isDaemon = true, name = "computer $name") {
            try {
                process.inputStream.bufferedReader().forEachLine(printed)
            } catch (_: IOException) {
                // the unread output of a destroyed process is lost
            }
        }

        fun kill() {
            process.destroyForcibly().waitFor()
            reader.join()
        }

        /** Asks the process to end. Kills it if it does not end in time. */
        fun close() {
            process.destroy()
            if (!process.waitFor(PATIENCE_S, TimeUnit.SECONDS)) process.destroyForcibly().waitFor()
            reader.join()
        }
    }

    companion object {
        private const val PATIENCE_S = 5L

        /** The ports are below those of outgoing connections, which the operating system could use first. */
        private val PORTS = 20_000..31_999
        private val FILES = listOf("fleet.mas2j", "coordinator.asl", "scout.asl")
        private val ADDRESS = Regex("""(\w+)\("127\.0\.0\.1:\d+"\)""")

        /**
         * Starts the computers. The computers run a copy of the project with free ports.
         *
         * @param java the path of `java`; the default is the Java of this program
         * @param classPath the class path; the default is that of this program
         * @param printed called with each printed line of the computers, on several threads
         */
        fun start(
            java: String = Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            classPath: String = System.getProperty("java.class.path"),
            printed: (String) -> Unit,
        ): Fleet {
            val directory = createTempDirectory("fleet")
            FILES.forEach { directory.resolve(it).writeText(source(it)) }
            val project = directory.resolve(FILES.first())
            val names = ADDRESS.findAll(project.readText()).map { it.groupValues[1] }.toList()
            val ports = names.zip(freePorts(names.size)).toMap()
            project.writeText(ADDRESS.replace(project.readText()) { "${it.groupValues[1]}(\"127.0.0.1:${ports[it.groupValues[1]]}\")" })
            return Fleet(project, ports, java, classPath, printed)
        }

        private fun source(file: String): String =
            checkNotNull(Fleet::class.java.getResource("/fleet/$file")) { "fleet/$file is not on the class path" }.readText()

        private fun freePorts(count: Int): List<Int> = PORTS.shuffled().asSequence().filter(::isFree).take(count).toList()

        private fun isFree(port: Int) = runCatching { ServerSocket(port, 1, InetAddress.getLoopbackAddress()).close() }.isSuccess
    }
}
