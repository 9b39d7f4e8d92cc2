package javino.tcp;

import java.util.Locale;
import javino.NoSuchPortException;

/**
 * Where a board or a serial server listens: {@code //robot.local:4000}, with an IPv6 address in brackets, {@code //[fe80::1]:4000}.
 *
 * @param host its name or address, without brackets
 * @param number the number of its TCP port, 1 to 65535
 */
record TcpAddress(String host, int number) {
    private static final String FORM = "a port on the network is tcp://HOST:PORT, as tcp://192.168.1.20:4000";
    private static final int MOST_NUMBER = 65_535;

    /**
     * @param port as it was given, for messages
     * @param address what stands behind the scheme; the two slashes may be missing
     */
    static TcpAddress of(String port, String address) throws NoSuchPortException {
        String place = address.startsWith("//") ? address.substring(2) : address;
        place = place.endsWith("/") ? place.substring(0, place.length() - 1) : place;
        int colon = place.lastIndexOf(':');
        if (colon < 0 || colon < place.lastIndexOf(']')) {
            throw malformed(port, "its port number is missing");
        }
        return new TcpAddress(host(port, place.substring(0, colon)), number(port, place.substring(colon + 1)));
    }

    private static String host(String port, String written) throws NoSuchPortException {
        boolean inBrackets = written.startsWith("[") && written.endsWith("]");
        String host = inBrackets ? written.substring(1, written.length() - 1) : written;
        if (host.isBlank()) {
            throw malformed(port, "its host is missing");
        }
        if (!inBrackets && host.contains(":")) {
            throw malformed(port, "an IPv6 address is written in brackets, as tcp://[fe80::1]:4000");
        }
        if (host.matches(".*[\\s/?#@\\[\\]].*")) {
            throw malformed(port, "\"" + host + "\" is no host's name");
        }
        return host;
    }

    private static int number(String port, String written) throws NoSuchPortException {
        if (written.isEmpty()) {
            throw malformed(port, "its port number is missing");
        }
        int number = written.matches("[0-9]{1,5}") ? Integer.parseInt(written) : 0;
        if (number < 1 || number > MOST_NUMBER) {
            throw malformed(port, "\"" + written + "\" is no port number; that is 1 to " + MOST_NUMBER);
        }
        return number;
    }

    private static NoSuchPortException malformed(String port, String why) {
        return new NoSuchPortException(port, "\"" + port + "\" names no port: " + why + " (" + FORM + ")");
    }

    /** The same for all spellings of one place; the host is not looked up. */
    String canonical() {
        return "//" + this;
    }

    @Override
    public String toString() {
        String name = host.toLowerCase(Locale.ROOT);
        return (name.contains(":") ? "[" + name + "]" : name) + ":" + number;
    }
}
