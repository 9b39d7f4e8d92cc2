package javino.serial

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.types.shouldBeInstanceOf
import javino.LineSettings
import javino.NoSuchPortException
import javino.PortBusyException
import javino.PortFaultException
import javino.PortPermissionException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermissions

private val onWindows = System.getProperty("os.name").startsWith("Windows")
private val onPosix = if (onWindows) Enabled.disabled("needs devices in the file system") else Enabled.enabled
private val asUser = when {
    onWindows -> onPosix
    System.getProperty("user.name") == "root" -> Enabled.disabled("root may open anything, so that nothing can be refused")
    else -> Enabled.enabled
}

private fun <T> withFile(work: (Path) -> T): T {
    val file = Files.createTempFile("javino", "device")
    try {
        return work(file)
    } finally {
        Files.delete(file)
    }
}

class SerialPortErrorsSpec : FunSpec({
    val line = LineSettings.defaults()

    test("a name without a slash is a device in /dev, except on Windows") {
        SerialDevice.of("ttyACM0", "Linux").path() shouldBe "/dev/ttyACM0"
        SerialDevice.of("COM5", "Mac OS X").path() shouldBe "/dev/COM5"
        SerialDevice.of("/dev/pts/3", "Linux").path() shouldBe "/dev/pts/3"
        SerialDevice.of("./board", "Linux").path() shouldBe "./board"
        SerialDevice.of("COM5", "Windows 11").path() shouldBe "COM5"
        SerialDevice.of("\\\\.\\COM12", "Windows 11").path() shouldBe "COM12"
    }

    test("on Windows a port's name is the same in either case") {
        SerialDevice.of("com5", "Windows 11").canonicalAddress() shouldBe SerialDevice.of("COM5", "Windows 11").canonicalAddress()
    }

    test("the driver's codes say what is wrong") {
        DriverErrorCode.posix(2, false) shouldBe DriverErrorCode.NO_SUCH_PORT
        DriverErrorCode.posix(2, true) shouldBe DriverErrorCode.OPEN_IN_THIS_PROGRAM
        DriverErrorCode.posix(13, true) shouldBe DriverErrorCode.NO_PERMISSION
        DriverErrorCode.posix(1, true) shouldBe DriverErrorCode.NO_PERMISSION
        DriverErrorCode.posix(16, true) shouldBe DriverErrorCode.BUSY
        DriverErrorCode.posix(11, true) shouldBe DriverErrorCode.BUSY
        DriverErrorCode.posix(35, true) shouldBe DriverErrorCode.BUSY
        DriverErrorCode.posix(25, true) shouldBe DriverErrorCode.NO_SUCH_PORT
        DriverErrorCode.posix(5, true) shouldBe DriverErrorCode.NO_SUCH_PORT
        DriverErrorCode.posix(22, true) shouldBe DriverErrorCode.OTHER
        DriverErrorCode.posix(22, false) shouldBe DriverErrorCode.NO_SUCH_PORT
        DriverErrorCode.windows(2) shouldBe DriverErrorCode.NO_SUCH_PORT
        DriverErrorCode.windows(5) shouldBe DriverErrorCode.BUSY
        DriverErrorCode.windows(31) shouldBe DriverErrorCode.OTHER
    }

    test("a missing port is told with where it was looked for and which ports there are") {
        val error = SerialPortErrors.noSuchPort(SerialDevice.of("ttyACM7", "Linux"), listOf("ttyACM0", "ttyUSB0"))
        error.port() shouldBe "ttyACM7"
        error.message shouldContain "/dev/ttyACM7"
        error.message shouldContain "ttyACM0, ttyUSB0"
        SerialPortErrors.noSuchPort(SerialDevice.of("ttyACM7", "Linux"), listOf()).message shouldContain "is the board plugged in?"
    }

    test("COM5 on Linux is told with the link that makes it work, and nothing else is") {
        SerialPortErrors.noSuchPort(SerialDevice.of("COM5", "Linux"), listOf()).message shouldContain "ln -s ttyACM0 /dev/COM5"
        SerialPortErrors.noSuchPort(SerialDevice.of("ttyACM7", "Linux"), listOf()).message shouldNotContain "ln -s"
        SerialPortErrors.noSuchPort(SerialDevice.of("COM5", "Windows 11"), listOf()).message shouldNotContain "/dev"
    }

    test("a port that belongs to a group is told with how to join that group") {
        val remedy = SerialPortErrors.permissionRemedy("/dev/ttyACM0", "uucp", PosixFilePermissions.fromString("rw-rw----"))
        remedy shouldContain "sudo usermod -aG uucp \$USER"
        remedy shouldContain "log out and in again"
    }

    test("nobody is told to join a group that may not use the port, or is the system's own") {
        for ((group, permissions) in listOf("dialout" to "rw-------", "dialout" to "rw-r-----", "root" to "rw-rw----")) {
            val remedy = SerialPortErrors.permissionRemedy("/dev/ttyACM0", group, PosixFilePermissions.fromString(permissions))
            remedy shouldContain "chmod"
            remedy shouldNotContain "usermod"
        }
    }

    test("the codes become exceptions of the kinds they mean").config(enabledOrReasonIf = { onPosix }) {
        withFile { file ->
            val device = SerialDevice.of(file.toString())
            SerialPortErrors.cannotOpen(device, 13, listOf()).shouldBeInstanceOf<PortPermissionException>()
            SerialPortErrors.cannotOpen(device, 16, listOf()).shouldBeInstanceOf<PortBusyException>()
            SerialPortErrors.cannotOpen(device, 2, listOf()).shouldBeInstanceOf<PortBusyException>().owner() shouldContain "this program"
            SerialPortErrors.cannotOpen(device, 22, listOf()).shouldBeInstanceOf<PortFaultException>().message shouldContain "22"
        }
    }

    test("a native library that cannot be loaded is told with what to do") {
        val error = SerialPortErrors.noNativeLibrary("ttyACM0", UnsatisfiedLinkError("read-only"))
        error.message shouldContain "-Djava.io.tmpdir"
        error.message shouldContain "-DjSerialComm.library.path"
        error.message shouldContain "read-only"
    }

    test("opening what is not there, or is no serial device, says so").config(enabledOrReasonIf = { onPosix }) {
        shouldThrow<NoSuchPortException> { SerialTransport.open("no-such-port", line) }.message shouldContain "/dev/no-such-port"
        withFile { file ->
            shouldThrow<NoSuchPortException> { SerialTransport.open(file.toString(), line) }.message shouldContain "not a serial device"
        }
        shouldThrow<NoSuchPortException> { SerialTransport.open("/dev", line) }
        shouldThrow<NoSuchPortException> { SerialTransport.open("\u0000", line) }
    }

    test("opening what this user may not says so").config(enabledOrReasonIf = { asUser }) {
        withFile { file ->
            Files.setPosixFilePermissions(file, setOf())
            shouldThrow<PortPermissionException> { SerialTransport.open(file.toString(), line) }
        }
    }
})
