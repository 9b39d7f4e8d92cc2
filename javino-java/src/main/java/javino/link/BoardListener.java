package javino.link;

import javino.wire.ReflexOutcome;

/**
 * Receives reports that a version 2 board sends of its own accord. Methods are called on the thread that reads the line, outside of any
 * lock. They must return soon, and must not throw.
 */
public interface BoardListener {
    /**
     * A rule on the board has begun to be met.
     *
     * @param rule the rule's number, 1 to 255
     * @param outcome the outcome of the rule's reflex
     * @param percept the text of the first percept that meets the rule, with its {@code ;}
     * @param receivedNanos time at which the last byte of the report was read, by the link's clock
     */
    void critical(int rule, ReflexOutcome outcome, String percept, long receivedNanos);

    /**
     * A session has begun: the board holds no rule, so all rules have to be set again.
     *
     * @param rules number of rules that the board can hold
     */
    void sessionBegan(int rules);
}
