package javino.link;

import java.util.LinkedList;
import java.util.List;
import java.util.OptionalLong;
import java.util.Queue;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** The commands that wait for a line: urgent ones first, else in the order of submission. Guarded by its user's lock. */
final class CommandQueue {
    // the queue also inserts in the middle
    private final LinkedList<Command> urgent = new LinkedList<>();
    private final LinkedList<Command> ordinary = new LinkedList<>();
    private long submitted;
    private long finished;

    /**
     * Queues a command. The command takes the place of the first equally urgent command that it replaces. Returns all replaced commands.
     */
    List<Command> add(Command command) {
        List<Command> replaced = command.isLatest() ? withdrawIf(earlier -> replaces(command, earlier)) : List.of();
        List<Command> its = command.isUrgent() ? urgent : ordinary;
        int place = replaced.stream()
                .filter(earlier -> earlier.isUrgent() == command.isUrgent())
                .mapToInt(its::indexOf)
                .findFirst()
                .orElse(its.size());
        its.add(place, command);
        if (!replaced.isEmpty()) {
            urgent.removeIf(Command::isWithdrawn);
            ordinary.removeIf(Command::isWithdrawn);
        }
        submitted++;
        command.submitted(submitted);
        return replaced;
    }

    /** The option {@code latest}: a command replaces the waiting commands with its functor, but no rule. */
    private static boolean replaces(Command latest, Command earlier) {
        return earlier.isWaiting() && earlier.rule() == null && latest.functor().equals(earlier.functor());
    }

    Command head() {
        Command first = firstWaiting(urgent);
        return first != null ? first : firstWaiting(ordinary);
    }

    private static Command firstWaiting(Queue<Command> queue) {
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

    /** Returns whether at least {@code count} commands have ended. */
    boolean areOver(long count) {
        return finished >= count;
    }

    /** Returns whether no waiting command is among the first {@code count} submitted commands. */
    boolean haveBegun(long count) {
        return haveBegun(urgent, count) && haveBegun(ordinary, count);
    }

    private static boolean haveBegun(List<Command> queue, long count) {
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
