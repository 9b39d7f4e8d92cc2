package javino.serial;

import java.util.List;
import javino.LineSettings;
import javino.PortException;
import javino.Transport;
import javino.TransportProvider;
import javino.Transports;

/** Opens serial devices. */
public final class SerialTransportProvider implements TransportProvider {
    @Override
    public String scheme() {
        return Transports.SERIAL;
    }

    @Override
    public Transport open(String address, LineSettings line) throws PortException {
        return SerialTransport.open(address, line);
    }

    @Override
    public List<String> ports() {
        return SerialPorts.names();
    }

    @Override
    public String canonicalName(String address) {
        return port(SerialDevice.of(address).canonicalAddress());
    }

    @Override
    public boolean isPresent(String address) {
        return SerialDevice.of(address).exists();
    }
}
