package argo.connecting

import javino.serial.SerialPortInfo
import javino.serial.UsbTransportProvider
import java.util.Optional
import java.util.OptionalInt
import java.util.concurrent.CopyOnWriteArrayList

/** USB devices that the tests plug in, at ports such as `plugged:fff1:0002`. */
class PluggedIn : UsbTransportProvider("plugged", { devices }) {
    companion object {
        val devices = CopyOnWriteArrayList<SerialPortInfo>()

        /** Makes a device of this [name] with the identity `fff1:0002:A1`. */
        fun device(name: String) = SerialPortInfo(
            name, name, Optional.empty(), Optional.empty(), OptionalInt.of(0xfff1), OptionalInt.of(2), Optional.of("A1"),
        )
    }
}
