package javino.tcp;

import javino.LineSettings;
import javino.PortException;
import javino.Transport;

/**
 * Opens {@code tls://host:port}: a board on the network, over TLS. The first connection stores the board's certificate in the folder
 * {@code ~/.argo/tls}, unless the folder already has one. Later connections accept only the stored certificate. The documentation of the
 * ports has the details.
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
