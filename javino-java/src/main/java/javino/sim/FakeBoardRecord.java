package javino.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javino.LineClock;

/** What a {@link FakeBoard} received and what becomes of it. Safe on any thread. */
final class FakeBoardRecord {
    private final Lock lock;
    private final Condition changed;
    private final List<String> received = new ArrayList<>();
    private final List<String> overwritten = new ArrayList<>();
    private final List<String> unaccounted = new ArrayList<>(); // covered by no rule, not expected, not taken yet
    private final List<String> expected = new ArrayList<>();
    private final String port;

    FakeBoardRecord(String port, LineClock clock) {
        this.port = port;
        lock = clock.newLock(false);
        changed = lock.newCondition();
    }

    void expect(String message) {
        locked(() -> unaccounted.remove(message) || expected.add(message));
    }

    /** @param covered whether a rule says what to do with it */
    void received(String message, boolean covered) {
        locked(() -> {
            received.add(message);
            boolean wasExpected = expected.remove(message);
            if (!covered && !wasExpected) {
                unaccounted.add(message);
            }
            changed.signalAll();
            return null;
        });
    }

    void overwritten(String message) {
        locked(() -> overwritten.add(message));
    }

    List<String> received() {
        return locked(() -> List.copyOf(received));
    }

    List<String> overwritten() {
        return locked(() -> List.copyOf(overwritten));
    }

    private <T> T locked(Supplier<T> work) {
        lock.lock();
        try {
            return work.get();
        } finally {
            lock.unlock();
        }
    }

    /** Takes the first message that is not accounted for and is {@code wanted}; {@code what} says to a person what was wanted. */
    String take(Predicate<String> wanted, String what, int timeoutMillis) {
        long left = TimeUnit.MILLISECONDS.toNanos(timeoutMillis);
        lock.lock();
        try {
            while (true) {
                for (String message : unaccounted) {
                    if (wanted.test(message)) {
                        unaccounted.remove(message);
                        return message;
                    }
                }
                if (left <= 0) {
                    throw new AssertionError("board " + port + " waited " + timeoutMillis + " ms for " + what + "; " + all());
                }
                left = changed.awaitNanos(left);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError("interrupted while board " + port + " waited for " + what, e);
        } finally {
            lock.unlock();
        }
    }

    void verify() {
        List<String> amiss = new ArrayList<>();
        String all = locked(() -> {
            addUnlessEmpty(amiss, "received what nobody expected: ", unaccounted);
            addUnlessEmpty(amiss, "did not receive: ", expected);
            addUnlessEmpty(amiss, "had no room for, and lost: ", overwritten);
            return all();
        });
        if (!amiss.isEmpty()) {
            throw new AssertionError("board " + port + " " + String.join("; it ", amiss) + "; " + all);
        }
    }

    private static void addUnlessEmpty(List<String> amiss, String what, List<String> messages) {
        if (!messages.isEmpty()) {
            amiss.add(what + quoted(messages));
        }
    }

    private String all() {
        return received.isEmpty() ? "nothing came" : "what came in all: " + quoted(received);
    }

    private static String quoted(List<String> messages) {
        return String.join(", ", messages.stream().map(message -> '"' + message + '"').toList());
    }
}
