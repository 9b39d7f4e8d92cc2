package samples.fleet

import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotContain
import samples.Program
import samples.bare.newestJava
import java.io.File
import java.io.IOException
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.NetworkInterface
import java.net.Socket
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit

private const val LIMIT_S = 300L
private const val CONNECT_LIMIT_MS = 2_000

class FleetSpec : FunSpec({
    val newest = newestJava()
    val runsNewest = if (newest.feature >= 21) Enabled.enabled
    else Enabled.disabled("the newest Jason needs Java 21, and the newest here is ${newest.feature}")
    val newestJason = System.getProperty("java.class.path").split(File.pathSeparator).filterNot { "jason-interpreter" in it }
        .plus(System.getProperty("newest.jason.jar")).joinToString(File.pathSeparator)

    test("when the process of a robot is killed, the other one gets its places; when the coordinator's is, it goes on elsewhere").config(
        tags = thorough,
    ) { shouldGoOn { Fleet.start(printed = it) } }

    test("the same with the newest Jason").config(tags = thorough, enabledOrReasonIf = { runsNewest }) {
        shouldGoOn { Fleet.start(newest.program, newestJason, it) }
    }

    test("nothing of it listens beyond this computer, and nothing is left of it") {
        val lines = Lines()
        val fleet = Fleet.start(printed = lines::add)
        fleet.use {
            lines.await { it.endsWith("scout1 is there") }
            fleet.ports.values.filterNot { isOpen(InetAddress.getByName("127.0.0.1"), it) }.shouldBeEmpty()
            fleet.ports.values.filter { port -> otherAddresses().any { isOpen(it, port) } }.shouldBeEmpty()
        }
        fleet.ports.keys.filter(fleet::isAlive).shouldBeEmpty()
    }

    test("the command shows it and ends").config(tags = thorough) {
        Program.samples("fleet", "--seconds", "5").use { program ->
            listOf(
                "has visited", "scout2 has been killed", "scout2 is lost", "base has been killed", "coordinator runs on scout1 now",
                "has visited",
            ).forEach(program::awaitLine)
            val (status, printed) = program.awaitEnd()
            status shouldBe 0
            printed shouldNotContain "Exception"
        }
    }
})

/** Kills processes of the fleet that [start] starts. Waits until the others have taken over. */
private fun shouldGoOn(start: ((String) -> Unit) -> Fleet) {
    val lines = Lines()
    start(lines::add).use { fleet ->
        lines.await { watched("scout1").size == 2 && watched("scout2").size == 2 }
        for (scout in listOf("scout1", "scout2")) lines.await { "$scout has visited" in it } // repeated, in any order
        val orphaned = lines.watched("scout2")

        fleet.kill("scout2")
        lines.await { it.endsWith("scout2 is lost") }
        lines.await { watched("scout1").size == 4 }
        for (place in orphaned) lines.await { it.endsWith("scout1 has visited $place") }

        fleet.start("scout2")
        lines.await { watched("scout1").size == 2 && watched("scout2").size == 2 }

        fleet.kill("base")
        lines.await { it.endsWith("coordinator runs on scout1 now, with what it believed") }
        lines.await { watched("scout1").size == 2 && watched("scout2").size == 2 }

        fleet.start("base")
        lines.await { "scout1 has visited" in it }
        listOf("base", "scout1", "scout2").all(fleet::isAlive) shouldBe true
    }
}

/**
 * Returns the addresses of this computer except 127.0.0.1. On Linux, other addresses of 127.0.0.0/8 reach only programs that listen on all
 * interfaces.
 */
private fun otherAddresses(): List<InetAddress> {
    val others = NetworkInterface.networkInterfaces().toList().flatMap { it.inetAddresses().toList() }.filterNot { it.isLoopbackAddress }
    return if (System.getProperty("os.name") == "Linux") others + InetAddress.getByName("127.0.0.2") else others
}

private fun isOpen(address: InetAddress, port: Int): Boolean = try {
    Socket().use { it.connect(InetSocketAddress(address, port), CONNECT_LIMIT_MS) }
    true
} catch (_: IOException) {
    false
}

/** The printed lines of the computers, and the assignments of the coordinator in them. */
private class Lines {
    private val unread = LinkedBlockingQueue<String>()
    private val watches = LinkedHashMap<String, String>()
    private val read = ArrayList<String>()

    fun add(line: String) = unread.put(line)

    fun watched(scout: String): List<String> = watches.filterValues { it == scout }.keys.toList()

    fun await(wanted: Lines.(String) -> Boolean) {
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(LIMIT_S)
        while (true) {
            val line = unread.poll(deadline - System.nanoTime(), TimeUnit.NANOSECONDS)
                ?: throw AssertionError("nothing like that within $LIMIT_S s in:\n${read.joinToString("\n")}")
            read += line
            WATCHES.find(line)?.destructured?.let { (scout, place) -> watches[place] = scout }
            LOST.find(line)?.groupValues?.get(1)?.let { lost -> watches.values.removeAll { it == lost } }
            if (wanted(line)) return
        }
    }

    private companion object {
        val WATCHES = Regex("""\[coordinator] (\w+) watches (\w+)""")
        val LOST = Regex("""\[coordinator] (\w+) is lost""")
    }
}

private val thorough = setOf(NamedTag("Thorough"))
