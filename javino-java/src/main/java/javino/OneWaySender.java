package javino;

import java.util.concurrent.TimeUnit;

/** Sends commands to a version 1 board, which acknowledges nothing: a command has arrived when its last byte has left. */
final class OneWaySender implements CommandSender {
    /** How long the device may be gone before it is noticed while a long message leaves. */
    private static final long WATCH_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

    private final FrameWriter writer;
    private final Inbox inbox;
    private final RequestChannel channel;
    private final LineClock clock;

    OneWaySender(FrameWriter writer, Inbox inbox, RequestChannel channel, LineClock clock) {
        this.writer = writer;
        this.inbox = inbox;
        this.channel = channel;
        this.clock = clock;
    }

    @Override
    public void send(Command command) throws PortException {
        long left = writer.writeNow(FrameWriter.Kind.ACTION, command.frame(), MAX_WRITE_MILLIS, () -> {
            channel.awaitGap();
            inbox.sends(command.frame());
        });
        // who would read the line may be waiting for its turn
        while (!command.isOver() && left - clock.nanos() > WATCH_NANOS) {
            writer.awaitTime(clock.nanos() + WATCH_NANOS);
            inbox.look();
        }
        if (!command.isOver()) {
            writer.awaitTime(left);
        }
    }
}
