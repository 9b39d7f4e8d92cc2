package javino;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.function.BiFunction;

/**
 * Opens ports by name. The {@link TransportProvider} of the scheme opens {@code scheme:address}. A name without a scheme is a serial
 * device.
 *
 * <p>{@link ServiceLoader} finds the providers. This library has {@code serial}, {@code usb}, {@code tcp}, {@code tls}, {@code sim} and
 * {@code replay}. Programs can add others, but cannot replace a provider of this library. All methods are safe on any thread.
 */
public final class Transports {
    /** The scheme of serial devices, for names without a written scheme. */
    public static final String SERIAL = "serial";

    private static final String OWN_PACKAGES = Transports.class.getPackageName() + '.';

    private Transports() {}

    /**
     * Opens {@code port}.
     *
     * @throws NoSuchPortException if the port or its scheme does not exist; the message lists the present ports or schemes
     * @throws PortBusyException if the port is open already
     * @throws PortPermissionException if this user may not open the port
     * @throws PortFaultException if the driver refuses for another reason
     */
    public static Transport open(String port, LineSettings line) throws PortException {
        PortName name = PortName.of(port);
        return provider(port, name).open(name.address(), line);
    }

    /** Returns the names of the present ports: serial devices, simulated boards, and the ports that other providers list. */
    public static List<String> ports() {
        List<String> ports = new ArrayList<>();
        providers().values().forEach(provider -> ports.addAll(provider.ports()));
        return List.copyOf(ports);
    }

    /**
     * Returns one name for all the names of one device. Follows symbolic links, replaces a USB identity with its present serial device,
     * and adds a missing scheme. The port and its scheme need not exist.
     */
    public static String canonicalName(String port) {
        return ask(port, TransportProvider::canonicalName, port); // an unknown scheme: the name stays as it is
    }

    /** Returns whether {@code port} is present, as far as {@link TransportProvider#isPresent} can tell without opening the port. */
    public static boolean isPresent(String port) {
        return ask(port, TransportProvider::isPresent, false);
    }

    /** Returns the settings for {@code port} if the caller gives no baud rate; see {@link TransportProvider#usualLine}. */
    public static LineSettings usualLine(String port) {
        return ask(port, (provider, address) -> provider.usualLine(), LineSettings.defaults());
    }

    private static <T> T ask(String port, BiFunction<TransportProvider, String, T> question, T ifNobodyKnows) {
        try {
            PortName name = PortName.of(port);
            return question.apply(provider(port, name), name.address());
        } catch (NoSuchPortException e) {
            return ifNobodyKnows;
        }
    }

    private static TransportProvider provider(String port, PortName name) throws NoSuchPortException {
        Map<String, TransportProvider> providers = providers();
        TransportProvider provider = providers.get(name.scheme());
        if (providers.isEmpty()) {
            throw new NoSuchPortException(
                    port,
                    "port " + port + " cannot be opened: no " + TransportProvider.class.getName()
                            + " was found, not even one for serial devices; does the program's jar hold META-INF/services,"
                            + " merged from all its libraries?");
        }
        if (provider == null) {
            throw new NoSuchPortException(
                    port,
                    "port " + port + " asks for the scheme \"" + name.scheme() + "\", but lines have only: "
                            + String.join(", ", providers.keySet()) + " (a serial device needs none)");
        }
        return provider;
    }

    private static Map<String, TransportProvider> providers() {
        List<ServiceLoader.Provider<TransportProvider>> services = Services.providers(TransportProvider.class);
        // this library's providers come first
        services.sort(Comparator.comparing(service -> !service.type().getName().startsWith(OWN_PACKAGES)));
        Map<String, TransportProvider> providers = new LinkedHashMap<>();
        for (ServiceLoader.Provider<TransportProvider> service : services) {
            TransportProvider found = Services.make(service);
            if (found != null) {
                TransportProvider other = providers.putIfAbsent(found.scheme(), found);
                if (other != null && !isSame(other, found)) {
                    Services.leftOut(found.getClass(), found.scheme(), other.getClass());
                }
            }
        }
        return providers;
    }

    /** Returns whether both providers have the same class name. Two class loaders may have loaded one class twice. */
    private static boolean isSame(TransportProvider one, TransportProvider other) {
        return one.getClass().getName().equals(other.getClass().getName());
    }
}
