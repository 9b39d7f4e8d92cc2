package javino.tcp;

import javino.LineSettings;
import javino.PortException;
import javino.Transport;
import javino.TransportProvider;

/**
 * {@code tls://host:port}: a board on the network behind TLS. The board's certificate is kept at the first connection, or was put into the
 * folder {@code ~/.argo/tls} before, and no other one is accepted from then on; see the documentation of the ports.
 */
public final class TlsTransportProvider implements TransportProvider {
    private final TcpTransportProvider tcp = new TcpTransportProvider();

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

    @Override
    public String canonicalAddress(String address) {
        return tcp.canonicalAddress(address);
    }

    @Override
    public LineSettings usualLine() {
        return tcp.usualLine();
    }
}
