package javino.link;

import java.util.concurrent.CompletableFuture;
import javino.Frame;
import javino.PerceptTerm;
import javino.session.SessionCommand;
import javino.wire.CommandItem;

/** A command from its submission to its outcome. The lock of the command's {@link FrameWriter} guards its state. */
final class Command implements SessionCommand {
    /** The progress of a command. Only a waiting command can be withdrawn. */
    private enum State {
        WAITING,
        BEGUN,
        WITHDRAWN
    }

    private final Frame frame;
    private final CommandItem.Rule rule; // null for a text command
    private final SendOptions options;
    private final long submittedAt;
    private final CompletableFuture<Void> outcome = new CompletableFuture<>();
    private volatile State state = State.WAITING;
    private long number;
    private long beganBehind;

    Command(Frame frame, SendOptions options, long now) {
        this(frame, null, options, now);
    }

    /** Creates a command that changes the board's rules. Only version 2 can carry this command. */
    Command(CommandItem.Rule rule, SendOptions options, long now) {
        this(Frame.of("rule " + (int) rule.text().charAt(0)), rule, options, now);
    }

    private Command(Frame frame, CommandItem.Rule rule, SendOptions options, long now) {
        this.frame = frame;
        this.rule = rule;
        this.options = options;
        submittedAt = now;
    }

    /**
     * Returns the command's frame in version 1. Version 1 cannot carry a {@link #rule}: the frame of a rule only provides a text and a
     * length.
     */
    Frame frame() {
        return frame;
    }

    @Override
    public CommandItem.Rule rule() {
        return rule;
    }

    @Override
    public String text() {
        return frame.text();
    }

    boolean hasTimeLimit() {
        return options.limitMillis() > 0;
    }

    long submittedAt() {
        return submittedAt;
    }

    /** Records this command's number. Commands are numbered from 1 in the order of their submission. */
    void submitted(long count) {
        number = count;
    }

    long number() {
        return number;
    }

    boolean isUrgent() {
        return options.urgent();
    }

    boolean isLatest() {
        return options.latest();
    }

    String functor() {
        return PerceptTerm.of(text()).functor();
    }

    /** Returns the command's outcome. Complete the future outside of any lock: its dependents run on the completing thread. */
    CompletableFuture<Void> outcome() {
        return outcome;
    }

    @Override
    public boolean isOver() {
        return outcome.isDone();
    }

    boolean isWaiting() {
        return state == State.WAITING && !isOver();
    }

    /**
     * Marks the waiting command as begun.
     *
     * @param bytes number of bytes written to the line before the command
     */
    void begin(long bytes) {
        state = State.BEGUN;
        beganBehind = bytes;
    }

    long beganBehind() {
        return beganBehind;
    }

    /** Withdraws the command: it is never sent. Does nothing if the command has begun. */
    void withdraw() {
        if (state == State.WAITING) {
            state = State.WITHDRAWN;
        }
    }

    boolean isWithdrawn() {
        return state == State.WITHDRAWN;
    }
}
