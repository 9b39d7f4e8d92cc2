package javino;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Who has which port: one table for the program, as the devices of a machine are, by {@linkplain Transports#canonicalName canonical name}.
 */
final class PortOwners {
    private static final ReentrantLock TABLE = new ReentrantLock();
    private static final Map<String, Claim> CLAIMS = new HashMap<>();

    private PortOwners() {}

    /** One owner's hold on a port. */
    static final class Claim {
        private final String canonicalName;
        private final String owner;

        private Claim(String canonicalName, String owner) {
            this.canonicalName = canonicalName;
            this.owner = owner;
        }

        /** The port's name, the same under whatever name it was opened. */
        String canonicalName() {
            return canonicalName;
        }

        /** Gives the port back. Idempotent. */
        void release() {
            TABLE.lock();
            try {
                CLAIMS.remove(canonicalName, this);
            } finally {
                TABLE.unlock();
            }
        }
    }

    /** A hold on a line that is not a port of the machine, and so keeps nobody else out. */
    static Claim nobodys(String line) {
        return new Claim(line, "nobody");
    }

    /** Claims a port for {@code owner}. */
    static Claim claim(String port, String owner) throws PortBusyException {
        String canonicalName = Transports.canonicalName(port);
        TABLE.lock();
        try {
            Claim other = CLAIMS.get(canonicalName);
            if (other != null) {
                throw new PortBusyException(port, other.owner);
            }
            Claim claim = new Claim(canonicalName, owner);
            CLAIMS.put(canonicalName, claim);
            return claim;
        } finally {
            TABLE.unlock();
        }
    }

    static Optional<String> ownerOf(String port) {
        String canonicalName = Transports.canonicalName(port);
        TABLE.lock();
        try {
            return Optional.ofNullable(CLAIMS.get(canonicalName)).map(claim -> claim.owner);
        } finally {
            TABLE.unlock();
        }
    }
}
