package javino;

import java.util.List;

/**
 * Opens transports of one kind. {@link java.util.ServiceLoader} finds providers. A provider is a class with a public constructor without
 * arguments, named in {@code META-INF/services/javino.TransportProvider}.
 *
 * <p>A port is written {@code scheme:address}. {@link Transports} passes the address to the provider of the scheme. Any thread may call a
 * provider.
 */
public interface TransportProvider {
    /**
     * Returns the scheme, such as {@code sim}. A scheme begins with a letter and has two or more letters, digits, {@code +}, {@code .} or
     * {@code -}.
     */
    String scheme();

    /**
     * Opens the port at {@code address}.
     *
     * @param address the text after {@code scheme:}, not blank
     * @throws PortException if the port cannot be opened; the exception's class and message say why
     */
    Transport open(String address, LineSettings line) throws PortException;

    /** Returns the port's name with its scheme, for messages. */
    default String port(String address) {
        return scheme() + ':' + address;
    }

    /** Returns the names of the present ports, for {@link Transports#open}. By default, or if ports cannot be listed, the list is empty. */
    default List<String> ports() {
        return List.of();
    }

    /**
     * Returns one name for all the names of one device, even names with other schemes. A device with two names then has one owner. If the
     * device belongs to another provider, returns that provider's name for the device.
     *
     * @return by default the name from {@link #port}
     */
    default String canonicalName(String address) {
        return port(address);
    }

    /**
     * Returns whether {@link #open} would find a device. Callers ask repeatedly while a device is missing, so this method must be cheap
     * and open nothing.
     *
     * @return true also if only {@link #open} could find out. By default true
     */
    default boolean isPresent(String address) {
        return true;
    }

    /** Returns the settings for a port that is opened without a baud rate. By default 9600 baud. */
    default LineSettings usualLine() {
        return LineSettings.defaults();
    }
}
