package javino.link;

import java.util.Objects;
import javino.LineSettings;
import javino.Protocol;

/**
 * Settings of a {@link Link}: how it treats its line and the board at the other end.
 *
 * @param baud bits a second
 * @param paced true: the driver gets a frame only when the previous frame has left the line, by the baud rate. An urgent command then
 *     never waits for seconds behind old commands. False: the driver gets each frame at once
 * @param spacingMillis the shortest gap, in milliseconds, before a frame to a version 1 board. The gap begins after the previous frame or
 *     answer. The gap is 50 ms until six answers have been timed. If answers show a slow {@code loop()}, the gap is longer than this
 *     setting. 0: no gap, for a board that keeps all messages
 * @param boardQueue received messages that the board can hold, at least 1; most version 1 boards hold one
 * @param bootMillis milliseconds after opening during which the board may be starting; 0: the board runs already
 * @param protocol the version of the protocol to speak; {@link Protocol#AUTO}: version 2 if the board speaks it, else version 1
 */
public record LinkSettings(
        int baud, boolean paced, int spacingMillis, int boardQueue, int bootMillis, Protocol protocol) {
    public LinkSettings {
        requireAtLeast("baud", 1, baud);
        requireAtLeast("spacingMillis", 0, spacingMillis);
        requireAtLeast("boardQueue", 1, boardQueue);
        requireAtLeast("bootMillis", 0, bootMillis);
        Objects.requireNonNull(protocol, "protocol");
    }

    private static void requireAtLeast(String what, int least, int found) {
        if (found < least) {
            throw new IllegalArgumentException(what + " is at least " + least + ", but " + found + " was given");
        }
    }

    /**
     * Returns the default settings: 9600 baud, paced, 2 ms of spacing, {@link Protocol#AUTO}, for a board that holds one message and
     * starts within 3 s.
     */
    public static LinkSettings defaults() {
        return new LinkSettings(LineSettings.DEFAULT_BAUD, true, 2, 1, 3000, Protocol.AUTO);
    }

    /** Returns these settings at another baud rate. */
    public LinkSettings withBaud(int value) {
        return new LinkSettings(value, paced, spacingMillis, boardQueue, bootMillis, protocol);
    }

    /** Returns these settings with pacing on or off. */
    public LinkSettings withPaced(boolean value) {
        return new LinkSettings(baud, value, spacingMillis, boardQueue, bootMillis, protocol);
    }

    /** Returns these settings with another spacing, in milliseconds. */
    public LinkSettings withSpacingMillis(int value) {
        return new LinkSettings(baud, paced, value, boardQueue, bootMillis, protocol);
    }

    /** Returns these settings for a board that holds {@code value} messages. */
    public LinkSettings withBoardQueue(int value) {
        return new LinkSettings(baud, paced, spacingMillis, value, bootMillis, protocol);
    }

    /** Returns these settings for a board that starts within {@code value} milliseconds. */
    public LinkSettings withBootMillis(int value) {
        return new LinkSettings(baud, paced, spacingMillis, boardQueue, value, protocol);
    }

    /** Returns these settings with another protocol. */
    public LinkSettings withProtocol(Protocol value) {
        return new LinkSettings(baud, paced, spacingMillis, boardQueue, bootMillis, value);
    }

    /** The settings of the serial line. */
    public LineSettings line() {
        return new LineSettings(baud);
    }
}
