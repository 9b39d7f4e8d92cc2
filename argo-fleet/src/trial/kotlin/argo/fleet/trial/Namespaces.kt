package argo.fleet.trial

import java.io.File
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger

/**
 * Simulates computers of a network. Each has a network namespace with one interface, and all are connected to one switch. [close] removes
 * the namespaces. Namespaces need Linux and root.
 *
 * @throws IllegalStateException if namespaces cannot be made; see [missing]
 */
class Namespaces(private val names: List<String>) : AutoCloseable {
    /** A unique name, since several tests may run at a time. Names of interfaces have at most 15 characters. */
    private val switch = "af${ProcessHandle.current().pid().toString(36)}x${made.getAndIncrement().toString(36)}"
    private val addresses = names.withIndex().associate { (index, name) -> name to "$NETWORK.${index + 1}" }

    init {
        removeAll()
        ip("link add $switch type bridge")
        ip("link set $switch up")
        names.forEach(::make)
    }

    private fun make(name: String) {
        val cable = cable(name)
        ip("netns add $cable")
        ip("link add $cable type veth peer name eth0 netns $cable")
        ip("link set $cable master $switch up")
        ip("-n $cable addr add ${address(name)}/24 dev eth0")
        ip("-n $cable link set eth0 up")
        ip("-n $cable link set lo up")
    }

    private fun cable(name: String) = "${switch}x${names.indexOf(name) + 1}"

    /** The address of a computer. */
    fun address(name: String): String = addresses.getValue(name)

    /** Returns the words in front of a command that run it on the computer. */
    fun prefix(name: String): List<String> = listOf("ip", "netns", "exec", cable(name))

    fun unplug(name: String) = ip("link set ${cable(name)} down")

    fun plug(name: String) = ip("link set ${cable(name)} up")

    /** The number of bytes that a computer has sent, with all headers. */
    fun bytesSent(name: String): Long = File("/sys/class/net/${cable(name)}/statistics/rx_bytes").readText().trim().toLong()

    override fun close() = removeAll()

    private fun removeAll() {
        names.forEach { run("netns del ${cable(it)}") }
        run("link del $switch")
    }

    companion object {
        private val made = AtomicInteger()
        private const val NETWORK = "10.231.7"

        /** The reason why this computer cannot make namespaces, or null if it can. */
        val missing: String? by lazy {
            runCatching { Namespaces(listOf("test")).close() }.exceptionOrNull()
                ?.let { "network namespaces cannot be made here: ${it.message}" }
        }

        private fun ip(arguments: String) = run(arguments).let { check(it.isEmpty()) { "ip $arguments: $it" } }

        /** @return the error output of the command */
        private fun run(arguments: String): String {
            val process = ProcessBuilder(listOf("ip") + arguments.split(' ')).redirectErrorStream(true).start()
            val said = String(process.inputStream.readAllBytes())
            check(process.waitFor(60, TimeUnit.SECONDS)) { "ip $arguments does not end" }
            return if (process.exitValue() == 0) "" else said.ifBlank { "exit ${process.exitValue()}" }
        }
    }
}
