package javino.serial

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempfile
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.optional.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith
import javino.Transports
import java.io.File

class SerialPortsSpec : FunSpec({
    test("the devices that are described are those that can be opened") {
        SerialPorts.list().map { it.name() } shouldBe Transports.ports().filter { ':' !in it }
    }

    test("a process that holds a device is named").config(enabledOrReasonIf = { Terminals.available }) {
        Terminals.open().use { pair ->
            val process = ProcessBuilder("sleep", "600").redirectInput(File(pair.computer)).start()
            try {
                SerialPorts.holders(pair.computer).single { "${process.pid()}" in it } shouldStartWith "process ${process.pid()} ("
            } finally {
                process.destroyForcibly()
            }
        }
    }

    test("the program at the far end of a pseudo-terminal, which is the board, does not hold it").config(
        enabledOrReasonIf = { Terminals.available },
    ) {
        Terminals.open().use { pair -> SerialPorts.holders(pair.computer).shouldBeEmpty() }
    }

    test("nobody holds what is not there") {
        SerialPorts.holders("/dev/no such device").shouldBeEmpty()
    }

    test("a device that may be opened needs no remedy") {
        SerialPorts.permissionRemedy(tempfile().path).shouldBeEmpty()
        SerialPorts.permissionRemedy("/dev/no such device").shouldBeEmpty()
    }
})
