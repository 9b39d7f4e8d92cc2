package javino.tcp;

import java.io.IOException;
import java.io.PushbackInputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.security.GeneralSecurityException;
import java.util.Date;
import java.util.concurrent.ExecutionException;
import javax.net.ssl.KeyManager;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManager;
import javino.LineSettings;
import javino.PortException;
import javino.PortFaultException;
import javino.PortInterruptedException;

/**
 * Makes a TLS connection over a TCP connection. Checks the board's certificate. If the board asks for the computer's certificate, shows
 * it.
 */
final class TlsConnector {
    /** The time to wait for a refusal. In TLS 1.3 a board refuses the computer's certificate only after the handshake. */
    private static final int REFUSAL_MILLIS = 300;

    private final String port;
    private final TcpAddress address;
    private final TlsFolder folder;
    private final int limitMillis;
    private final PinnedCertificate board;
    private final OwnCertificate own;
    private final SSLContext context;

    private TlsConnector(String port, TcpAddress address, TlsFolder folder, int limitMillis)
            throws IOException, GeneralSecurityException {
        this.port = port;
        this.address = address;
        this.folder = folder;
        this.limitMillis = limitMillis;
        board = new PinnedCertificate(folder, address, new Date());
        own = new OwnCertificate(folder.computer());
        context = SSLContext.getInstance("TLS");
        context.init(new KeyManager[] {own}, new TrustManager[] {board}, null);
    }

    /**
     * @param folder the folder with the certificates, which also stores a new board's certificate
     * @param limitMillis most milliseconds for each answer of the board during the handshake
     * @throws PortException if there is no connection, or the other end is not trusted; the exception's class and message say why
     */
    static TlsTransport connect(String port, TcpAddress address, TlsFolder folder, LineSettings line, int limitMillis)
            throws PortException {
        try {
            TlsConnector connector =
                    new TlsConnector(port, address, folder, limitMillis); // reads the files before connecting
            Socket plain = TcpConnector.connect(port, address);
            try {
                return connector.secure(plain, line);
            } catch (IOException | GeneralSecurityException | InterruptedException e) {
                plain.close();
                throw e;
            }
        } catch (PortException e) {
            throw e;
        } catch (IOException | GeneralSecurityException e) {
            throw new PortFaultException(port, "port " + port + " cannot be opened: " + e.getMessage(), e);
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(port);
        }
    }

    private TlsTransport secure(Socket plain, LineSettings line)
            throws IOException, GeneralSecurityException, InterruptedException {
        plain.setSoTimeout(limitMillis);
        SSLSocket socket =
                (SSLSocket) context.getSocketFactory().createSocket(plain, address.host(), address.number(), true);
        try {
            BlockingCall.start("greet " + address, () -> {
                        socket.startHandshake();
                        return socket;
                    })
                    .get();
        } catch (ExecutionException e) {
            throw refusal(e.getCause());
        }
        PushbackInputStream in = new PushbackInputStream(socket.getInputStream());
        if (own.isAskedFor()) {
            awaitRefusal(socket, in);
        }
        board.pin(port);
        return new TlsTransport(socket, in, plain, port, line, this::broken);
    }

    private void awaitRefusal(SSLSocket socket, PushbackInputStream in) throws IOException {
        socket.setSoTimeout(REFUSAL_MILLIS);
        try {
            int first = in.read();
            if (first < 0) {
                throw new IOException(refusedByBoard("it closed the connection"));
            }
            in.unread(first);
        } catch (SocketTimeoutException e) {
            // the board accepts the certificate, or needs none
        } catch (SSLException e) {
            throw refusal(e);
        }
    }

    private IOException refusal(Throwable cause) {
        for (Throwable each = cause; each != null; each = each.getCause()) {
            if (each instanceof java.security.cert.CertificateException) {
                return new IOException(each.getMessage(), cause);
            }
        }
        if (cause instanceof SocketTimeoutException) {
            return new IOException(
                    address + " did not begin TLS within " + limitMillis + " ms; is " + plainPort() + " meant?", cause);
        }
        if (own.isAskedFor()) {
            return new IOException(refusedByBoard(String.valueOf(cause.getMessage())), cause);
        }
        if (board.shown() == null) {
            return new IOException(
                    address + " does not answer as TLS does (" + cause.getMessage() + "); is " + plainPort()
                            + " meant?",
                    cause);
        }
        return new IOException("the TLS handshake with " + address + " failed: " + cause.getMessage(), cause);
    }

    private String plainPort() {
        return "tcp:" + address.canonical() + ", without TLS,";
    }

    private String refusedByBoard(String reason) {
        return own.isPresent()
                ? "the board does not accept this computer's certificate, " + folder.computerFile() + " (" + reason
                        + "); make that one known to the board, or put one there that it knows"
                : "the board asks for a certificate of this computer (" + reason
                        + "), and there is none; put one that the board knows into " + folder.computerFile()
                        + ", and its key beside it into computer.key";
    }

    private String broken(IOException e) {
        return e instanceof SSLException && own.isAskedFor()
                ? refusedByBoard(e.getMessage())
                : "the connection broke (" + e.getMessage() + ")";
    }
}
