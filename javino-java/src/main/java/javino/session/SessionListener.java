package javino.session;

import javino.wire.CriticalReport;
import javino.wire.FrameKind;
import javino.wire.Welcome;

/** Receives the reports of a session. The session's methods call the listener. The listener must not call the session. */
public interface SessionListener<C> {
    /** Called when a board of version 2 is found. A session is about to begin. */
    void found();

    /** Called for each WELCOME with an unknown {@linkplain Welcome#REVISION revision} of version 2. No session begins. */
    void otherRevision(int revision);

    /** Called when a session has begun. The board holds no rules then. */
    void began(Welcome welcome);

    void ended(C command, CommandOutcome outcome);

    void answered(String percepts);

    /** Called with percepts that came unasked. */
    void heard(String percepts);

    /** Called when an answer was dropped because it is longer than the limit. */
    void dropped();

    /** Called when an intact frame was dropped because its payload cannot be read. */
    void unreadable(FrameKind kind);

    /**
     * Called for each page of the board's vocabulary that holds no action, although only {@code described} of {@code total} are known.
     * The other actions stay unknown.
     */
    void undescribed(int described, int total);

    /** Called when percepts on the board begin to match a rule. */
    void reported(CriticalReport report);

    /** Called when the session has closed because of a long silence. Another board may be connected now. */
    void lapsed();
}
