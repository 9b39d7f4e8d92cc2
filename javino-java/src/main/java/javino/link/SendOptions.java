package javino.link;

import javino.CommandReplacedException;

/**
 * Options of a command, see {@link Link#send(String, SendOptions)}.
 *
 * @param urgent whether the command goes out before waiting commands that are not urgent
 * @param limitMillis milliseconds from the call after which the outcome is known in any case; 0: no limit
 * @param latest whether the command replaces waiting commands with the same functor. Replaced commands fail with
 *     {@link CommandReplacedException}
 */
public record SendOptions(boolean urgent, int limitMillis, boolean latest) {
    public SendOptions {
        if (limitMillis < 0) {
            throw new IllegalArgumentException(
                    "a time limit is at least 1 ms, or 0 for none, but " + limitMillis + " was given");
        }
    }

    /** Creates options of a command that replaces no other command. */
    public SendOptions(boolean urgent, int limitMillis) {
        this(urgent, limitMillis, false);
    }

    /** Returns options of a command that is not urgent, has no time limit and replaces no other command. */
    public static SendOptions defaults() {
        return new SendOptions(false, 0, false);
    }
}
