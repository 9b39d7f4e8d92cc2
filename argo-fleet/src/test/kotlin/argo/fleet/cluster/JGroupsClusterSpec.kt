package argo.fleet.cluster

import argo.fleet.trial.freePorts
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import org.jgroups.BytesMessage
import org.jgroups.JChannel
import org.jgroups.Message
import org.jgroups.ObjectMessage
import org.jgroups.protocols.Discovery
import org.jgroups.protocols.TCP
import org.jgroups.util.Util
import java.io.Serializable
import java.net.InetSocketAddress
import java.util.concurrent.CopyOnWriteArrayList
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger

/** Computers on the loopback interface, each with its own sockets. Without [areNamed], they must find each other. */
private class JGroupsWorld(private val areNamed: Boolean = true) : ClusterWorld {
    private val addresses = listOf("a", "b", "c").zip(freePorts(3).map(::loopback)).toMap()
    private val running = mutableListOf<Triple<String, JGroupsGroup, Cluster>>()

    private fun loopback(port: Int) = InetSocketAddress("127.0.0.1", port)

    override fun start(name: String): Cluster {
        val bind = if (running.none { it.first == name }) addresses.getValue(name) else loopback(freePorts(1).single())
        val group = JGroupsGroup(settings(name, bind))
        return GroupCluster(group, addresses.keys, ThreadLoop(name)).also { running += Triple(name, group, it) }
    }

    private fun settings(name: String, bind: InetSocketAddress) =
        ClusterSettings("garden", name, if (areNamed) addresses else emptyMap(), bind)

    /** Returns a channel that looks for others as the computer [name] does before it joins. */
    fun looking(name: String): JChannel {
        val settings = settings(name, addresses.getValue(name))
        return JChannel(stackOf(settings, FleetSockets(Entrance(Greeting.of(settings), null, settings.hosts))).take(2)).connect("garden")
    }

    fun channel(name: String) = running.first { it.first == name }.second.channel

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

/** Notices if Java deserializes it. */
private class Trap : Serializable {
    @Suppress("unused") // called by Java's serialization
    private fun readResolve(): Any {
        isSprung = true
        return this
    }

    companion object {
        private const val serialVersionUID = 1L

        @Volatile
        var isSprung = false
    }
}

@Tags("Thorough")
class JGroupsClusterSpec : FunSpec({
    blockingTest = true
    clusterContract { JGroupsWorld() }(this)

    test("computers whose addresses nobody named find each other on their network") {
        JGroupsWorld(areNamed = false).use { world ->
            val logs = listOf("a", "b").map { name -> Log().also { world.start(name).listen(it) } }
            world.await("a view of both") { logs.all { it.computers == setOf("a", "b") } }
        }
    }

    test("a computer that joins does not cut off another one that is about to") {
        JGroupsWorld().use { world ->
            val log = Log()
            world.start("a").listen(log)
            world.looking("c").use { newcomer ->
                newcomer.protocolStack.findProtocol<Discovery>(Discovery::class.java).findMembers(null, true, true, 0)
                val transport = world.channel("a").protocolStack.transport as TCP
                world.await("the connection") { transport.openConnections == 1 }
                world.start("b").listen(Log())
                world.await("a view of both") { log.computers == setOf("a", "b") }
                transport.openConnections shouldBe 2
            }
        }
    }

    test("a message under another computer's name is left out, and told") {
        val told = CopyOnWriteArrayList<String>()
        val handler = object : Handler() {
            override fun publish(record: LogRecord) {
                told += record.message
            }

            override fun flush() = Unit
            override fun close() = Unit
        }
        Logger.getLogger(Cluster::class.java.name).addHandler(handler)
        JGroupsWorld().use { world ->
            val log = Log()
            val (a, b, c) = listOf("a", "b", "c").map(world::start)
            a.listen(log)
            b.listen(Log())
            c.listen(Log())
            world.await("a view of all") { log.computers == setOf("a", "b", "c") }
            val forged = BytesMessage(world.channel("a").address, Frame.Piece(1, 1, true, "forged".toByteArray()).bytes())
            world.channel("b").send(forged.setSrc(world.channel("c").address).setFlag(Message.Flag.NO_RELIABILITY))
            world.await("the line") { told.any { it.startsWith("b sends messages under the name of c, which are left out") } }
            c.send("a", "own".toByteArray())
            world.await("the message after it") { log.from("c") == listOf("own") }
            told.none { it.startsWith("null") } shouldBe true // the first messages of a connection also have a known sender
        }
        Logger.getLogger(Cluster::class.java.name).removeHandler(handler)
    }

    test("a Java object that a member of the group sends is not read") {
        JGroupsWorld().use { world ->
            val log = Log()
            val (a, b) = listOf("a", "b").map(world::start)
            a.listen(log)
            b.listen(Log())
            world.await("a view of both") { log.computers == setOf("a", "b") }
            val channel = world.channel("b")
            channel.send(ObjectMessage(world.channel("a").address, Trap()).setFlag(Message.Flag.NO_RELIABILITY))
            b.send("a", "after it".toByteArray())
            world.await("the message after it") { log.from("b") == listOf("after it") }
            Trap.isSprung shouldBe false
        }
    }
})
