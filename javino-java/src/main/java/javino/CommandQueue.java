package javino;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** The commands that wait for a line: urgent ones first, else in the order of their submission. Guarded by its user's lock. */
final class CommandQueue {
    private final Deque<Command> urgent = new ArrayDeque<>();
    private final Deque<Command> ordinary = new ArrayDeque<>();
    private long submitted;
    private long finished;

    void add(Command command) {
        (command.isUrgent() ? urgent : ordinary).add(command);
        submitted++;
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

    /** Records that the outcome of a command has been reported. */
    void finished() {
        finished++;
    }

    /** Commands submitted so far. */
    long submitted() {
        return submitted;
    }

    /** Whether as many commands are over as had been submitted when {@link #submitted} returned {@code count}. */
    boolean areOver(long count) {
        return finished >= count;
    }

    /** Removes all commands, and withdraws them. */
    List<Command> removeAll() {
        List<Command> removed = new ArrayList<>();
        for (Command command = head(); command != null; command = head()) {
            command.withdraw();
            removed.add(command);
        }
        return removed;
    }
}
