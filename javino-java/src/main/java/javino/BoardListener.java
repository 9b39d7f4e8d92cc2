package javino;

import javino.wire.ReflexOutcome;

/**
 * Is called when a version 2 board reports something of its own accord, on the thread that reads the line and outside of any lock. It
 * returns soon, and throws nothing.
 */
public interface BoardListener {
    /**
     * A rule on the board has begun to be met.
     *
     * @param rule the rule's number, 1 to 255
     * @param outcome what became of its reflex
     * @param percept the text of the first percept that meets it, with its {@code ;}
     * @param receivedNanos when the last byte of the report was read, by the link's clock
     */
    void critical(int rule, ReflexOutcome outcome, String percept, long receivedNanos);

    /**
     * A session has begun: the board holds no rule, so those that there are have to be set again.
     *
     * @param rules how many the board can hold
     */
    void sessionBegan(int rules);
}
