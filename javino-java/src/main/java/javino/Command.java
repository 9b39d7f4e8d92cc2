package javino;

import java.util.concurrent.CompletableFuture;

/** A command from its submission to its outcome. Its state is guarded by the lock of the {@link FrameWriter} that it was submitted to. */
final class Command {
    /** How far it has got: a command that waits can be withdrawn, one that has begun goes out. */
    private enum State {
        WAITING,
        BEGUN,
        WITHDRAWN
    }

    private final Frame frame;
    private final boolean urgent;
    private final long deadline;
    private final boolean isLimited;
    private final CompletableFuture<Void> outcome = new CompletableFuture<>();
    private volatile State state = State.WAITING;

    /** @param deadline when its outcome must be known, by the link's clock, if it {@code isLimited} */
    Command(Frame frame, boolean urgent, long deadline, boolean isLimited) {
        this.frame = frame;
        this.urgent = urgent;
        this.deadline = deadline;
        this.isLimited = isLimited;
    }

    Frame frame() {
        return frame;
    }

    boolean isUrgent() {
        return urgent;
    }

    /** Nanoseconds that are left at {@code now}, more than {@code most} never. */
    long nanosLeft(long now, long most) {
        return isLimited ? Math.min(deadline - now, most) : most;
    }

    /** What became of it. Completed outside of any lock, since its dependents run on the thread that completes it. */
    CompletableFuture<Void> outcome() {
        return outcome;
    }

    boolean isOver() {
        return outcome.isDone();
    }

    boolean isWaiting() {
        return state == State.WAITING && !isOver();
    }

    /** Marks it as going out; the caller has found that it waits. */
    void begin() {
        state = State.BEGUN;
    }

    /** Marks it as one that never goes out, unless it has begun. */
    void withdraw() {
        if (state == State.WAITING) {
            state = State.WITHDRAWN;
        }
    }

    boolean isWithdrawn() {
        return state == State.WITHDRAWN;
    }
}
