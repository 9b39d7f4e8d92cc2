package javino.sim;

import java.util.concurrent.locks.ReentrantLock;
import javino.LineSettings;
import javino.NoSuchPortException;
import javino.PortBusyException;
import javino.PortException;
import javino.PortGoneException;
import javino.PortInterruptedException;
import javino.Transport;

/** Runs a simulated board's program while its port is open, one run at a time. */
final class PluggedBoard {
    private static final System.Logger LOG = System.getLogger(PluggedBoard.class.getName());
    private static final long LAST_RUN_MILLIS = 2_000;

    private final ReentrantLock opening = new ReentrantLock();
    private final String port;
    private final SimulatedBoard board;
    private volatile Run current; // the latest run, even if it has ended
    private volatile boolean unplugged;

    PluggedBoard(String port, SimulatedBoard board) {
        this.port = port;
        this.board = board;
    }

    Transport open(LineSettings settings) throws PortException {
        opening.lock();
        try {
            if (current != null) {
                requireOver(current);
            }
            MemoryLine line = MemoryLine.paced(port, settings, board.doubt().orElse(null));
            Run run = new Run(line, new Thread(() -> run(line), "board " + port));
            run.thread.setDaemon(true);
            current = run;
            if (unplugged) { // checked last, so unplug() cannot miss this run
                throw new NoSuchPortException(
                        port, "the simulated board " + port + " was unplugged while it was opened");
            }
            run.thread.start();
            return run.line.computer();
        } finally {
            opening.unlock();
        }
    }

    /** Ends the line of a running board. The board cannot be opened again. */
    void unplug() {
        unplugged = true;
        Run run = current;
        if (run != null) {
            run.line.unplug();
            run.thread.interrupt();
        }
    }

    Class<?> boardClass() {
        return board.getClass();
    }

    boolean isRunning() {
        Run run = current;
        return run != null && run.thread.isAlive();
    }

    private void run(MemoryLine line) {
        String end = "the board's program ended";
        try {
            board.run(line.board());
        } catch (PortGoneException | InterruptedException e) {
            end = "the board's program ended with its line"; // the usual end of a program
        } catch (PortException | RuntimeException | Error e) {
            LOG.log(System.Logger.Level.ERROR, "the program of " + port + " failed", e);
            end = "the board's program failed with " + e;
        } finally {
            line.closeBoard(end);
        }
    }

    private void requireOver(Run run) throws PortException {
        if (!run.line.isGone()) {
            throw new PortBusyException(port, "another part of this program");
        }
        run.thread.interrupt(); // the program has had time to read the last bytes
        try {
            run.thread.join(LAST_RUN_MILLIS);
        } catch (InterruptedException e) {
            throw PortInterruptedException.remarking(port);
        }
        if (run.thread.isAlive()) {
            throw new PortBusyException(
                    port,
                    "the board's own program, which still runs " + LAST_RUN_MILLIS
                            + " ms after its port was closed (it must end when its line is gone)");
        }
    }

    private record Run(MemoryLine line, Thread thread) {}
}
