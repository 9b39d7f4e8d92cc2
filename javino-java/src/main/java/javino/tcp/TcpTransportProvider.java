package javino.tcp;

import java.io.IOException;
import java.net.Socket;
import javino.LineSettings;
import javino.NoSuchPortException;
import javino.PortException;
import javino.PortFaultException;
import javino.Transport;
import javino.TransportProvider;

/** Opens {@code tcp://host:port}: a board on the network, or a serial server with a board behind it. */
public class TcpTransportProvider implements TransportProvider {
    @Override
    public String scheme() {
        return "tcp";
    }

    @Override
    public Transport open(String address, LineSettings line) throws PortException {
        String port = port(address);
        Socket socket = TcpConnector.connect(port, TcpAddress.of(port, address));
        try {
            return new TcpTransport(socket, port, line);
        } catch (IOException e) {
            throw new PortFaultException(port, "port " + port + " cannot be opened: " + e.getMessage(), e);
        }
    }

    @Override
    public String canonicalName(String address) {
        try {
            return port(TcpAddress.of(port(address), address).canonical());
        } catch (NoSuchPortException e) {
            return port(address);
        }
    }

    @Override
    public LineSettings usualLine() {
        return LineSettings.NETWORK;
    }
}
