package javino;

import java.util.List;

/** Serial devices. */
final class SerialTransportProvider implements TransportProvider {
    @Override
    public String scheme() {
        return PortName.SERIAL;
    }

    @Override
    public Transport open(String address, LineSettings line) throws PortException {
        return SerialTransport.open(SerialDevice.of(address), line);
    }

    @Override
    public List<String> ports() {
        return SerialTransport.ports();
    }

    @Override
    public String canonicalAddress(String address) {
        return SerialDevice.of(address).canonicalAddress();
    }

    @Override
    public boolean isPresent(String address) {
        return SerialDevice.of(address).exists();
    }
}
