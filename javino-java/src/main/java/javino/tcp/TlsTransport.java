package javino.tcp;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import javax.net.ssl.SSLSocket;
import javino.LineSettings;

final class TlsTransport extends TcpTransport {
    /** The time limit for ending TLS, because the far end may have stopped reading. */
    private static final int FAREWELL_MILLIS = 100;

    private final SSLSocket socket;
    private final Socket plain;
    private final Function<IOException, String> broken;

    /**
     * @param socket a socket over {@code plain} after its handshake. This transport owns both sockets
     * @param broken returns the reason of the loss for an exception of a read or a write
     */
    TlsTransport(
            SSLSocket socket,
            InputStream in,
            Socket plain,
            String name,
            LineSettings line,
            Function<IOException, String> broken) {
        super(socket, in, name, line);
        this.socket = socket;
        this.plain = plain;
        this.broken = broken;
    }

    @Override
    boolean isInputPlain() {
        return false; // arrived bytes may still be encrypted
    }

    @Override
    String broken(IOException e) {
        return broken.apply(e);
    }

    @Override
    protected void closeDriver() {
        try (plain) {
            if (!isLost()) {
                sayFarewell();
                drain(plain, plain.getInputStream()); // even after a failed farewell, so earlier bytes arrive
            }
        } catch (IOException e) {
            noteHaste(e);
        }
    }

    /** Ends TLS, which needs the TLS socket's lock. If a waiting write holds the lock, closing the TCP socket ends that write. */
    private void sayFarewell() {
        try {
            BlockingCall.start("close " + name(), () -> {
                        socket.shutdownOutput();
                        return null;
                    })
                    .get(FAREWELL_MILLIS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (ExecutionException | TimeoutException e) {
            noteHaste(e);
        }
    }

    private void noteHaste(Exception reason) {
        System.getLogger(TlsTransport.class.getName())
                .log(System.Logger.Level.DEBUG, "port " + name() + " was closed without a farewell", reason);
    }
}
