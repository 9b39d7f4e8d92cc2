package javino.tcp;

import java.io.IOException;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectableChannel;
import java.nio.channels.Selector;

/**
 * Waits until a channel is ready for one thing. Unlike a channel that blocks, it has a time limit, and an interrupt does not close the
 * channel. One thread at a time waits; any may close it.
 */
final class Readiness implements AutoCloseable {
    private static final long NANOS_PER_MILLI = 1_000_000L;

    private final Selector selector = Selector.open();

    /**
     * @param channel one that does not block
     * @param operation one of {@link java.nio.channels.SelectionKey}
     */
    Readiness(SelectableChannel channel, int operation) throws IOException {
        channel.register(selector, operation);
    }

    /**
     * Returns when the channel is ready, when {@code nanos}, at least 1, have passed, when the thread is interrupted, or when this is
     * closed: who waits must see for itself.
     */
    void await(long nanos) throws IOException {
        try {
            selector.select((nanos + NANOS_PER_MILLI - 1) / NANOS_PER_MILLI);
            selector.selectedKeys().clear();
        } catch (ClosedSelectorException e) {
            return; // whoever closed it has said before that it is closed
        }
    }

    /** Ends the wait, and gives back what the system holds for it. Idempotent. */
    @Override
    public void close() throws IOException {
        selector.close();
    }
}
