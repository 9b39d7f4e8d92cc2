package javino.tcp;

import javino.LineSettings;
import javino.PortException;
import javino.Transport;

/**
 * {@code tls://host:port}: a board on the network behind TLS. The first connection stores the board's certificate in the folder
 * {@code ~/.argo/tls}, unless it already has one. From then on only that certificate is accepted; see the documentation of the ports.
 */
public final class TlsTransportProvider extends TcpTransportProvider {
    @Override
    public String scheme() {
        return "tls";
    }

    @Override
    public Transport open(String address, LineSettings line) throws PortException {
        String port = port(address);
        return TlsConnector.connect(
                port, TcpAddress.of(port, address), TlsFolder.ofUser(), line, TcpConnector.LIMIT_MILLIS);
    }
}
