package javino

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class PortNameSpec : FunSpec({
    test("a name with a scheme goes to that scheme") {
        PortName.of("sim:robot") shouldBe PortName("sim", "robot")
        PortName.of("tcp:localhost:4000") shouldBe PortName("tcp", "localhost:4000")
        PortName.of("SIM:Robot") shouldBe PortName("sim", "Robot")
    }

    test("a name without one is a serial device") {
        for (name in listOf("ttyACM0", "COM8", "/dev/ttyUSB0", "/dev/serial/by-path/pci-0000:00:14.0-usb-0:3:1.0", "./robot")) {
            PortName.of(name) shouldBe PortName("serial", name)
        }
        PortName.of(" ttyACM0 ") shouldBe PortName("serial", "ttyACM0")
    }

    test("drive letters and DOS devices are no schemes") {
        PortName.of("C:\\dev\\board") shouldBe PortName("serial", "C:\\dev\\board")
        PortName.of("C:/board") shouldBe PortName("serial", "C:/board")
        PortName.of("COM8:") shouldBe PortName("serial", "COM8")
        PortName.of("\\\\.\\COM12") shouldBe PortName("serial", "\\\\.\\COM12")
    }

    test("a scheme without an address, and no name at all, are refused") {
        for (name in listOf("sim:", "", "  ")) {
            shouldThrow<NoSuchPortException> { PortName.of(name) }.message shouldContain "\"$name\""
        }
    }
})
