package javino.serial;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import javino.NoSuchPortException;

/** Finds the device with a given USB identity among the serial devices of {@code present}. */
record UsbDevices(Supplier<List<SerialPortInfo>> present) {
    /** macOS has two names for each device. A name with this prefix is for incoming calls. Programs open the other name. */
    private static final String MAC_CALL_IN = "tty.";

    private static final String MAC_CALL_OUT = "cu.";

    /** @throws NoSuchPortException if no device or several devices have this identity; the message lists the devices */
    SerialDevice device(String port, String address) throws NoSuchPortException {
        List<SerialPortInfo> fitting = fitting(port, address);
        return switch (fitting.size()) {
            case 0 -> throw nothing(port, onUsb());
            case 1 -> SerialDevice.of(fitting.get(0).name());
            default -> throw severalAlike(port, fitting);
        };
    }

    List<SerialPortInfo> fitting(String port, String address) throws NoSuchPortException {
        UsbIdentity identity = UsbIdentity.of(port, address);
        return onUsb().stream().filter(identity::fits).toList();
    }

    private List<SerialPortInfo> onUsb() {
        return onceEach(present.get().stream()
                .filter(port -> port.usbName().isPresent())
                .toList());
    }

    private static NoSuchPortException nothing(String port, List<SerialPortInfo> present) {
        return new NoSuchPortException(
                port,
                "there is no USB device " + port + "; "
                        + (present.isEmpty()
                                ? "there are no serial devices on USB now (is the board plugged in?)"
                                : "the serial devices on USB are: " + listed(present)));
    }

    private static NoSuchPortException severalAlike(String port, List<SerialPortInfo> alike) {
        long identities = alike.stream().map(SerialPortInfo::usbName).distinct().count();
        return new NoSuchPortException(
                port,
                "port " + port + " is " + alike.size() + " devices: " + listed(alike) + "; "
                        + (identities == alike.size()
                                ? "give the serial number, too"
                                : "USB cannot tell them apart, so give the name of the device")
                        + " (on Linux \"/dev/serial/by-path/…\" names a socket)");
    }

    private static String listed(List<SerialPortInfo> ports) {
        return ports.stream()
                .map(port -> port.name() + " (" + port.usbName().orElseThrow() + ")")
                .collect(Collectors.joining(", "));
    }

    /** Leaves out the second name that macOS has for each device. */
    static List<SerialPortInfo> onceEach(List<SerialPortInfo> ports) {
        List<String> devices = ports.stream().map(SerialPortInfo::name).toList();
        return ports.stream()
                .filter(port -> !port.name().startsWith(MAC_CALL_IN)
                        || !devices.contains(MAC_CALL_OUT + port.name().substring(MAC_CALL_IN.length())))
                .toList();
    }
}
