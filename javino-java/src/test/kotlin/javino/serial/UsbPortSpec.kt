package javino.serial

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import javino.LineSettings
import javino.NoSuchPortException
import javino.PortBusyException
import javino.TransportProvider
import javino.Transports
import javino.link.Link
import javino.link.LinkSettings
import javino.withServices
import java.nio.file.Path
import java.util.Optional
import java.util.OptionalInt
import java.util.concurrent.CopyOnWriteArrayList

private val UNO = usbDevice("ttyACM0", 0x2341, 0x0043, "75830303")
private val OTHER_UNO = usbDevice("ttyACM1", 0x2341, 0x0043, "95234343")
private val CLONE = usbDevice("ttyUSB0", 0x1a86, 0x7523)

private fun usbDevice(name: String, vendor: Int, product: Int, serialNumber: String? = null) =
    SerialPortInfo(name, name, Optional.empty(), Optional.empty(), OptionalInt.of(vendor), OptionalInt.of(product),
        Optional.ofNullable(serialNumber))

/** The devices that the test lists, at ports such as `plugged:2341:0043`. */
class PluggedIn : UsbTransportProvider("plugged", { devices }) {
    companion object {
        val devices = CopyOnWriteArrayList<SerialPortInfo>()
    }
}

private fun usb(present: List<SerialPortInfo>) = object : UsbTransportProvider("usb", { present }) { }

class UsbPortSpec : FunSpec({
    val line = LineSettings.defaults()

    fun canonical(address: String, vararg present: SerialPortInfo) = usb(present.toList()).canonicalName(address)

    fun refusal(address: String, vararg present: SerialPortInfo): String {
        val refusal = shouldThrow<NoSuchPortException> { usb(present.toList()).open(address, line) }
        refusal.port() shouldBe "usb:$address"
        return refusal.message.orEmpty()
    }

    test("an identity is vendor and product in hexadecimal digits of either case, and maybe a serial number") {
        for (address in listOf("1a86:7523", "1A86:7523")) canonical(address, UNO, CLONE) shouldBe "serial:/dev/ttyUSB0"
        canonical("2341:43", UNO, CLONE) shouldBe "serial:/dev/ttyACM0"
        canonical("2341:0043:95234343", UNO, OTHER_UNO) shouldBe "serial:/dev/ttyACM1"
        canonical("1a86:7523:a:B", CLONE.numbered("a:b")) shouldBe "serial:/dev/ttyUSB0"
    }

    test("what is no identity is refused in words that say what is") {
        for (address in listOf("2341", "2341:", "2341:004g", "2341:00043", ":0043", "2341:0043:", "2341-0043", "0x2341:0x0043")) {
            val message = refusal(address, UNO)
            message shouldContain "usb:$address"
            message shouldContain "usb:VENDOR:PRODUCT"
            canonical(address, UNO) shouldBe "usb:$address"
        }
    }

    test("where no device fits, those there are are listed with their identities") {
        val message = refusal("2341:0001", UNO, CLONE)
        message shouldContain "ttyACM0 (usb:2341:0043:75830303)"
        message shouldContain "ttyUSB0 (usb:1a86:7523)"
        refusal("2341:0043:1", UNO) shouldContain "ttyACM0 (usb:2341:0043:75830303)"
        refusal("2341:0001") shouldContain "is the board plugged in?"
    }

    test("of several that fit none is taken, and the serial number is asked for if that can tell them apart") {
        val message = refusal("2341:0043", UNO, OTHER_UNO, CLONE)
        message shouldContain "is 2 devices: ttyACM0 (usb:2341:0043:75830303), ttyACM1 (usb:2341:0043:95234343)"
        message shouldContain "give the serial number"
        message shouldNotContain "ttyUSB0"
        refusal("1a86:7523", CLONE, CLONE.at("ttyUSB1")) shouldContain "cannot tell them apart"
    }

    test("a device is present while it is on USB") {
        val plugged = CopyOnWriteArrayList(listOf(CLONE))
        val provider = usb(plugged)
        provider.isPresent("1a86:7523") shouldBe true
        provider.isPresent("2341:0043") shouldBe false
        provider.isPresent("nonsense") shouldBe false
        plugged.clear()
        provider.isPresent("1a86:7523") shouldBe false
    }

    test("the second names that macOS has for its devices are left out") {
        val out = UNO.at("cu.usbmodem1")
        UsbTransportProvider.onceEach(listOf(UNO.at("tty.usbmodem1"), out, CLONE.at("tty.other"))) shouldBe
            listOf(out, CLONE.at("tty.other"))
    }

    test("a device by its identity and by its name is one port with one owner")
        .config(enabledOrReasonIf = { Terminals.available }, blockingTest = true) {
            Terminals.open().use { terminals ->
                val device = usbDevice(terminals.computer, 0xfff1, 0x0001, "A1")
                withUsb(device) {
                    Transports.canonicalName("plugged:fff1:1") shouldBe "serial:" + Path.of(terminals.computer).toRealPath()
                    Link.open("plugged:FFF1:0001", LinkSettings.defaults(), "agent bob").use { link ->
                        link.port() shouldBe "plugged:FFF1:0001"
                        ownerMetBy("agent alice", terminals.computer) shouldBe "agent bob"
                    }
                    Link.open(terminals.computer, LinkSettings.defaults(), "agent alice").use {
                        ownerMetBy("agent bob", "plugged:fff1:0001:a1") shouldBe "agent alice"
                    }
                }
            }
        }
})

private fun SerialPortInfo.at(name: String) = SerialPortInfo(name, name, product, manufacturer, vendorId, productId, serialNumber)

private fun SerialPortInfo.numbered(number: String) =
    SerialPortInfo(name, path, product, manufacturer, vendorId, productId, Optional.of(number))

private fun ownerMetBy(owner: String, port: String) =
    shouldThrow<PortBusyException> { Link.open(port, LinkSettings.defaults(), owner) }.owner()

private fun withUsb(device: SerialPortInfo, work: () -> Unit) {
    PluggedIn.devices += device
    try {
        withServices(TransportProvider::class.java.name to PluggedIn::class.java.name, work = work)
    } finally {
        PluggedIn.devices.clear()
    }
}
