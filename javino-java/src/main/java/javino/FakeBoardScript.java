package javino;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;

/** The rules of a {@link FakeBoard}. Safe on any thread. */
final class FakeBoardScript {
    /** The bytes that answer a message, or null. */
    interface Reply {
        byte[] to(String message);
    }

    private record Entry(String message, Predicate<String> kind, FakeBoard.Rule rule) {}

    private volatile List<Entry> entries = List.of(); // those for one message first

    /**
     * Adds a rule.
     *
     * @param message the one message it is for, or null
     */
    synchronized FakeBoard.Rule rule(String message, Predicate<String> kind) {
        Entry entry = new Entry(message, kind, new FakeBoard.Rule());
        List<Entry> changed = new ArrayList<>(entries);
        if (message != null) {
            changed.removeIf(other -> message.equals(other.message()));
            changed.add(0, entry);
        } else {
            changed.add(entry);
        }
        entries = List.copyOf(changed);
        return entry.rule();
    }

    Optional<FakeBoard.Rule> ruleFor(String message) {
        return entries.stream().filter(entry -> entry.kind().test(message)).map(Entry::rule).findFirst();
    }

    static Reply inTurn(String first, String... next) {
        List<Frame> answers = new ArrayList<>(List.of(Frame.of(first)));
        for (String text : next) {
            answers.add(Frame.of(text));
        }
        AtomicInteger turn = new AtomicInteger();
        return message -> answers.get(turn.getAndUpdate(i -> Math.min(i + 1, answers.size() - 1))).toBytes();
    }
}
