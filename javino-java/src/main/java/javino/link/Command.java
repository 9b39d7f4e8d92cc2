package javino.link;

import java.util.concurrent.CompletableFuture;
import javino.Frame;
import javino.PerceptTerm;
import javino.session.SessionCommand;
import javino.wire.CommandItem;

/** A command from its submission to its outcome. Its state is guarded by the lock of the {@link FrameWriter} that it was submitted to. */
final class Command implements SessionCommand {
    /** The progress of a command. Only a waiting command can be withdrawn; a command that has begun goes out. */
    private enum State {
        WAITING,
        BEGUN,
        WITHDRAWN
    }

    private final Frame frame;
    private final CommandItem.Rule rule; // null: the command is a text for the board's program
    private final SendOptions options;
    private final long submittedAt;
    private final CompletableFuture<Void> outcome = new CompletableFuture<>();
    private volatile State state = State.WAITING;
    private long number;
    private long beganBehind;

    /** @param now time of the command's submission, by the link's clock */
    Command(Frame frame, SendOptions options, long now) {
        this(frame, null, options, now);
    }

    /** A command that changes the board's rules; only version 2 can carry it. */
    Command(CommandItem.Rule rule, SendOptions options, long now) {
        this(Frame.of("rule " + (int) rule.text().charAt(0)), rule, options, now);
    }

    private Command(Frame frame, CommandItem.Rule rule, SendOptions options, long now) {
        this.frame = frame;
        this.rule = rule;
        this.options = options;
        submittedAt = now;
    }

    /** The command's frame in version 1. Version 1 cannot carry a {@link #rule}; the frame then only serves for its text and length. */
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

    /** Records this command's number among all submitted commands: the first has number 1. */
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

    boolean replaces(Command earlier) {
        return isLatest()
                && earlier.isWaiting()
                && earlier.rule == null
                && functor().equals(earlier.functor());
    }

    private String functor() {
        return PerceptTerm.of(text()).functor();
    }

    /** The command's outcome. The future is completed outside of any lock, since its dependents run on the thread that completes it. */
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

    /** Marks the command as begun, after {@code bytes} bytes were written to the line. The command must be waiting. */
    void begin(long bytes) {
        state = State.BEGUN;
        beganBehind = bytes;
    }

    /** Bytes that were written to the line before this command began to go out. */
    long beganBehind() {
        return beganBehind;
    }

    /** Withdraws the command, so that it never goes out. Does nothing if the command has begun. */
    void withdraw() {
        if (state == State.WAITING) {
            state = State.WITHDRAWN;
        }
    }

    boolean isWithdrawn() {
        return state == State.WITHDRAWN;
    }
}
