package javino;

import com.fazecast.jSerialComm.SerialPort;
import java.util.Arrays;
import java.util.List;

/** Serial devices, through jSerialComm. */
final class SerialTransportProvider implements TransportProvider {
    @Override
    public String scheme() {
        return PortName.SERIAL;
    }

    @Override
    public Transport open(String address, LineSettings line) throws PortException {
        return SerialTransport.open(address, line);
    }

    @Override
    public List<String> ports() {
        return Arrays.stream(SerialPort.getCommPorts()).map(SerialPort::getSystemPortName).sorted().toList();
    }
}
