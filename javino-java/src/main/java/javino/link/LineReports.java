package javino.link;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;

/** Collects outcomes, board reports and warnings under the line's lock. Passes these reports on outside of the lock. Safe on any thread. */
final class LineReports {
    private static final System.Logger LOG = System.getLogger(LineReports.class.getName());

    private final Queue<Runnable> waiting = new ConcurrentLinkedQueue<>();
    private volatile BoardListener listener;

    boolean isEmpty() {
        return waiting.isEmpty();
    }

    /** Passes all collected reports on. The caller holds no lock. */
    void passOn() {
        for (Runnable next = waiting.poll(); next != null; next = waiting.poll()) {
            next.run();
        }
    }

    /** @param failure null if the command was carried out */
    void ended(Command command, Throwable failure) {
        waiting.add(() -> {
            if (failure == null) {
                command.outcome().complete(null);
            } else {
                command.outcome().completeExceptionally(failure);
            }
        });
    }

    void warn(String text) {
        waiting.add(() -> LOG.log(System.Logger.Level.WARNING, text));
    }

    void listener(BoardListener value) {
        listener = value;
    }

    void call(Consumer<BoardListener> call) {
        BoardListener called = listener;
        if (called != null) {
            waiting.add(() -> {
                try {
                    call.accept(called);
                } catch (RuntimeException | Error broken) { // the reading thread must go on
                    LOG.log(System.Logger.Level.ERROR, "the receiver of the board's reports has failed", broken);
                }
            });
        }
    }
}
