package javino.serial;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import javino.LineSettings;
import javino.NoSuchPortException;
import javino.PortException;
import javino.Transport;
import javino.TransportProvider;
import javino.Transports;

/** {@code usb:2341:0043} and {@code usb:2341:0043:SERIAL}: the serial device on USB with this identity, whatever its name is now. */
public class UsbTransportProvider implements TransportProvider {
    static final String SCHEME = "usb";
    /** On macOS each device has two names; this one begins the name for calls in. The name for calls out is the one to open. */
    private static final String MAC_CALL_IN = "tty.";

    private static final String MAC_CALL_OUT = "cu.";

    private final String scheme;
    private final Supplier<List<SerialPortInfo>> present;

    /** The scheme {@code usb} and the devices of this machine. */
    public UsbTransportProvider() {
        this(SCHEME, SerialPorts::present);
    }

    /**
     * The devices of another list than the driver's.
     *
     * @param present the serial devices there are now; asked on any thread, about once a second while a device is waited for
     */
    protected UsbTransportProvider(String scheme, Supplier<List<SerialPortInfo>> present) {
        this.scheme = scheme;
        this.present = present;
    }

    @Override
    public String scheme() {
        return scheme;
    }

    @Override
    public Transport open(String address, LineSettings line) throws PortException {
        return SerialTransport.open(
                new SerialDevice(port(address), device(address).path()), line);
    }

    @Override
    public String canonicalName(String address) {
        try {
            return Transports.SERIAL + ':' + device(address).canonicalAddress();
        } catch (NoSuchPortException e) {
            return port(address); // the address names no device now
        }
    }

    @Override
    public boolean isPresent(String address) {
        try {
            return !fitting(address).isEmpty(); // if several fit, opening fails with their list
        } catch (NoSuchPortException e) {
            return false;
        }
    }

    private SerialDevice device(String address) throws NoSuchPortException {
        List<SerialPortInfo> fitting = fitting(address);
        return switch (fitting.size()) {
            case 0 -> throw nothing(port(address), onUsb());
            case 1 -> SerialDevice.of(fitting.get(0).name());
            default -> throw severalAlike(port(address), fitting);
        };
    }

    private List<SerialPortInfo> fitting(String address) throws NoSuchPortException {
        UsbIdentity identity = UsbIdentity.of(port(address), address);
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

    /** Returns {@code ports} without the second names that macOS has for the same devices. */
    static List<SerialPortInfo> onceEach(List<SerialPortInfo> ports) {
        List<String> devices = ports.stream().map(SerialPortInfo::name).toList();
        return ports.stream()
                .filter(port -> !port.name().startsWith(MAC_CALL_IN)
                        || !devices.contains(MAC_CALL_OUT + port.name().substring(MAC_CALL_IN.length())))
                .toList();
    }
}
