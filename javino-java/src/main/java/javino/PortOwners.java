package javino;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The owners of ports: one table for the program, as the devices of a machine are, by {@linkplain Transports#canonicalName canonical name}.
 */
final class PortOwners {
    private static final Map<String, Claim> CLAIMS = new ConcurrentHashMap<>();

    private PortOwners() {}

    static final class Claim {
        private final String canonicalName;
        private final String owner;

        private Claim(String canonicalName, String owner) {
            this.canonicalName = canonicalName;
            this.owner = owner;
        }

        /** The port's canonical name, which does not depend on the name that it was opened under. */
        String canonicalName() {
            return canonicalName;
        }

        /** Gives the port back. Idempotent. */
        void release() {
            CLAIMS.remove(canonicalName, this);
        }
    }

    /** A hold on a line that is no port of the machine, and so excludes nobody. */
    static Claim nobodys(String line) {
        return new Claim(line, "nobody");
    }

    static Claim claim(String port, String owner) throws PortBusyException {
        Claim claim = new Claim(Transports.canonicalName(port), owner);
        Claim other = CLAIMS.putIfAbsent(claim.canonicalName, claim);
        if (other != null) {
            throw new PortBusyException(port, other.owner);
        }
        return claim;
    }

    static Optional<String> ownerOf(String port) {
        return Optional.ofNullable(CLAIMS.get(Transports.canonicalName(port))).map(claim -> claim.owner);
    }
}
