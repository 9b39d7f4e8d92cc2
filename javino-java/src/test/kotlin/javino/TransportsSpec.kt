package javino

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import javino.sim.MemoryLine
import javino.sim.SimulatedBoard
import javino.sim.SimulatedBoards
import java.io.File
import java.lang.reflect.InvocationTargetException
import java.net.URL
import java.net.URLClassLoader
import java.nio.file.Files
import java.util.Collections

class NowhereProvider : TransportProvider {
    override fun scheme() = "nowhere"

    override fun open(address: String, line: LineSettings): Transport = MemoryLine.unlimited("nowhere:$address", line).computer()

    override fun ports() = listOf("nowhere:here")
}

class UnusableProvider : TransportProvider {
    init {
        error("not today")
    }

    override fun scheme() = "unusable"

    override fun open(address: String, line: LineSettings): Transport = error("never made")

    override fun ports() = listOf<String>()
}

open class EchoBoard : SimulatedBoard {
    override fun run(line: Transport) {
        val bytes = ByteArray(64)
        while (true) {
            val count = line.read(bytes, 0, bytes.size, 1_000)
            line.write(bytes, 0, count, 1_000)
        }
    }
}

class ParrotBoard : EchoBoard()

/** A provider with a scheme of this library. */
class SecondTcpProvider : TransportProvider {
    override fun scheme() = "tcp"

    override fun open(address: String, line: LineSettings): Transport = error("never opened")
}

/** A board with the name of another board. */
open class FirstTwin : EchoBoard() {
    override fun name() = "twin"
}

class SecondTwin : FirstTwin()

class TransportsSpec : FunSpec({
    val line = LineSettings.defaults()

    test("a scheme that nobody offers is refused with those there are") {
        val refusal = shouldThrow<NoSuchPortException> { Transports.open("warp:9", line) }
        refusal.port() shouldBe "warp:9"
        refusal.message shouldContain "\"warp\""
        refusal.message shouldContain "serial, usb, tcp, tls, sim"
    }

    test("where no provider at all is found, the hint is to the jar that lost its services") {
        val classes = Transports::class.java.protectionDomain.codeSource.location
        val withoutServices = object : URLClassLoader(arrayOf(classes), ClassLoader.getPlatformClassLoader()) {
            override fun findResources(name: String) = Collections.emptyEnumeration<URL>()
        }
        withoutServices.use { loader ->
            inContext(loader) {
                val settings = loader.loadClass(LineSettings::class.java.name)
                val open = loader.loadClass(Transports::class.java.name).getMethod("open", String::class.java, settings)
                val refusal =
                    shouldThrow<InvocationTargetException> { open.invoke(null, "ttyACM0", settings.getMethod("defaults").invoke(null)) }
                refusal.cause!!.message shouldContain "META-INF/services"
            }
        }
    }

    test("a serial device may be named with its scheme") {
        val missing = "/dev/there-is-no-such-port"
        shouldThrow<NoSuchPortException> { Transports.open("serial:$missing", line) }.message shouldContain missing
    }

    test("providers and boards are found as services of the class loader that the thread has") {
        withServices(
            TransportProvider::class.java.name to NowhereProvider::class.java.name,
            SimulatedBoard::class.java.name to EchoBoard::class.java.name,
        ) {
            Transports.open("nowhere:there", line).use { it.name() shouldBe "nowhere:there" }
            Transports.ports() shouldContain "nowhere:here"
            Transports.ports() shouldContain "sim:echoboard"
            Transports.open("sim:echoboard", line).use { computer ->
                computer.write("hi".toByteArray(), 0, 2, 1_000)
                computer.readFully(2).decodeToString() shouldBe "hi"
            }
        }
    }

    test("a service that cannot be loaded leaves the others, with one line of log") {
        val warnings = logged("javino.Services") {
            withServices(
                TransportProvider::class.java.name to
                    "no.such.Provider\n${UnusableProvider::class.java.name}\n${NowhereProvider::class.java.name}",
                SimulatedBoard::class.java.name to "no.such.Board\n${ParrotBoard::class.java.name}",
            ) {
                Transports.open("nowhere:there", line).use { it.name() shouldBe "nowhere:there" }
                repeat(2) { Transports.ports() shouldContain "sim:parrotboard" }
            }
        }
        for (unusable in listOf("no.such.Provider", "javino.UnusableProvider", "no.such.Board")) {
            warnings.single { unusable in it } shouldStartWith "a service is left out, since it cannot be used: "
        }
    }

    test("a service whose name another one has is left out, with one line of log") {
        val warnings = logged("javino.Services") {
            withServices(
                TransportProvider::class.java.name to SecondTcpProvider::class.java.name,
                SimulatedBoard::class.java.name to "${FirstTwin::class.java.name}\n${SecondTwin::class.java.name}",
            ) {
                repeat(2) { Transports.ports() }
            }
        }
        warnings.single { "SecondTcpProvider" in it } shouldContain "its name \"tcp\" is that of javino.tcp.TcpTransportProvider"
        warnings.single { "SecondTwin" in it } shouldContain "its name \"sim:twin\" is that of javino.FirstTwin"
    }

    test("names of simulated boards are their own canonical names") {
        Transports.canonicalName("sim:robot") shouldBe "sim:robot"
        Transports.canonicalName("SIM:robot") shouldBe "sim:robot"
    }

    test("a name that cannot be opened still has a canonical name") {
        Transports.canonicalName("warp:9") shouldBe "warp:9"
        Transports.canonicalName("") shouldBe ""
    }

    test("two names of one device have one canonical name") {
        val directory = Files.createTempDirectory("javino")
        val device = Files.createFile(directory.resolve("device"))
        val link = Files.createSymbolicLink(directory.resolve("link"), device)
        val linkToLink = Files.createSymbolicLink(directory.resolve("link2"), link)
        for (name in listOf(device, link, linkToLink)) {
            Transports.canonicalName(name.toString()) shouldBe "serial:" + device.toRealPath()
        }
        directory.toFile().deleteRecursively()
    }
})

/** Runs [work] on a thread whose class loader finds these services. */
internal fun withServices(vararg services: Pair<String, String>, work: () -> Unit) {
    val directory = Files.createTempDirectory("services")
    for ((service, implementation) in services) {
        val file = directory.resolve("META-INF/services/$service")
        Files.createDirectories(file.parent)
        Files.writeString(file, implementation)
    }
    URLClassLoader(arrayOf(directory.toUri().toURL()), TransportsSpec::class.java.classLoader).use { loader ->
        try {
            inContext(loader, work)
        } finally {
            listOf("echoboard", "parrotboard", "twin").forEach(SimulatedBoards::unplug)
        }
    }
    File(directory.toString()).deleteRecursively()
}

private fun inContext(loader: ClassLoader, work: () -> Unit) {
    val thread = Thread.currentThread()
    val before = thread.contextClassLoader
    thread.contextClassLoader = loader
    try {
        work()
    } finally {
        thread.contextClassLoader = before
    }
}
