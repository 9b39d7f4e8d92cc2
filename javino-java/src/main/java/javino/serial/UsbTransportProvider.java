package javino.serial;

import java.util.List;
import java.util.function.Supplier;
import javino.LineSettings;
import javino.NoSuchPortException;
import javino.PortException;
import javino.Transport;
import javino.TransportProvider;
import javino.Transports;

/** Opens the serial device that has a given USB identity: {@code usb:2341:0043} or {@code usb:2341:0043:SERIAL}. */
public class UsbTransportProvider implements TransportProvider {
    static final String SCHEME = "usb";

    private final String scheme;
    private final UsbDevices devices;

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
        devices = new UsbDevices(present);
    }

    @Override
    public String scheme() {
        return scheme;
    }

    @Override
    public Transport open(String address, LineSettings line) throws PortException {
        String port = port(address);
        return SerialTransport.open(
                new SerialDevice(port, devices.device(port, address).path()), line);
    }

    @Override
    public String canonicalName(String address) {
        String port = port(address);
        try {
            return Transports.SERIAL + ':' + devices.device(port, address).canonicalAddress();
        } catch (NoSuchPortException e) {
            return port; // no device has this identity now
        }
    }

    @Override
    public boolean isPresent(String address) {
        try {
            return !devices.fitting(port(address), address).isEmpty(); // if several fit, opening fails with their list
        } catch (NoSuchPortException e) {
            return false;
        }
    }
}
