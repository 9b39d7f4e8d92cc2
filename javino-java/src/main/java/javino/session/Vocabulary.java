package javino.session;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javino.wire.BoardAction;
import javino.wire.CommandItem;
import javino.wire.FrameKind;
import javino.wire.VocabularyPage;
import javino.wire.WireFrame;

/** Asks the board for its actions, page by page. Keeps the numbers of the actions that need no arguments. */
final class Vocabulary {
    private static final long FIRST_TIMEOUT_NANOS = TimeUnit.MILLISECONDS.toNanos(500);
    private static final int MAX_DOUBLINGS = 6;
    private static final int REQUESTS = 255;

    private final List<BoardAction> actions = new ArrayList<>();
    private final Map<String, Integer> numbers = new HashMap<>(); // by name, for actions that need no arguments
    private int request;
    private int doublings;
    private boolean isWanted;
    private Optional<List<BoardAction>> complete = Optional.empty();
    private long dueAt;

    void reset() {
        actions.clear();
        numbers.clear();
        request = 0;
        doublings = 0;
        isWanted = false;
        complete = Optional.empty();
    }

    void want(long now) {
        if (!isWanted) {
            isWanted = true;
            dueAt = now;
        }
    }

    Optional<List<BoardAction>> actions() {
        return complete;
    }

    /** Returns the form in which a command goes out: a rule, a number or a text. An empty text becomes {@link CommandItem.Nothing}. */
    CommandItem itemOf(SessionCommand command) {
        if (command.rule() != null) {
            return command.rule();
        }
        String text = command.text();
        if (text.isEmpty()) {
            return new CommandItem.Nothing();
        }
        Integer number = numbers.get(text);
        return number == null ? new CommandItem.Text(text) : new CommandItem.Action(number);
    }

    private boolean asks() {
        return isWanted && complete.isEmpty();
    }

    /** Returns whether a page may come soon. */
    boolean isAwaited() {
        return asks() && doublings == 1;
    }

    long nanosUntilDue(long now) {
        return asks() ? Math.max(0, dueAt - now) : Long.MAX_VALUE;
    }

    WireFrame next(long now) {
        request = request % REQUESTS + 1;
        dueAt = now + (FIRST_TIMEOUT_NANOS << doublings);
        doublings = Math.min(doublings + 1, MAX_DOUBLINGS);
        return WireFrame.of(FrameKind.DESCRIBE, request, "" + (char) actions.size());
    }

    /** Takes a page. Returns false if the wanted page is empty although some actions are unknown. */
    boolean accept(VocabularyPage page, long now) {
        if (!asks() || page.first() != actions.size()) {
            return true;
        }
        if (page.actions().isEmpty() && page.total() > actions.size()) {
            return false;
        }
        for (BoardAction action : page.actions()) {
            if (action.arguments() == 0 || action.arguments() == BoardAction.ANY) {
                numbers.put(action.name(), actions.size());
            } else {
                numbers.remove(action.name());
            }
            actions.add(action);
        }
        numbers.values().removeIf(number -> number > CommandItem.MAX_ACTION);
        if (actions.size() >= page.total()) {
            complete = Optional.of(List.copyOf(actions));
        }
        doublings = 0;
        dueAt = now;
        return true;
    }
}
