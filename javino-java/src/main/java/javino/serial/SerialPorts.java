package javino.serial;

import com.fazecast.jSerialComm.SerialPort;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import javino.PortFaultException;

/** Lists and describes serial devices without opening them, because opening resets most boards. Safe on any thread. */
public final class SerialPorts {
    private static final String UNKNOWN = "Unknown"; // jSerialComm's word for a missing text

    private SerialPorts() {}

    /**
     * Returns the present serial devices, sorted by name.
     *
     * @throws PortFaultException if the driver's native library cannot be loaded; the message says what to do
     */
    public static List<SerialPortInfo> list() throws PortFaultException {
        try {
            return Arrays.stream(SerialPort.getCommPorts())
                    .map(SerialPorts::info)
                    .sorted(Comparator.comparing(SerialPortInfo::name))
                    .toList();
        } catch (LinkageError e) {
            throw SerialPortErrors.noNativeLibrary("of any name", e);
        }
    }

    /** Like {@link #list}, but returns an empty list if jSerialComm cannot run. Opening a device then reports the cause. */
    static List<SerialPortInfo> present() {
        try {
            return list();
        } catch (PortFaultException e) {
            return List.of();
        }
    }

    static List<String> names() {
        return present().stream().map(SerialPortInfo::name).toList();
    }

    private static SerialPortInfo info(SerialPort port) {
        String name = nameOf(port);
        return new SerialPortInfo(
                name,
                SerialDevice.of(name).path(),
                known(port.getPortDescription()),
                known(port.getManufacturer()),
                known(port.getVendorID()),
                known(port.getProductID()),
                known(port.getSerialNumber()));
    }

    /** Returns the name that opens the port. For a device in a folder of {@code /dev}, such as a pseudo-terminal, returns its path. */
    private static String nameOf(SerialPort port) {
        SerialDevice device = SerialDevice.of(port.getSystemPortName());
        return device.hasNode() && !device.path().equals(port.getSystemPortPath())
                ? port.getSystemPortPath()
                : device.name();
    }

    private static Optional<String> known(String text) {
        return Optional.ofNullable(text).filter(it -> !it.isBlank() && !it.equals(UNKNOWN));
    }

    private static OptionalInt known(int number) {
        return number < 0 ? OptionalInt.empty() : OptionalInt.of(number);
    }

    /**
     * Returns the other processes that have a serial device open, such as {@code process 4711 (minicom)}. Empty if there are no such
     * processes, or if this user cannot see them. Always empty without {@code /proc}.
     */
    public static List<String> holders(String port) {
        return DeviceHolders.of(SerialDevice.of(port));
    }

    /**
     * Returns how this user gets permission to open a device. Empty if the user has the permission, or if only an attempt to open the
     * device would show the remedy.
     */
    public static Optional<String> permissionRemedy(String port) {
        SerialDevice device = SerialDevice.of(port);
        if (!device.hasNode() || !device.exists()) {
            return Optional.empty();
        }
        Path node = Path.of(device.path());
        return Files.isReadable(node) && Files.isWritable(node)
                ? Optional.empty()
                : Optional.of(SerialPortErrors.permissionRemedy(device));
    }
}
