package javino;

import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.function.ToIntFunction;

/**
 * Gives blocking writes a time limit. The operating system's write has no time limit: the write waits until the far end reads. A thread
 * of this writer therefore writes while the caller waits. Safe on any thread. Each write goes out whole, in the order of the calls.
 */
final class TimedWriter {
    private static final System.Logger LOG = System.getLogger(TimedWriter.class.getName());

    enum Outcome {
        WRITTEN,
        FAILED,
        TOO_LATE,
        CLOSED
    }

    private final ToIntFunction<byte[]> driver;
    private final ExecutorService thread;
    private final AtomicInteger underWay =
            new AtomicInteger(); // number of the thread's writes that are queued or in progress
    private final CompletableFuture<Outcome> closed = new CompletableFuture<>();

    /** @param driver writes without a time limit; returns the number of bytes written, or -1 on an error */
    TimedWriter(String port, ToIntFunction<byte[]> driver) {
        this.driver = driver;
        thread = Executors.newSingleThreadExecutor(work -> {
            Thread writing = new Thread(work, "write " + port);
            writing.setDaemon(true);
            return writing;
        });
    }

    /** Writes the bytes within {@code timeoutMillis}. If the outcome is {@link Outcome#TOO_LATE}, the bytes may still go out later. */
    Outcome write(byte[] b, int off, int len, int timeoutMillis) throws InterruptedException {
        byte[] bytes = Arrays.copyOfRange(b, off, off + len);
        // set by the thread when it begins the write, or by the caller when it gives up
        AtomicBoolean isTaken = new AtomicBoolean();
        CompletableFuture<Outcome> write;
        underWay.incrementAndGet();
        try {
            write = CompletableFuture.supplyAsync(
                    () -> isTaken.getAndSet(true) ? Outcome.TOO_LATE : writeAway(bytes), thread);
        } catch (RejectedExecutionException e) {
            underWay.decrementAndGet();
            return Outcome.CLOSED;
        } catch (Error noThread) {
            underWay.decrementAndGet();
            throw noThread;
        }
        try {
            return write.applyToEither(closed, Function.identity()).get(timeoutMillis, TimeUnit.MILLISECONDS);
        } catch (TimeoutException e) {
            return Outcome.TOO_LATE;
        } catch (ExecutionException e) {
            LOG.log(System.Logger.Level.ERROR, "the driver failed", e.getCause());
            return Outcome.FAILED;
        } finally {
            if (!isTaken.getAndSet(true)) { // a write that has not begun is cancelled
                underWay.decrementAndGet();
            }
        }
    }

    private Outcome writeAway(byte[] bytes) {
        try {
            return writeHere(bytes);
        } finally {
            underWay.decrementAndGet();
        }
    }

    Outcome writeHere(byte[] bytes) {
        return driver.applyAsInt(bytes) == bytes.length ? Outcome.WRITTEN : Outcome.FAILED;
    }

    /** Returns whether this writer's thread has a queued or unfinished write, even one that was {@link Outcome#TOO_LATE}. */
    boolean isWriting() {
        return underWay.get() > 0;
    }

    /** Ends the thread after its present write. Waiting calls return {@link Outcome#CLOSED}. */
    void close() {
        thread.shutdown();
        closed.complete(Outcome.CLOSED);
    }
}
