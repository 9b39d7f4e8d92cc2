package javino.serial;

import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javino.LineSettings;
import javino.NoSuchPortException;
import javino.PortException;
import javino.Transports;
import javino.Services;
import javino.Transport;
import javino.TransportProvider;

/** {@code usb:2341:0043} and {@code usb:2341:0043:SERIAL}: the serial device on USB that says this of itself, whatever its name is today. */
public final class UsbTransportProvider implements TransportProvider {
    static final String SCHEME = "usb";
    /** macOS has each device twice, and the one that calls out is the one to open. */
    private static final String MAC_CALL_IN = "tty.";
    private static final String MAC_CALL_OUT = "cu.";

    private final UsbPorts present;

    public UsbTransportProvider() {
        this(UsbTransportProvider::ofDriverAndServices);
    }

    UsbTransportProvider(UsbPorts present) {
        this.present = present;
    }

    @Override
    public String scheme() {
        return SCHEME;
    }

    @Override
    public Transport open(String address, LineSettings line) throws PortException {
        return SerialTransport.open(new SerialDevice(port(address), device(address).path()), line);
    }

    /** None: each is among the serial devices. */
    @Override
    public List<String> ports() {
        return List.of();
    }

    @Override
    public String canonicalName(String address) {
        try {
            return Transports.SERIAL + ':' + device(address).canonicalAddress();
        } catch (NoSuchPortException e) {
            return port(address); // it is no device's name now
        }
    }

    @Override
    public boolean isPresent(String address) {
        try {
            return !fitting(address).isEmpty(); // of several, opening says so
        } catch (NoSuchPortException e) {
            return false;
        }
    }

    private SerialDevice device(String address) throws NoSuchPortException {
        List<UsbPort> fitting = fitting(address);
        if (fitting.isEmpty()) {
            throw nothing(port(address), present.now());
        }
        if (fitting.size() > 1) {
            throw severalAlike(port(address), fitting);
        }
        return SerialDevice.of(fitting.get(0).device());
    }

    private List<UsbPort> fitting(String address) throws NoSuchPortException {
        UsbIdentity identity = UsbIdentity.of(port(address), address);
        return present.now().stream().filter(identity::fits).toList();
    }

    private static String port(String address) {
        return SCHEME + ':' + address;
    }

    private static NoSuchPortException nothing(String port, List<UsbPort> present) {
        return new NoSuchPortException(port, "there is no USB device " + port + "; "
                + (present.isEmpty() ? "there are no serial devices on USB now (is the board plugged in?)"
                : "the serial devices on USB are: " + listed(present)));
    }

    private static NoSuchPortException severalAlike(String port, List<UsbPort> alike) {
        long identities = alike.stream().map(UsbPort::name).distinct().count();
        return new NoSuchPortException(port, "port " + port + " is " + alike.size() + " devices: " + listed(alike) + "; "
                + (identities == alike.size() ? "give the serial number, too" : "USB cannot tell them apart, so give the name of the device")
                + " (on Linux \"/dev/serial/by-path/…\" names a socket)");
    }

    private static String listed(List<UsbPort> ports) {
        return ports.stream().map(port -> port.device() + " (" + port.name() + ")").collect(Collectors.joining(", "));
    }

    private static List<UsbPort> ofDriverAndServices() {
        Stream<UsbPort> added = Services.providers(UsbPorts.class).stream().map(Services::make).filter(Objects::nonNull)
                .flatMap(ports -> ports.now().stream());
        // what two class loaders see, or the driver too, comes twice
        return onceEach(Stream.concat(SerialTransport.usbPorts().stream(), added).distinct().toList());
    }

    /** Without the second names that macOS has for the same devices. */
    static List<UsbPort> onceEach(List<UsbPort> ports) {
        List<String> devices = ports.stream().map(UsbPort::device).toList();
        return ports.stream().filter(port -> !port.device().startsWith(MAC_CALL_IN)
                || !devices.contains(MAC_CALL_OUT + port.device().substring(MAC_CALL_IN.length()))).toList();
    }
}
