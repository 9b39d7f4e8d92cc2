package javino;

/**
 * How a command is sent, see {@link Link#send(String, SendOptions)}.
 *
 * @param urgent whether it goes before the commands that wait and are not urgent
 * @param limitMillis milliseconds from the call after which its outcome is known in any case; 0: there is no such limit
 */
public record SendOptions(boolean urgent, int limitMillis) {
    public SendOptions {
        if (limitMillis < 0) {
            throw new IllegalArgumentException(
                    "a time limit is at least 1 ms, or 0 for none, but " + limitMillis + " was given");
        }
    }

    /** Not urgent, without a time limit. */
    public static SendOptions defaults() {
        return new SendOptions(false, 0);
    }
}
