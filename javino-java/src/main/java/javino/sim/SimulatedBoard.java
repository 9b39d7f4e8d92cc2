package javino.sim;

import java.util.Locale;
import java.util.Optional;
import javino.PortException;
import javino.Transport;

/**
 * A program in place of a board, at a port such as {@code sim:robot}.
 *
 * <p>{@link java.util.ServiceLoader} finds boards. Such a board is a public class with a public constructor without arguments, named in
 * {@code META-INF/services/javino.sim.SimulatedBoard}. {@link SimulatedBoards#plugIn} adds other boards at run time.
 */
@FunctionalInterface
public interface SimulatedBoard {
    /**
     * Runs the board's program from the opening of its port until {@code line} is gone.
     *
     * <p>Runs on its own thread. A board never runs twice at a time. Bytes take their time at the port's rate,
     * {@code line.line().baud()}. If the port is closed and all earlier bytes have been read, calls on {@code line} throw
     * {@link javino.PortGoneException}. Do not catch this exception. The thread is interrupted if the board is unplugged, or if the port
     * is opened again before this method has returned. When this method returns or throws, the port is gone for its owner. The owner's
     * exception names the cause.
     */
    void run(Transport line) throws PortException, InterruptedException;

    /** Returns the name of a board that is found as a service, without {@code sim:}. By default the name of its class in lower case. */
    default String name() {
        return getClass().getSimpleName().toLowerCase(Locale.ROOT);
    }

    /** Returns a hint for a person if the board does not answer a request; empty: the usual {@link Transport#doubt}. */
    default Optional<String> doubt() {
        return Optional.empty();
    }
}
