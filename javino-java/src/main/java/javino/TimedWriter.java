package javino;

import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import java.util.function.ToIntFunction;

/**
 * Gives blocking writes a time limit. The operating system's write has none: it waits for as long as the far end does not read. So it is
 * done on a thread of this writer's own, which the caller waits for.
 *
 * <p>Safe on any thread; writes go out in the order in which they are called, each as a whole.
 */
final class TimedWriter {
    private static final System.Logger LOG = System.getLogger(TimedWriter.class.getName());

    /** How a write ended. */
    enum Outcome {
        WRITTEN,
        FAILED,
        TOO_LATE,
        CLOSED
    }

    private final ToIntFunction<byte[]> driver;
    private final ExecutorService thread;
    private final CompletableFuture<Outcome> closed = new CompletableFuture<>();

    /**
     * @param port its name, for the thread's
     * @param driver the write that has no time limit: returns how many of the bytes were written, fewer than all or -1 on an error
     */
    TimedWriter(String port, ToIntFunction<byte[]> driver) {
        this.driver = driver;
        thread = Executors.newSingleThreadExecutor(work -> {
            Thread writing = new Thread(work, "write " + port);
            writing.setDaemon(true);
            return writing;
        });
    }

    /**
     * Writes the bytes, waiting at most {@code timeoutMillis} milliseconds. After {@link Outcome#TOO_LATE} they have not left, or are
     * still on their way out.
     */
    Outcome write(byte[] b, int off, int len, int timeoutMillis) throws InterruptedException {
        byte[] bytes = Arrays.copyOfRange(b, off, off + len);
        CompletableFuture<Outcome> write;
        try {
            write = CompletableFuture.supplyAsync(
                    () -> driver.applyAsInt(bytes) == len ? Outcome.WRITTEN : Outcome.FAILED, thread);
        } catch (RejectedExecutionException e) {
            return Outcome.CLOSED;
        }
        try {
            return write.applyToEither(closed, Function.identity()).get(timeoutMillis, TimeUnit.MILLISECONDS);
        } catch (TimeoutException e) {
            return Outcome.TOO_LATE;
        } catch (ExecutionException e) {
            LOG.log(System.Logger.Level.ERROR, "the driver failed", e.getCause());
            return Outcome.FAILED;
        } finally {
            write.cancel(false); // a write that has not begun does not
        }
    }

    /** Ends the thread as soon as its write returns. Calls that wait get {@link Outcome#CLOSED}. */
    void close() {
        thread.shutdown();
        closed.complete(Outcome.CLOSED);
    }
}
