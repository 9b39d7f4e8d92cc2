package argo.fleet.cluster

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import org.jgroups.util.Util
import java.net.InetSocketAddress
import java.net.ServerSocket

/** Computers on the loopback interface, each with sockets of its own. */
private class JGroupsWorld : ClusterWorld {
    private val hosts = listOf("a", "b", "c").associateWith { loopback() }
    private val running = mutableListOf<Triple<String, JGroupsGroup, Cluster>>()

    private fun loopback() = ServerSocket(0).use { InetSocketAddress("127.0.0.1", it.localPort) }

    override fun start(name: String): Cluster {
        val isFree = running.none { it.first == name }
        val group = JGroupsGroup(ClusterSettings("garden", name, hosts, if (isFree) hosts.getValue(name) else loopback()))
        return GroupCluster(group, hosts.keys, ThreadLoop(name)).also { running += Triple(name, group, it) }
    }

    override fun crash(name: String) {
        running.filter { it.first == name }.forEach { Util.shutdown(it.second.channel, false) }
        running.removeIf { it.first == name }
    }

    override fun await(what: String, condition: () -> Boolean) {
        val end = System.nanoTime() + 30_000_000_000L
        while (!condition()) {
            check(System.nanoTime() < end) { "in vain: $what" }
            Thread.sleep(10)
        }
    }

    override fun close() = running.forEach { it.third.close() }
}

/** The cluster over JGroups, in real time. */
@Tags("Thorough")
class JGroupsClusterSpec : FunSpec({
    clusterContract(::JGroupsWorld)(this)
})
