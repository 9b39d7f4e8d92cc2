package samples.fleet

import java.net.InetAddress
import java.net.ServerSocket
import java.net.URL
import java.nio.file.Path
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/** The containers of the sample `fleet`, each a process on this computer: `main` with the coordinator, and two scouts. */
internal class Fleet private constructor(private val containers: List<Container>) : AutoCloseable {
    val ports: List<Int> = containers.map { it.port }

    /** Ends the process of [container] like a power failure. */
    fun kill(container: String) = containers.first { it.name == container }.kill()

    fun isAlive(container: String) = containers.first { it.name == container }.isAlive

    override fun close() = containers.asReversed().forEach(Container::close)

    companion object {
        private val SCOUTS = listOf("scout1", "scout2")
        private const val START_LIMIT_S = 60L

        /**
         * Starts the containers, the coordinator first.
         * @param printed receives each line that they print, on several threads
         * @throws IllegalStateException if the coordinator does not start
         */
        fun start(printed: (String) -> Unit): Fleet {
            val ports = freePorts(SCOUTS.size + 1)
            val started = CountDownLatch(1)
            val main = Container.start(project(), "main", ports[0], ports[0]) {
                if ("starting coordinator" in it) started.countDown()
                printed(it)
            }
            if (!started.await(START_LIMIT_S, TimeUnit.SECONDS)) {
                main.close()
                error("the main container has not started its agent within $START_LIMIT_S s")
            }
            return Fleet(listOf(main) + SCOUTS.mapIndexed { i, name -> Container.start(project(), name, ports[i + 1], ports[0], printed) })
        }

        private fun project(): Path {
            val source: URL = checkNotNull(Fleet::class.java.getResource("/fleet/fleet.mas2j")) {
                "fleet/fleet.mas2j is not on the class path"
            }
            check(source.protocol == "file") { "JADE reads agents from files only, and the project is in an archive: $source" }
            return Path.of(source.toURI())
        }

        private fun freePorts(count: Int): List<Int> {
            val sockets = List(count) { ServerSocket(0, 1, InetAddress.getByName(Container.HOST)) }
            return sockets.map { it.localPort }.also { sockets.forEach(ServerSocket::close) }
        }
    }
}
