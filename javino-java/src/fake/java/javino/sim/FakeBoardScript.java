package javino.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import javino.Frame;

/** The rules of a {@link FakeBoard}. Safe on any thread. */
final class FakeBoardScript {
    private record Entry(String message, Predicate<String> kind, FakeBoard.Rule rule) {}

    private volatile List<Entry> entries = List.of(); // rules for one message come before rules for kinds

    /**
     * Adds a rule.
     *
     * @param message the only message that the rule covers, or null for a rule for a kind
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
        return entries.stream()
                .filter(entry -> entry.kind().test(message))
                .map(Entry::rule)
                .findFirst();
    }

    /** Returns answers in turn, then repeats the last one. Safe on any thread. */
    static final class InTurn {
        private final List<String> answers;
        private final AtomicInteger turn = new AtomicInteger();

        InTurn(String first, String... next) {
            List<String> all = new ArrayList<>(List.of(first));
            all.addAll(List.of(next));
            answers = List.copyOf(all);
            answers.stream()
                    .filter(text -> text.length() <= Frame.MAX_PAYLOAD)
                    .forEach(Frame::of); // throws now, in the test's call, if the text fits into no frame
        }

        String current() {
            return answers.get(turn.get());
        }

        String next() {
            return answers.get(turn.getAndUpdate(i -> Math.min(i + 1, answers.size() - 1)));
        }
    }
}
