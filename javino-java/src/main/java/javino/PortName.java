package javino;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The scheme and the address of a port's name. The name {@code sim:robot} has the scheme {@code sim} and the address {@code robot}. A
 * name without a scheme is the address of a serial device.
 *
 * <p>A scheme has two letters or more, so {@code C:\dev} is a path. A scheme contains no slash, so a path may contain colons
 * ({@code /dev/serial/by-path/pci-0000:00}). The DOS name {@code COM8:} means {@code COM8}.
 */
record PortName(String scheme, String address) {
    private static final Pattern WITH_SCHEME = Pattern.compile("([A-Za-z][A-Za-z0-9+.-]+):(.*)", Pattern.DOTALL);
    private static final Pattern DOS_DEVICE = Pattern.compile("([A-Za-z]+[0-9]+):");

    static PortName of(String port) throws NoSuchPortException {
        String name = port.strip();
        Matcher dos = DOS_DEVICE.matcher(name);
        Matcher scheme = WITH_SCHEME.matcher(name);
        PortName parsed = dos.matches()
                ? new PortName(Transports.SERIAL, dos.group(1))
                : scheme.matches()
                        ? new PortName(
                                scheme.group(1).toLowerCase(Locale.ROOT),
                                scheme.group(2).strip())
                        : new PortName(Transports.SERIAL, name);
        if (parsed.address.isEmpty()) {
            throw new NoSuchPortException(port, "\"" + port + "\" names no port: an address is missing");
        }
        return parsed;
    }
}
