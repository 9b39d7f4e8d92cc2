package javino.tcp;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javino.NoSuchPortException;

/**
 * The address of a board or a serial server: {@code //robot.local:4000}. An IPv6 address stands in brackets: {@code //[fe80::1]:4000}.
 *
 * @param host the host's name or address, without brackets
 * @param number the TCP port number, 1 to 65535
 */
record TcpAddress(String host, int number) {
    private static final int MAX_NUMBER = 65_535;
    // java.net.URI rejects host names with an underscore
    private static final Pattern FORM =
            Pattern.compile("(?://)?(?:\\[([^\\]\\s]+)]|([^\\[\\]\\s:/?#@]*))(?::([^:/\\]]*))?/?");

    static TcpAddress of(String port, String address) throws NoSuchPortException {
        Matcher form = FORM.matcher(address);
        if (!form.matches()) {
            throw malformed(
                    port, "that is no host's name; an IPv6 address is written in brackets, as //[fe80::1]:4000");
        }
        String host = form.group(1) != null ? form.group(1) : form.group(2);
        String number = form.group(3);
        if (number == null || number.isEmpty()) {
            throw malformed(port, "its port number is missing");
        }
        if (host.isEmpty()) {
            throw malformed(port, "its host is missing");
        }
        int value = number.matches("[0-9]{1,5}") ? Integer.parseInt(number) : 0;
        if (value < 1 || value > MAX_NUMBER) {
            throw malformed(port, "\"" + number + "\" is no port number; that is 1 to " + MAX_NUMBER);
        }
        return new TcpAddress(host, value);
    }

    private static NoSuchPortException malformed(String port, String why) {
        String scheme = port.startsWith("tls") ? "tls" : "tcp";
        return new NoSuchPortException(
                port,
                "\"" + port + "\" names no port: " + why + " (a port on the network is " + scheme + "://HOST:PORT, as "
                        + scheme + "://192.168.1.20:4000)");
    }

    /** Returns one text for all spellings of the address. Does not look the host up. */
    String canonical() {
        return "//" + this;
    }

    @Override
    public String toString() {
        String name = host.toLowerCase(Locale.ROOT);
        return (name.contains(":") ? "[" + name + "]" : name) + ":" + number;
    }
}
