package samples.fleet

import java.net.InetAddress
import java.net.ServerSocket
import java.nio.file.Path
import kotlin.io.path.createTempDirectory
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * The computers of the sample `fleet`, each a process: `base` with the coordinator, and two scouts.
 *
 * @property ports the ports at which the computers listen, by the computers' names
 */
internal class Fleet private constructor(
    private val project: Path,
    val ports: Map<String, Int>,
    private val java: String,
    private val classPath: String,
    private val printed: (String) -> Unit,
) : AutoCloseable {
    private val computers = ports.keys.associateWithTo(LinkedHashMap(), ::started)

    /** Ends the process of [computer] as a power failure does. */
    fun kill(computer: String) = computers.getValue(computer).kill()

    /** Starts the process of [computer] again. */
    fun start(computer: String) {
        computers[computer] = started(computer)
    }

    private fun started(computer: String) = FleetComputer.start(project, computer, java, classPath, printed)

    fun isAlive(computer: String) = computers.getValue(computer).isAlive

    override fun close() {
        computers.values.forEach(FleetComputer::close)
        project.parent.toFile().deleteRecursively()
    }

    companion object {
        private val FILES = listOf("fleet.mas2j", "coordinator.asl", "scout.asl")
        private val ADDRESS = Regex("""(\w+)\("127\.0\.0\.1:\d+"\)""")

        /**
         * Starts the computers from a copy of the project that gives them free ports.
         *
         * @param java the path of Java's program; that of this program by default
         * @param classPath the places of classes; those of this program by default
         * @param printed called with each line that the computers print, on several threads
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

        private fun freePorts(count: Int): List<Int> {
            val sockets = List(count) { ServerSocket(0, 1, InetAddress.getLoopbackAddress()) }
            return sockets.map { it.localPort }.also { sockets.forEach(ServerSocket::close) }
        }
    }
}
