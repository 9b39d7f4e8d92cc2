package javino.sim;

import java.util.Locale;
import javino.PortException;
import javino.Transport;

/**
 * A board that is a program: {@code sim:robot} in place of a device.
 *
 * <p>Boards are found through {@link java.util.ServiceLoader} (a public class with a public constructor without arguments, named in
 * {@code META-INF/services/javino.sim.SimulatedBoard}), or plugged in at run time with {@link SimulatedBoards#plugIn}.
 */
@FunctionalInterface
public interface SimulatedBoard {
    /**
     * Runs the board's program from the opening of its port, as a board runs a sketch from reset, until {@code line} is gone.
     *
     * <p>Runs on a thread of its own, never twice at a time for one plugged board. Bytes take their time at the rate the port was opened
     * with, {@code line.line().baud()}. When the port is closed, calls on {@code line} throw {@link javino.PortGoneException}, as soon as
     * all bytes sent before have been read; let that exception through. The thread is interrupted when the board is unplugged, or opened
     * again before this method has returned. When it returns, the port is gone for its owner. The owner is told of any other exception.
     *
     * @param line the board's end
     */
    void run(Transport line) throws PortException, InterruptedException;

    /** The name behind {@code sim:} of a board found as a service; unless overridden, its class's name in lower case. */
    default String name() {
        return getClass().getSimpleName().toLowerCase(Locale.ROOT);
    }
}
