package javino.sim;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.stream.Collectors;
import javino.LineSettings;
import javino.NoSuchPortException;
import javino.PortException;
import javino.Services;
import javino.Transport;

/**
 * The simulated boards of this program, by name. The first search for a name plugs in each board that is found as a service. All methods
 * are safe on any thread.
 */
public final class SimulatedBoards {
    /** The scheme of the ports of simulated boards. */
    public static final String SCHEME = "sim";

    private static final Map<String, PluggedBoard> SOCKETS = new ConcurrentSkipListMap<>();
    private static final Set<Class<?>> SERVICES_SEEN = new HashSet<>(); // guarded by this class

    private SimulatedBoards() {}

    /**
     * Makes a board available as {@code sim:name}.
     *
     * @throws IllegalArgumentException if the name is blank
     * @throws IllegalStateException if another board with this name is plugged in
     */
    public static void plugIn(String name, SimulatedBoard board) {
        if (name.isBlank()) {
            throw new IllegalArgumentException("a simulated board needs a name");
        }
        PluggedBoard other = SOCKETS.putIfAbsent(name, new PluggedBoard(portName(name), board));
        if (other != null) {
            throw new IllegalStateException("a board " + portName(name) + " is plugged in already; unplug it first");
        }
    }

    /**
     * Removes a board. If the board's port is open, the line is gone for both ends.
     *
     * @return whether there was a board with this name
     */
    public static boolean unplug(String name) {
        PluggedBoard socket = SOCKETS.remove(name);
        if (socket == null) {
            return false;
        }
        socket.unplug();
        return true;
    }

    /** Returns the names of the boards in alphabetical order, without the scheme. */
    public static List<String> names() {
        plugInServices();
        return List.copyOf(SOCKETS.keySet());
    }

    /** Returns whether the program of the board with this name runs, or is about to run. */
    static boolean isRunning(String name) {
        PluggedBoard socket = SOCKETS.get(name);
        return socket != null && socket.isRunning();
    }

    static Transport open(String name, LineSettings line) throws PortException {
        plugInServices();
        PluggedBoard socket = SOCKETS.get(name);
        if (socket == null) {
            throw new NoSuchPortException(
                    portName(name), "there is no simulated board " + portName(name) + "; " + present(names()));
        }
        return socket.open(line);
    }

    private static String present(List<String> names) {
        return names.isEmpty()
                ? "none is plugged in (plug one in with SimulatedBoards.plugIn, or name its class in META-INF/services/"
                        + SimulatedBoard.class.getName() + ")"
                : names.stream().map(SimulatedBoards::portName).collect(Collectors.joining(", ", "there are: ", ""));
    }

    private static String portName(String name) {
        return SCHEME + ':' + name;
    }

    private static void plugInService(SimulatedBoard board) {
        PluggedBoard other = SOCKETS.putIfAbsent(board.name(), new PluggedBoard(portName(board.name()), board));
        if (other != null) {
            Services.leftOut(board.getClass(), portName(board.name()), other.boardClass());
        }
    }

    private static synchronized void plugInServices() {
        for (ServiceLoader.Provider<SimulatedBoard> service : Services.providers(SimulatedBoard.class)) {
            if (SERVICES_SEEN.add(service.type())) {
                SimulatedBoard board = Services.make(service);
                if (board != null) {
                    plugInService(board);
                }
            }
        }
    }
}
