package javino.tcp;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Finds the addresses of a host, with a time limit. The system's lookup has no limit, cannot be interrupted, and may take a minute
 * without a network. The lookup therefore runs on its own thread. All callers that wait for a host share one lookup.
 */
final class HostLookup {
    private static final ConcurrentMap<String, Future<InetAddress[]>> UNDER_WAY = new ConcurrentHashMap<>();

    private HostLookup() {}

    /**
     * @param resolver finds the addresses, for example {@link InetAddress#getAllByName}
     * @throws UnknownHostException if there is no such host, or the lookup took longer than {@code limitNanos}; the message is for a
     *     person
     */
    static InetAddress[] addresses(String host, long limitNanos, Callable<InetAddress[]> resolver)
            throws UnknownHostException, InterruptedException {
        try {
            return UNDER_WAY
                    .computeIfAbsent(host, name -> start(name, resolver))
                    .get(limitNanos, TimeUnit.NANOSECONDS);
        } catch (ExecutionException e) {
            throw new UnknownHostException("there is no host " + host + " in this network, or its name is misspelt");
        } catch (TimeoutException e) {
            throw new UnknownHostException("the address of host " + host + " was not found within "
                    + TimeUnit.NANOSECONDS.toMillis(limitNanos) + " ms; does the network work?");
        }
    }

    private static Future<InetAddress[]> start(String host, Callable<InetAddress[]> resolver) {
        return BlockingCall.start("look up " + host, () -> {
            try {
                return resolver.call();
            } finally {
                UNDER_WAY.remove(host); // the next caller starts another lookup
            }
        });
    }
}
