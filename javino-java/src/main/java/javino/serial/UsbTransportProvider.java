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

/** Opens the serial device that has a given USB identity: {@code usb:2341:0043} or {@code usb:2341:0043:SERIAL}. */
public class UsbTransportProvider implements TransportProvider {
    static final String SCHEME = "usb";

    /** macOS has two names for each device. A name with this prefix is for incoming calls. Programs open the other name. */
    private static final String MAC_CALL_IN = "tty.";

    private static final String MAC_CALL_OUT = "cu.";

    private final String scheme;
    private final Supplier<List<SerialPortInfo>> present;

    /** Creates a provider with the scheme {@code usb} for the devices of this machine. */
    public UsbTransportProvider() {
        this(SCHEME, SerialPorts::present);
    }

    /**
     * Creates a provider for another list of devices.
     * @param present returns the present serial devices; called on any thread, about once a second while a device is missing
     */
    protected UsbTransportProvider(String scheme, Supplier<List<SerialPortInfo>> present) {
        this.scheme = scheme;
        this.present = present;
    }

    @Override
    public String scheme() {
        return scheme;
    }

    /** @throws NoSuchPortException if no device or several devices have this identity; the message lists the devices */
    @Override
    public Transport open(String address, LineSettings line) throws PortException {
        String port = port(address);
        return SerialTransport.open(new SerialDevice(port, device(port, address).path()), line);
    }

    @Override
    public String canonicalName(String address) {
        String port = port(address);
        try {
            return Transports.SERIAL + ':' + device(port, address).canonicalAddress();
        } catch (NoSuchPortException e) {
            return port; // no device has this identity now
        }
    }

    @Override
    public boolean isPresent(String address) {
        try {
            return !fitting(port(address), address).isEmpty(); // if several fit, opening fails with their list
        } catch (NoSuchPortException e) {
            return false;
        }
    }

    private SerialDevice device(String port, String address) throws NoSuchPortException {
        List<SerialPortInfo> fitting = fitting(port, address);
        return switch (fitting.size()) {
            case 0 -> throw nothing(port, onUsb());
            case 1 -> SerialDevice.of(fitting.get(0).name());
            default -> throw severalAlike(port, fitting);
        };
    }

    private List<SerialPortInfo> fitting(String port, String address) throws NoSuchPortException {
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
