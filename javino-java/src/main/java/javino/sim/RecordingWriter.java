package javino.sim;

import java.io.IOException;
import java.io.Writer;
import java.util.concurrent.TimeUnit;

/** Writes a {@link LineRecording}, message by message. A written message survives if the program is killed. Safe on any thread. */
public final class RecordingWriter implements AutoCloseable {
    private final Writer out;
    private final long startNanos;
    private long latestMillis;

    /**
     * Begins a recording at 0 ms.
     *
     * @param out takes the text; {@link #close} closes it
     * @param nowNanos the present time, by the clock that {@link #add} uses
     */
    public RecordingWriter(Writer out, long nowNanos) throws IOException {
        this.out = out;
        startNanos = nowNanos;
        line(LineRecording.HEADER);
    }

    /** Adds a message at {@code nowNanos}. If the previous message has a later time, uses that time instead. */
    public synchronized void add(long nowNanos, LineRecording.Direction direction, String message) throws IOException {
        latestMillis = Math.max(latestMillis, TimeUnit.NANOSECONDS.toMillis(nowNanos - startNanos));
        line(latestMillis + "\t" + direction.word + "\t" + RecordingText.write(message));
    }

    @Override
    public synchronized void close() throws IOException {
        out.close();
    }

    private void line(String text) throws IOException {
        out.write(text + '\n');
        out.flush();
    }
}
