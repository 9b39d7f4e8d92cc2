package javino.link;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javino.PortBusyException;
import javino.PortException;
import javino.PortInterruptedException;
import javino.Transports;

/** The owners of all ports of this program, by {@linkplain Transports#canonicalName canonical name}. */
final class PortOwners {
    private static final Map<String, Claim> CLAIMS = new ConcurrentHashMap<>();

    /** The longest wait for an owner that is giving a port back. A driver may take seconds to close a port. */
    private static final int PATIENCE_MILLIS = 5_000;

    private PortOwners() {}

    static final class Claim {
        private final String canonicalName;
        private final String owner;
        private final CountDownLatch released = new CountDownLatch(1);
        private volatile boolean isLeaving;

        private Claim(String canonicalName, String owner) {
            this.canonicalName = canonicalName;
            this.owner = owner;
        }

        /** Records that the owner is about to give the port back. The next owner then waits for the port. Idempotent. */
        void leave() {
            isLeaving = true;
        }

        void release() {
            CLAIMS.remove(canonicalName, this);
            released.countDown();
        }

        private boolean isReleasedBefore(long endNanos) throws InterruptedException {
            return isLeaving && released.await(endNanos - System.nanoTime(), TimeUnit.NANOSECONDS);
        }
    }

    /** Returns a claim to a line that is no port of this machine. The claim excludes nobody. */
    static Claim nobodys(String line) {
        return new Claim(line, "nobody");
    }

    static Claim claim(String port, String owner) throws PortException {
        Claim claim = new Claim(Transports.canonicalName(port), owner);
        long endNanos = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(PATIENCE_MILLIS);
        try {
            while (true) {
                Claim other = CLAIMS.putIfAbsent(claim.canonicalName, claim);
                if (other == null) {
                    return claim;
                }
                if (!other.isReleasedBefore(endNanos)) {
                    throw new PortBusyException(port, other.owner);
                }
            }
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(port);
        }
    }

    static Optional<String> ownerOf(String port) {
        return Optional.ofNullable(CLAIMS.get(Transports.canonicalName(port))).map(claim -> claim.owner);
    }
}
