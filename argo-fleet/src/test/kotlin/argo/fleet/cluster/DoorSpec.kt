package argo.fleet.cluster

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jdk.net.ExtendedSocketOptions
import java.io.IOException
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.Socket
import java.net.SocketException
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/** A door of the computer `base`. The door stores its messages and the admitted computers. */
private class TestDoor(entrance: Entrance) : AutoCloseable {
    val told = LinkedBlockingQueue<String>()
    val admitted = LinkedBlockingQueue<Socket>()
    private val door = Door(entrance, Refusals(log = told::add)).apply { bind(InetSocketAddress(InetAddress.getLoopbackAddress(), 0)) }
    val address = InetSocketAddress(InetAddress.getLoopbackAddress(), door.localPort)

    init {
        thread(isDaemon = true) {
            try {
                while (true) admitted += door.accept()
            } catch (e: SocketException) {
                check(e.message == "closed")
            }
        }
    }

    fun toldNext(): String = told.poll(60, TimeUnit.SECONDS) ?: error("nothing was told")

    fun stranger(vararg bytes: Byte): ByteArray = Socket(address.address, address.port).use {
        it.getOutputStream().run {
            write(bytes)
            flush()
        }
        runCatching { it.getInputStream().readAllBytes() }.getOrDefault(ByteArray(0))
    }

    override fun close() = door.close()
}

class DoorSpec : FunSpec({
    blockingTest = true

    val hosts = listOf("base", "scout").associateWith { InetSocketAddress("127.0.0.1", 4000 + it.length) }
    fun settings(name: String, fleet: String = "garden", of: Map<String, InetSocketAddress> = hosts) =
        ClusterSettings(fleet, name, of, ClusterSettings.loopback(0))
    fun entrance(settings: ClusterSettings, certificates: FleetCertificates? = null) =
        Entrance(Greeting.of(settings), certificates, settings.hosts)
    val told = CopyOnWriteArrayList<String>()
    fun TestDoor.greet(entrance: Entrance): Socket = FleetSocket(entrance, Refusals(log = told::add)).apply { connect(address, 1000) }

    test("a computer of the fleet is let in, and bytes go both ways") {
        TestDoor(entrance(settings("base"))).use { door ->
            door.greet(entrance(settings("scout"))).use { socket ->
                val other = door.admitted.poll(60, TimeUnit.SECONDS)!!
                socket.getOutputStream().write(42)
                other.getInputStream().read() shouldBe 42
                other.getOutputStream().write(43)
                socket.getInputStream().read() shouldBe 43
                listOf(socket, other).forEach { it.getOption(ExtendedSocketOptions.TCP_KEEPIDLE) shouldBe 300 }
            }
        }
    }

    test("others are refused with one line at each end") {
        TestDoor(entrance(settings("base"))).use { door ->
            val three = hosts + ("tail" to InetSocketAddress("127.0.0.1", 4009))
            val moved = hosts + ("scout" to InetSocketAddress("127.0.0.1", 4009))
            val otherHosts = "the hosts of scout have other names or addresses than those of base: give both the same project"
            listOf(
                settings("scout", fleet = "field") to "scout belongs to the fleet field, and base to garden",
                settings("scout", of = three) to otherHosts,
                settings("scout", of = moved) to otherHosts,
            ).forEach { (other, reason) ->
                val there = "127.0.0.1:${door.address.port}, where a computer of the fleet should be,"
                shouldThrow<IOException> { door.greet(entrance(other)) }.message shouldBe "$there refuses the connection: $reason"
            }
            List(2) { door.toldNext() } shouldBe listOf("scout belongs to the fleet field, and base to garden", otherHosts)
                .map { "a stranger at 127.0.0.1 is refused: $it (told once in 10 minutes)" }
            door.told shouldHaveSize 0
        }
    }

    test("where no hosts are named, any computer of the fleet is let in") {
        TestDoor(entrance(settings("base", of = mapOf()))).use { door ->
            door.greet(entrance(settings("anybody", of = mapOf()))).close()
            door.admitted.poll(60, TimeUnit.SECONDS)!!.close()
        }
    }

    test("garbage, another version and JGroups without a greeting are refused, each once") {
        TestDoor(entrance(settings("base"))).use { door ->
            repeat(2) { String(door.stranger(*"GET / HTTP/1.1\r\n".toByteArray())) shouldContain "refused speaks no language of a fleet" }
            door.toldNext() shouldBe
                "a stranger at 127.0.0.1 speaks no language of a fleet: it sent \"GET / HTTP/1.1?\" (told once in 10 minutes)"
            door.stranger(*"argo-fleet 3 garden scout 0 and more\n".toByteArray())
            door.toldNext() shouldContain "speaks version 3 of the fleet's language, and this computer 2: use one argo-fleet.jar"
            String(door.stranger(*ByteArray(1000) { it.toByte() })) shouldContain "it sent \"??????????\"" // and the log has such a line
            door.told shouldHaveSize 0
        }
    }

    test("whoever says nothing is sent away, and does not keep others out") {
        TestDoor(entrance(settings("base"))).use { door ->
            Socket(door.address.address, door.address.port).use { silent ->
                door.greet(entrance(settings("scout"))).close()
                silent.getInputStream().readAllBytes()
            }
            door.toldNext() shouldContain "does not greet within 1500 ms"
        }
    }

    test("a crowd of strangers costs a few threads, and keeps no computer of the fleet out") {
        val elsewhere = hosts.mapValues { (name, _) -> InetSocketAddress(if (name == "scout") "127.0.0.2" else "127.0.0.3", 4711) }
        TestDoor(entrance(settings("base", of = elsewhere))).use { door ->
            val crowd = List(40) { Socket(door.address.address, door.address.port) }
            door.toldNext() shouldContain "connections of strangers come faster than they can be refused"
            Thread.getAllStackTraces().keys.count { it.name == "fleet-porter" } shouldBe 8
            val scout = FleetSocket(entrance(settings("scout", of = elsewhere)), Refusals(log = told::add))
            scout.bind(InetSocketAddress("127.0.0.2", 0))
            scout.connect(door.address, 1000)
            scout.close()
            crowd.forEach(Socket::close)
        }
    }

    test("with certificates, exactly those of the fleet are let in, and under their own names") {
        val made = TestCertificates(tempdir().toPath(), "base", "scout", "eve")
        val base = FleetCertificates(made.of("base", "base", "scout"))
        TestDoor(entrance(settings("base"), base)).use { door ->
            val scout = FleetCertificates(made.of("scout", "base", "scout"))
            door.greet(entrance(settings("scout"), scout)).use { socket ->
                val other = door.admitted.poll(60, TimeUnit.SECONDS)!!
                socket.getOutputStream().write("secret".toByteArray())
                String(other.getInputStream().readNBytes(6)) shouldBe "secret"
            }
            val eve = FleetCertificates(made.of("eve", "base", "scout"))
            shouldThrow<IOException> { door.greet(entrance(settings("scout"), eve)) }.message shouldContain
                "does not know the certificate of this computer, which belongs there as fleet/scout.crt"
            door.toldNext() shouldContain "does not begin TLS as the fleet does: it shows a certificate that is not in"
            shouldThrow<IOException> { door.greet(entrance(settings("scout"))) }.message shouldContain "speaks no language of a fleet"
            door.toldNext() shouldContain "does not begin TLS as the fleet does"
            door.stranger(*ByteArray(20))
            door.told shouldHaveSize 0 // the first reason again
            door.admitted shouldHaveSize 0
        }
    }

    test("a computer cannot show another one's certificate, and a fleet may share one") {
        val made = TestCertificates(tempdir().toPath(), "base", "scout", "tail")
        val three = hosts + ("tail" to InetSocketAddress("127.0.0.1", 4009))
        TestDoor(entrance(settings("base", of = three), FleetCertificates(made.of("base", "scout", "tail")))).use { door ->
            val tail = FleetCertificates(made.of("tail", "base"))
            shouldThrow<IOException> { door.greet(entrance(settings("scout", of = three), tail)) }.message shouldContain
                "the computer that calls itself scout has the certificate of tail"
        }
        val shared = FleetCertificates(made.of("scout"))
        TestDoor(entrance(settings("base"), shared)).use { it.greet(entrance(settings("scout"), shared)).close() }
    }

    test("missing certificates are told") {
        val folder = tempdir().toPath()
        shouldThrow<IOException> { FleetCertificates(folder) }.message shouldBe
            "there is no certificate of this computer: put it into $folder/computer.crt, and its key beside it"
    }

    test("what listens beyond the loopback needs certificates or a word") {
        val there = InetSocketAddress("10.8.0.1", 4711)
        shouldThrow<IllegalArgumentException> { ClusterSettings("garden", "base", mapOf(), there) }.message shouldBe
            "10.8.0.1 can be reached by others, and without certificates everybody among them may take part in the fleet:" +
            " name the folder of its certificates, tls(\"folder\"), or say insecure"
        ClusterSettings("garden", "base", mapOf(), there, insecure = true).here shouldBe "base"
        val unknown = hosts + ("tail" to InetSocketAddress.createUnresolved("no.such.host", 4711))
        settings("base", of = unknown).hosts shouldBe unknown
        shouldThrow<IllegalArgumentException> { settings("tail") }.message shouldBe
            "no computer of the fleet garden is called tail; it has base, scout"
    }
})
