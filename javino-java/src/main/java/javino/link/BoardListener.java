package javino.link;

import javino.wire.ReflexOutcome;

/**
 * Receives the reports that a version 2 board sends on its own. The thread that reads the line calls the methods and holds no lock. The
 * methods must return quickly and must not throw.
 */
public interface BoardListener {
    /**
     * Called when percepts on the board begin to match a rule.
     *
     * @param rule the rule's number, 1 to 255
     * @param outcome the outcome of the rule's reflex
     * @param percept the text of the first matching percept, with its {@code ;}
     * @param receivedNanos time at which the last byte of the report was read, by the link's clock
     */
    void critical(int rule, ReflexOutcome outcome, String percept, long receivedNanos);

    /**
     * Called when a session has begun. The board then holds no rule, so the listener must set all rules again.
     *
     * @param rules number of rules that the board can hold
     */
    void sessionBegan(int rules);
}
