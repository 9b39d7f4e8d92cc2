package javino.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import javino.LineClock;

/** Records the messages that a {@link FakeBoard} received. Safe on any thread. */
final class FakeBoardRecord {
    private final String port;
    private final FakeBoardMonitor monitor; // guards the lists
    private final LineClock clock;
    private final long madeNanos;
    private final List<ReceivedMessage> received = new ArrayList<>();
    private final List<String> overwritten = new ArrayList<>();
    private final List<String> unaccounted = new ArrayList<>();
    private final List<String> expected = new ArrayList<>();

    FakeBoardRecord(String port, FakeBoardMonitor monitor, LineClock clock) {
        this.port = port;
        this.monitor = monitor;
        this.clock = clock;
        madeNanos = clock.nanos();
    }

    void expect(String message) {
        monitor.locked(() -> unaccounted.remove(message) || expected.add(message));
    }

    void received(String message, boolean covered) {
        monitor.locked(() -> {
            received.add(new ReceivedMessage(message, clock.nanos()));
            boolean wasExpected = expected.remove(message);
            return covered || wasExpected || unaccounted.add(message);
        });
    }

    void overwritten(String message) {
        monitor.locked(() -> overwritten.add(message));
    }

    List<String> received() {
        return monitor.locked(() -> received.stream().map(ReceivedMessage::text).toList());
    }

    List<ReceivedMessage> receivedMessages() {
        return monitor.locked(() -> List.copyOf(received));
    }

    List<String> overwritten() {
        return monitor.locked(() -> List.copyOf(overwritten));
    }

    /** Takes the first unaccounted message that matches {@code wanted}. A failure message quotes {@code what}. */
    String take(Predicate<String> wanted, String what, int timeoutMillis) {
        List<String> taken = new ArrayList<>();
        boolean came = monitor.await(
                () -> {
                    unaccounted.stream().filter(wanted).findFirst().ifPresent(taken::add);
                    return !taken.isEmpty() && unaccounted.remove(taken.get(0));
                },
                timeoutMillis,
                "board " + port + " waited for " + what);
        if (!came) {
            throw new AssertionError("board " + port + " waited " + timeoutMillis + " ms for " + what + "; "
                    + monitor.locked(this::all));
        }
        return taken.get(0);
    }

    void verify() {
        List<String> amiss = new ArrayList<>();
        String all = monitor.locked(() -> {
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
        return received.isEmpty()
                ? "nothing came"
                : received.stream().map(this::timed).collect(Collectors.joining(", ", "what came in all: ", ""));
    }

    private String timed(ReceivedMessage message) {
        return '"' + message.text() + "\" at " + TimeUnit.NANOSECONDS.toMillis(message.nanos() - madeNanos) + " ms";
    }

    private static String quoted(List<String> messages) {
        return messages.stream().map(message -> '"' + message + '"').collect(Collectors.joining(", "));
    }
}
