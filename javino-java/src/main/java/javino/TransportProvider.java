package javino;

import java.util.List;

/**
 * Opens transports of one kind. Programs add kinds of their own through {@link java.util.ServiceLoader}: a class with a public
 * constructor without arguments, named in {@code META-INF/services/javino.TransportProvider}.
 *
 * <p>A port is written {@code scheme:address}; {@link Transports} hands what follows the colon to the provider of that scheme.
 * Providers are called from any thread.
 */
public interface TransportProvider {
    /** The scheme, two or more letters, digits, {@code +}, {@code .} or {@code -}, the first a letter: {@code sim}. */
    String scheme();

    /**
     * Opens the port at {@code address}.
     *
     * @param address the text behind {@code scheme:}, not blank
     * @throws PortException of the kind that says why it cannot be opened
     */
    Transport open(String address, LineSettings line) throws PortException;

    /** The port's name with its scheme, for messages. */
    default String port(String address) {
        return scheme() + ':' + address;
    }

    /** The ports there are now, as a person would give them to {@link Transports#open}; by default none, as when they cannot be listed. */
    default List<String> ports() {
        return List.of();
    }

    /**
     * Returns one address for all the addresses of one device, so that a device under two names still has one owner.
     *
     * @return {@code address} itself, unless the provider knows better
     */
    default String canonicalAddress(String address) {
        return address;
    }

    /**
     * Returns one name for all the names of one device, whatever their schemes: a provider that finds devices of another provider
     * gives the name which that one gives.
     *
     * @return the scheme and the {@linkplain #canonicalAddress canonical address}, unless the provider knows better
     */
    default String canonicalName(String address) {
        return port(canonicalAddress(address));
    }

    /**
     * Returns whether there is something that {@link #open} could open now. Called again and again for a device that has gone, so it is
     * cheap, and opens nothing.
     *
     * @return true also where only opening it can tell, as by default
     */
    default boolean isPresent(String address) {
        return true;
    }

    /** The line to ask for if the rate of the board is not given: 9600 baud, unless ports of this kind have another. */
    default LineSettings usualLine() {
        return LineSettings.defaults();
    }
}
