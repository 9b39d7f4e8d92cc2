package javino.tcp;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NoRouteToHostException;
import java.net.SocketTimeoutException;
import java.net.StandardSocketOptions;
import java.net.UnknownHostException;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import javino.NoSuchPortException;
import javino.PortException;
import javino.PortFaultException;
import javino.PortInterruptedException;
import jdk.net.ExtendedSocketOptions;

/** Connects to a board on the network, with a time limit, and says to a person why it could not. An interrupt ends the wait. */
final class TcpConnector {
    /** For the lookup of the host, and for connecting to all its addresses together; a local network needs a few. */
    static final int LIMIT_MILLIS = 3_000;

    private static final long NANOS_PER_MILLI = 1_000_000L;
    /** What is written but not yet taken by the far end; as little as the system allows, so that no command waits behind old ones for long. */
    private static final int SEND_BUFFER = 4_096;
    /** What has come but not been read; little, so that a board that talks all the time cannot fill it with what is old by then. */
    private static final int RECEIVE_BUFFER = 32_768;
    // a far end that vanished without a word is noticed on a line that rests in some seven seconds
    private static final int KEEPALIVE_IDLE_SECONDS = 2;
    private static final int KEEPALIVE_INTERVAL_SECONDS = 1;
    private static final int KEEPALIVE_PROBES = 5;

    private TcpConnector() {}

    /**
     * @param port as it was given, for messages
     * @return a connected channel that does not block
     * @throws NoSuchPortException if there is no such host, or nothing answers there
     * @throws PortFaultException if the system refuses for another reason
     */
    static SocketChannel connect(String port, TcpAddress address) throws PortException {
        long deadline = System.nanoTime() + LIMIT_MILLIS * NANOS_PER_MILLI;
        try {
            InetAddress[] hosts = HostLookup.addresses(address.host(), LIMIT_MILLIS * NANOS_PER_MILLI, InetAddress::getAllByName);
            IOException first = null;
            for (int i = 0; i < hosts.length; i++) {
                long left = Math.max(NANOS_PER_MILLI, deadline - System.nanoTime());
                try {
                    return connect(port, new InetSocketAddress(hosts[i], address.number()), left / (hosts.length - i));
                } catch (IOException e) {
                    first = first == null ? e : first;
                }
            }
            throw first == null ? new UnknownHostException("the host " + address.host() + " has no address") : first;
        } catch (IOException e) {
            throw refusal(port, address, e);
        }
    }

    private static SocketChannel connect(String port, InetSocketAddress place, long limitNanos) throws IOException {
        SocketChannel channel = SocketChannel.open();
        boolean connected = false;
        try {
            channel.configureBlocking(false);
            configure(channel);
            connected = channel.connect(place) || finish(port, channel, limitNanos);
            return channel;
        } finally {
            if (!connected) {
                channel.close();
            }
        }
    }

    private static boolean finish(String port, SocketChannel channel, long limitNanos) throws IOException {
        long deadline = System.nanoTime() + limitNanos;
        try (Readiness connectable = new Readiness(channel, SelectionKey.OP_CONNECT)) {
            while (!channel.finishConnect()) {
                long left = deadline - System.nanoTime();
                if (left <= 0) {
                    throw new SocketTimeoutException();
                }
                connectable.await(left);
                if (Thread.currentThread().isInterrupted()) {
                    throw new PortInterruptedException(port);
                }
            }
            return true;
        }
    }

    private static void configure(SocketChannel channel) throws IOException {
        channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
        channel.setOption(StandardSocketOptions.SO_SNDBUF, SEND_BUFFER);
        channel.setOption(StandardSocketOptions.SO_RCVBUF, RECEIVE_BUFFER);
        channel.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
        if (channel.supportedOptions().contains(ExtendedSocketOptions.TCP_KEEPIDLE)) { // not on every system
            channel.setOption(ExtendedSocketOptions.TCP_KEEPIDLE, KEEPALIVE_IDLE_SECONDS);
            channel.setOption(ExtendedSocketOptions.TCP_KEEPINTERVAL, KEEPALIVE_INTERVAL_SECONDS);
            channel.setOption(ExtendedSocketOptions.TCP_KEEPCOUNT, KEEPALIVE_PROBES);
        }
    }

    private static PortException refusal(String port, TcpAddress address, IOException cause) {
        if (cause instanceof PortException known) {
            return known;
        }
        if (Thread.currentThread().isInterrupted()) {
            return new PortInterruptedException(port);
        }
        String start = "port " + port + " cannot be opened: ";
        if (cause instanceof UnknownHostException) {
            return new NoSuchPortException(port, start + cause.getMessage());
        }
        if (cause instanceof SocketTimeoutException) {
            return new NoSuchPortException(port, start + address + " did not answer within " + LIMIT_MILLIS
                    + " ms; is the board on, and in this network?");
        }
        if (cause instanceof NoRouteToHostException || isUnreachable(cause)) {
            return new NoSuchPortException(port, start + address.host() + " cannot be reached; is the board on, and in this network?");
        }
        if (cause instanceof ConnectException) {
            return new NoSuchPortException(port, start + "nothing listens at " + address + "; does the board's program run, and is " + address.number()
                    + " its port?");
        }
        return new PortFaultException(port, start + "the system says \"" + cause.getMessage() + '"', cause);
    }

    private static boolean isUnreachable(IOException cause) {
        return cause.getMessage() != null && cause.getMessage().contains("unreachable");
    }
}
