package argo.fleet.trial

import java.io.File
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.createTempDirectory

/**
 * Runs computers of a fleet. Each is a process that sends messages to all others. Starts, kills, unplugs and plugs in computers, and checks
 * their notes.
 *
 * @param names the computers
 * @param network the network of the computers, or null if all listen on the loopback interface and none can be unplugged
 * @param certificates returns the `tls://` folder of a computer, or null for unencrypted connections
 */
class Trial(
    private val names: List<String>, private val network: Namespaces?, private val certificates: ((String) -> Path)? = null,
) : AutoCloseable {
    private inner class Node(val name: String, val session: String) {
        val notes = folder.resolve("$session.notes")
        val process: Process = ProcessBuilder(network?.prefix(name).orEmpty() + java() + listOf(session, "$notes") + places())
            .redirectErrorStream(true).redirectOutput(folder.resolve("$session.out").toFile()).start()

        private fun places() = listOf(certificates?.invoke(name)?.toString() ?: "-") + names.map { "$it=${address(it)}" }

        fun tell(command: String) = process.outputStream.run {
            write("$command\n".toByteArray())
            flush()
        }

        private val reader by lazy { notes.toFile().bufferedReader() }
        private val read = mutableListOf<Event>()
        private var part = ""

        /** The notes of the process up to now. The last line of a killed process may be incomplete. */
        fun events(): List<Event> {
            if (!notes.toFile().exists()) return read
            val text = part + reader.readText()
            part = text.substringAfterLast('\n')
            text.removeSuffix(part).lineSequence().filter(String::isNotEmpty).mapTo(read, Event::of)
            return read
        }

        /** The views, each with its time. */
        fun views(): List<Pair<Long, Set<String>>> =
            events().filter { it.kind == Kind.VIEWED }.map { it.nanos to it.about[0].split(',').toSet() }

        /** True if the process sends no more messages, and all its messages have an end. */
        fun isFinished() = events().lastOrNull { it.kind != Kind.VIEWED && it.kind != Kind.TOOK }?.kind == Kind.FINISHED
    }

    private val folder = createTempDirectory("argo-fleet-trial")
    private val ports = freePorts(names.size)
    private val nodes = LinkedHashMap<String, Node>()
    private val gone = mutableListOf<Node>()
    private val crashes = mutableListOf<Event>()
    private var isSending = false

    private fun java() = listOf(
        File(System.getProperty("java.home"), "bin/java").path, "-Xmx256m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1",
        "-cp", System.getProperty("java.class.path"), "argo.fleet.trial.TrialNodeKt",
    )

    private fun address(name: String) = network?.let { "${it.address(name)}:$PORT" } ?: "127.0.0.1:${ports[names.indexOf(name)]}"

    /** The names of the computers whose processes run. */
    val running: Set<String> get() = nodes.keys

    /** Starts the process of a computer. */
    fun start(name: String) {
        val node = Node(name, "$name#${gone.count { it.name == name } + 1}")
        nodes[name] = node
        if (isSending) node.tell("send")
    }

    /** Makes all computers send from now on, including those that start later. */
    fun send() {
        isSending = true
        nodes.values.forEach { it.tell("send") }
    }

    /** Kills a process by SIGKILL. */
    fun kill(name: String) {
        val node = nodes.remove(name) ?: return
        node.process.destroyForcibly().waitFor()
        gone += node
        crashes += Event(System.nanoTime(), node.session, Kind.CRASHED)
    }

    /** Waits until all computers see exactly the running ones. */
    fun awaitAll() = await(VIEW_S, "a view of $running by all") { nodes.values.all { it.views().lastOrNull()?.second == running } }

    /**
     * Waits until all other computers see that [name] has gone.
     *
     * @param since the time of the loss by the steady clock
     * @return the times in ms until the first computer saw it and until the last one did
     */
    fun noticed(name: String, since: Long): LongRange {
        val others = nodes.values.filter { it.name != name }
        fun first(node: Node) = node.views().firstOrNull { (at, computers) -> at >= since && name !in computers }?.first
        await(VIEW_S, "that all miss $name") { others.all { first(it) != null } }
        return others.map { (first(it)!! - since) / NANOS_PER_MILLI }.let { it.min()..it.max() }
    }

    /** Returns the number of messages that were sent until now. */
    fun sent(): Int = (gone + nodes.values).sumOf { node -> node.events().count { it.kind == Kind.SENT } }

    /** Stops the sending, and waits until all messages have an end. */
    fun finish() {
        isSending = false
        nodes.values.forEach { it.tell("finish") }
        await(END_S, "the ends of all messages") { nodes.values.all { it.isFinished() } }
    }

    /** Returns the history from the notes of all processes. */
    fun history() = History((gone + nodes.values).flatMap(Node::events) + crashes)

    private fun await(seconds: Long, what: String, condition: () -> Boolean) {
        val end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds)
        while (!condition()) {
            check(System.nanoTime() < end) {
                "in vain: $what; " + nodes.values.joinToString { "${it.session} sees ${it.views().lastOrNull()?.second}" }
            }
            Thread.sleep(PAUSE_MILLIS)
        }
    }

    /** Ends all processes and removes their notes. */
    override fun close() {
        nodes.keys.toList().forEach(::kill)
        folder.toFile().deleteRecursively()
    }

    private companion object {
        const val PORT = 4711
        const val PAUSE_MILLIS = 100L
        const val VIEW_S = 60L
        const val END_S = 120L
        const val NANOS_PER_MILLI = 1_000_000L
    }
}
