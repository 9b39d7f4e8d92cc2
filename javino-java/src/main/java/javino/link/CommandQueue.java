package javino.link;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.OptionalLong;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** The commands that wait for a line: urgent ones first, else in the order of their submission. Guarded by its user's lock. */
final class CommandQueue {
    private Deque<Command> urgent = new ArrayDeque<>();
    private Deque<Command> ordinary = new ArrayDeque<>();
    private long submitted;
    private long finished;

    /** Queues a command, in place of the first equally urgent one that it replaces. Returns the commands that it replaces. */
    List<Command> add(Command command) {
        List<Command> replaced = new ArrayList<>();
        urgent = without(urgent, command, replaced, command.isUrgent());
        ordinary = without(ordinary, command, replaced, !command.isUrgent());
        submitted++;
        command.submitted(submitted);
        return replaced;
    }

    /**
     * Returns the queue without the commands that {@code command} replaces, and withdraws these. The result holds {@code command} if that
     * belongs to this queue ({@code isIts}).
     */
    private static Deque<Command> without(
            Deque<Command> queue, Command command, List<Command> replaced, boolean isIts) {
        if (!replacesOneOf(queue, command)) {
            if (isIts) {
                queue.add(command);
            }
            return queue;
        }
        Deque<Command> rest = new ArrayDeque<>();
        for (Command earlier : queue) {
            if (!command.replaces(earlier)) {
                rest.add(earlier);
                continue;
            }
            earlier.withdraw();
            replaced.add(earlier);
            if (isIts && !rest.contains(command)) {
                rest.add(command);
            }
        }
        return rest;
    }

    private static boolean replacesOneOf(Deque<Command> queue, Command command) {
        for (Command earlier : queue) {
            if (command.replaces(earlier)) {
                return true;
            }
        }
        return false;
    }

    /** The command whose turn is next; null: none waits. */
    Command head() {
        Command first = firstWaiting(urgent);
        return first != null ? first : firstWaiting(ordinary);
    }

    private static Command firstWaiting(Deque<Command> queue) {
        while (!queue.isEmpty() && !queue.peek().isWaiting()) {
            queue.remove();
        }
        return queue.peek();
    }

    void finished() {
        finished++;
    }

    long submitted() {
        return submitted;
    }

    /** Returns whether as many commands are over as had been submitted when {@link #submitted} returned {@code count}. */
    boolean areOver(long count) {
        return finished >= count;
    }

    /** Returns whether no command still waits that had been submitted when {@link #submitted} returned {@code count}. */
    boolean haveBegun(long count) {
        return haveBegun(urgent, count) && haveBegun(ordinary, count);
    }

    private static boolean haveBegun(Deque<Command> queue, long count) {
        for (Command command : queue) {
            if (command.isWaiting() && command.number() <= count) {
                return false;
            }
        }
        return true;
    }

    List<Command> withdrawIf(Predicate<Command> isGivenUp) {
        List<Command> givenUp = waiting().filter(isGivenUp).toList();
        givenUp.forEach(Command::withdraw);
        return givenUp;
    }

    /** The time at which the first of the waiting commands without a time limit was submitted; empty: none waits. */
    OptionalLong waitingSince() {
        return waiting()
                .filter(command -> !command.hasTimeLimit())
                .mapToLong(Command::submittedAt)
                .reduce((a, b) -> a - b < 0 ? a : b);
    }

    private Stream<Command> waiting() {
        return Stream.concat(urgent.stream(), ordinary.stream()).filter(Command::isWaiting);
    }
}
