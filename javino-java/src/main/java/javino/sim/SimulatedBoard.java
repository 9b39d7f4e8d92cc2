package javino.sim;

import java.util.Locale;
import javino.PortException;
import javino.Transport;

/**
 * A board that is a program: {@code sim:robot} in place of a device.
 *
 * <p>{@link java.util.ServiceLoader} finds boards: public classes with a public constructor without arguments, named in
 * {@code META-INF/services/javino.sim.SimulatedBoard}. {@link SimulatedBoards#plugIn} plugs others in at run time.
 */
@FunctionalInterface
public interface SimulatedBoard {
    /**
     * Runs the board's program from the opening of its port until {@code line} is gone, like a sketch from reset.
     *
     * <p>Runs on a thread of its own, never twice at a time for one plugged board. Bytes take their time at the port's rate,
     * {@code line.line().baud()}. When the port is closed and all earlier bytes have been read, calls on {@code line} throw
     * {@link javino.PortGoneException}; let it through. The thread is interrupted if the board is unplugged, or if the port is opened again
     * before this method has returned. When this method returns, the port is gone for its owner. The owner gets any other exception.
     */
    void run(Transport line) throws PortException, InterruptedException;

    /** The name behind {@code sim:} of a board found as a service. By default, its class's name in lower case. */
    default String name() {
        return getClass().getSimpleName().toLowerCase(Locale.ROOT);
    }
}
