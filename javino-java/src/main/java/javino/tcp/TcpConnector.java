package javino.tcp;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NoRouteToHostException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.StandardSocketOptions;
import java.net.UnknownHostException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import javino.NoSuchPortException;
import javino.PortException;
import javino.PortFaultException;
import javino.PortInterruptedException;
import jdk.net.ExtendedSocketOptions;

/** Connects to a board on the network, with a time limit. An interrupt ends the wait. */
final class TcpConnector {
    /**
     * The time limit for looking the host up, and again for connecting. In a local network, the look-up and the connection take a few
     * milliseconds each.
     */
    static final int LIMIT_MILLIS = 3_000;

    /** Room for bytes that the far end has not taken. A small buffer keeps commands from waiting behind old commands. */
    private static final int SEND_BUFFER = 4_096;
    /** Room for unread bytes. A small buffer keeps outdated messages from piling up. */
    private static final int RECEIVE_BUFFER = 32_768;
    // on an idle line, the system notices a vanished far end within about seven seconds
    private static final int KEEPALIVE_IDLE_SECONDS = 2;
    private static final int KEEPALIVE_INTERVAL_SECONDS = 1;
    private static final int KEEPALIVE_PROBES = 5;

    private TcpConnector() {}

    /**
     * @throws NoSuchPortException if there is no such host, or if nothing answers
     * @throws PortFaultException if the system refuses for another reason
     */
    static Socket connect(String port, TcpAddress address) throws PortException {
        long limit = TimeUnit.MILLISECONDS.toNanos(LIMIT_MILLIS);
        long deadline = System.nanoTime() + limit;
        try {
            InetAddress[] hosts =
                    HostLookup.addresses(address.host(), limit, () -> InetAddress.getAllByName(address.host()));
            IOException first = new UnknownHostException("the host " + address.host() + " has no address");
            for (int i = 0; i < hosts.length; i++) {
                long left = TimeUnit.NANOSECONDS.toMillis(deadline - System.nanoTime()) / (hosts.length - i);
                try {
                    return connect(new InetSocketAddress(hosts[i], address.number()), (int) Math.max(1, left));
                } catch (IOException e) {
                    first = i == 0 ? e : first;
                }
            }
            throw first;
        } catch (IOException e) {
            throw refusal(port, address, e);
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(port);
        }
    }

    /** Connects. The system's call cannot be interrupted, so an interrupt closes the socket and so ends the call. */
    private static Socket connect(InetSocketAddress place, int timeoutMillis) throws IOException, InterruptedException {
        Socket socket = new Socket();
        try {
            configure(socket);
            return BlockingCall.start("connect " + place, () -> {
                        socket.connect(place, timeoutMillis);
                        return socket;
                    })
                    .get();
        } catch (IOException | InterruptedException e) {
            socket.close();
            throw e;
        } catch (ExecutionException e) {
            socket.close();
            throw e.getCause() instanceof IOException cause ? cause : new IOException(e.getCause());
        }
    }

    private static void configure(Socket socket) throws IOException {
        socket.setTcpNoDelay(true);
        socket.setSendBufferSize(SEND_BUFFER);
        socket.setReceiveBufferSize(RECEIVE_BUFFER);
        socket.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
        if (socket.supportedOptions().contains(ExtendedSocketOptions.TCP_KEEPIDLE)) { // not on every system
            socket.setOption(ExtendedSocketOptions.TCP_KEEPIDLE, KEEPALIVE_IDLE_SECONDS);
            socket.setOption(ExtendedSocketOptions.TCP_KEEPINTERVAL, KEEPALIVE_INTERVAL_SECONDS);
            socket.setOption(ExtendedSocketOptions.TCP_KEEPCOUNT, KEEPALIVE_PROBES);
        }
    }

    private static PortException refusal(String port, TcpAddress address, IOException cause) {
        String start = "port " + port + " cannot be opened: ";
        if (cause instanceof UnknownHostException) {
            return new NoSuchPortException(port, start + cause.getMessage());
        }
        if (cause instanceof SocketTimeoutException) {
            return new NoSuchPortException(
                    port,
                    start + address + " did not answer within " + LIMIT_MILLIS
                            + " ms; is the board on, and in this network?");
        }
        if (cause instanceof NoRouteToHostException
                || String.valueOf(cause.getMessage()).contains("unreachable")) {
            return new NoSuchPortException(
                    port, start + address.host() + " cannot be reached; is the board on, and in this network?");
        }
        if (cause instanceof ConnectException) {
            return new NoSuchPortException(
                    port,
                    start + "nothing listens at " + address + "; does the board's program run, and is "
                            + address.number() + " its port?");
        }
        return new PortFaultException(port, start + "the system reports \"" + cause.getMessage() + '"', cause);
    }
}
