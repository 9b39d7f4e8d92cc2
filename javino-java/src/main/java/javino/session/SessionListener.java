package javino.session;

import javino.wire.CriticalReport;
import javino.wire.FrameKind;
import javino.wire.Welcome;

/** Receives the reports of a session, while one of the session's methods runs. The listener must not call the session. */
public interface SessionListener<C> {
    /** The board speaks version 2; a session is about to begin. */
    void found();

    /**
     * The board speaks another {@linkplain Welcome#REVISION revision} of version 2, so no session begins. Called for each WELCOME with
     * another revision.
     */
    void otherRevision(int revision);

    /** A session has begun: the board knows no rules. */
    void began(Welcome welcome);

    /** The outcome of a command is known. */
    void ended(C command, CommandOutcome outcome);

    /** The answer to the request has come. */
    void answered(String percepts);

    /** Percepts have come unasked. */
    void heard(String percepts);

    /** An answer was dropped: it has more bytes than the limit. */
    void dropped();

    /** An intact frame was dropped: its payload has no known form. */
    void unreadable(FrameKind kind);

    /**
     * A page of the board's vocabulary holds no action, although only {@code described} of {@code total} are known. So the other actions
     * stay unknown. Called for each empty page.
     */
    void undescribed(int described, int total);

    /** A rule on the board has begun to be met. */
    void reported(CriticalReport report);

    /** The session is closed: the board has not answered for so long that another board may be in its place. */
    void lapsed();
}
