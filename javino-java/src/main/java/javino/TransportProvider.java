package javino;

import java.util.List;

/**
 * Opens transports of one kind. Programs add other kinds through {@link java.util.ServiceLoader}: a class with a public constructor without
 * arguments, named in {@code META-INF/services/javino.TransportProvider}.
 *
 * <p>A port is written {@code scheme:address}; {@link Transports} hands the text behind the colon to the provider of the scheme. Providers
 * are called from any thread.
 */
public interface TransportProvider {
    /** The scheme, two or more letters, digits, {@code +}, {@code .} or {@code -}, the first a letter: {@code sim}. */
    String scheme();

    /**
     * Opens the port at {@code address}.
     *
     * @param address the text behind {@code scheme:}, not blank
     * @throws PortException if the port cannot be opened; its class and its message say why
     */
    Transport open(String address, LineSettings line) throws PortException;

    /** The port's name with its scheme, for messages. */
    default String port(String address) {
        return scheme() + ':' + address;
    }

    /** The names of the present ports, as {@link Transports#open} takes them; none if ports cannot be listed, as by default. */
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
     * Returns one name for all the names of one device, whatever their schemes. If the device belongs to another provider, returns that
     * provider's name for the device.
     *
     * @return the scheme and the {@linkplain #canonicalAddress canonical address}, unless the provider knows better
     */
    default String canonicalName(String address) {
        return port(canonicalAddress(address));
    }

    /**
     * Returns whether {@link #open} would find something to open. Callers ask this again and again while a device is missing, so this
     * method is cheap and opens nothing.
     *
     * @return true also if only {@link #open} could find out, as by default
     */
    default boolean isPresent(String address) {
        return true;
    }

    /** The settings for opening a port if no rate is given. By default 9600 baud. */
    default LineSettings usualLine() {
        return LineSettings.defaults();
    }
}
