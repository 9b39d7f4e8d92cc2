package javino;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;

/** Sends commands to a version 1 board, which acknowledges nothing: a command has arrived when its last byte has left. */
final class OneWaySender {
    /** The longest time for which the device may be gone unnoticed while a long message leaves. */
    private static final long WATCH_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    private static final System.Logger LOG = System.getLogger(OneWaySender.class.getName());

    private final String port;
    private final FrameWriter writer;
    private final Inbox inbox;
    private final LineClock clock;
    private final AtomicBoolean hasWarned = new AtomicBoolean();

    OneWaySender(String port, FrameWriter writer, Inbox inbox, LineClock clock) {
        this.port = port;
        this.writer = writer;
        this.inbox = inbox;
        this.clock = clock;
    }

    /** Writes the command whose turn has come; returns when its last byte leaves. */
    long write(Command command) throws PortException {
        return write(command, FrameWriter.PATIENCE_MILLIS);
    }

    /** Writes the command like {@link #write(Command)}, on a thread that may not wait. */
    long writeAtOnce(Command command) throws PortException {
        return write(command, 0);
    }

    private long write(Command command, int timeoutMillis) throws PortException {
        Frame frame = command.frame();
        if (writer.isBoardSlow() && !hasWarned.getAndSet(true)) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "the board at port " + port + " begins its answers more than " + LoopTime.MAX_MILLIS
                            + " ms late: a board of version 1 loses commands that come while its loop() does something else;"
                            + " give the port the option spacing(Ms) with the longest time of a loop(), or use version 2");
        }
        return writer.writeNow(FrameWriter.Kind.ACTION, timeoutMillis, () -> {
            if (command.rule() != null) {
                throw new ActionRefusedException(
                        port, "the board at port " + port + " speaks version 1, in which it takes no rules");
            }
            inbox.sends(frame);
            return frame.toBytes();
        });
    }

    /** Waits until the last byte of a command leaves, at {@code left}, or it is over. */
    void awaitLeft(Command command, long left) throws PortException {
        while (!command.isOver() && left - clock.nanos() > WATCH_NANOS) { // the reader may be waiting for its turn
            writer.awaitTime(clock.nanos() + WATCH_NANOS);
            inbox.look();
        }
        if (!command.isOver()) {
            writer.awaitTime(left);
        }
    }
}
