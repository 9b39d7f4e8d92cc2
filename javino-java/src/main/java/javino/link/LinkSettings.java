package javino.link;

import java.util.Objects;
import javino.Frame;
import javino.LineSettings;
import javino.Protocol;

/**
 * Settings of a {@link Link}: how it treats its line and the board at the other end.
 *
 * @param baud bits a second
 * @param paced true: a frame goes to the driver only when, by the baud rate, the frame before it has left the line. So an urgent command
 *     never waits for seconds behind old commands. False: each frame goes to the driver at once
 * @param spacingMillis the shortest gap, in milliseconds, between a frame to a version 1 board, or its answer, and the next frame. The gap
 *     is 50 ms until six answers have been timed, and longer than this setting if the answers show a slow {@code loop()}. 0: no gap, for a
 *     board that keeps all messages
 * @param boardQueue received messages that the board can hold, at least 1; boards in the field hold one
 * @param bootMillis milliseconds after opening during which the board may be starting; 0: the board runs already
 * @param protocol the version of the protocol to speak; {@link Protocol#AUTO}: version 2 if the board speaks it, else version 1
 * @param messageLimit the most bytes of a message from a version 2 board, at least 255; longer messages are dropped
 */
public record LinkSettings(
        int baud,
        boolean paced,
        int spacingMillis,
        int boardQueue,
        int bootMillis,
        Protocol protocol,
        int messageLimit) {
    /** The most bytes of a message from a version 2 board, if no other limit is set. */
    public static final int DEFAULT_MESSAGE_LIMIT = 65_536;

    public LinkSettings {
        requireAtLeast("baud", 1, baud);
        requireAtLeast("spacingMillis", 0, spacingMillis);
        requireAtLeast("boardQueue", 1, boardQueue);
        requireAtLeast("bootMillis", 0, bootMillis);
        Objects.requireNonNull(protocol, "protocol");
        requireAtLeast("messageLimit", Frame.MAX_PAYLOAD, messageLimit);
    }

    private static void requireAtLeast(String what, int least, int found) {
        if (found < least) {
            throw new IllegalArgumentException(what + " is at least " + least + ", but " + found + " was given");
        }
    }

    /** 9600 baud, paced, 2 ms of spacing, a board that holds one message and starts within 3 s, {@link Protocol#AUTO}. */
    public static LinkSettings defaults() {
        return new LinkSettings(LineSettings.DEFAULT_BAUD, true, 2, 1, 3000, Protocol.AUTO, DEFAULT_MESSAGE_LIMIT);
    }

    /** These settings at another rate. */
    public LinkSettings withBaud(int value) {
        return new LinkSettings(value, paced, spacingMillis, boardQueue, bootMillis, protocol, messageLimit);
    }

    /** These settings for a line that is paced, or is not. */
    public LinkSettings withPaced(boolean value) {
        return new LinkSettings(baud, value, spacingMillis, boardQueue, bootMillis, protocol, messageLimit);
    }

    /** These settings with another spacing, in milliseconds. */
    public LinkSettings withSpacingMillis(int value) {
        return new LinkSettings(baud, paced, value, boardQueue, bootMillis, protocol, messageLimit);
    }

    /** These settings for a board that holds {@code value} messages. */
    public LinkSettings withBoardQueue(int value) {
        return new LinkSettings(baud, paced, spacingMillis, value, bootMillis, protocol, messageLimit);
    }

    /** These settings for a board that starts within {@code value} milliseconds. */
    public LinkSettings withBootMillis(int value) {
        return new LinkSettings(baud, paced, spacingMillis, boardQueue, value, protocol, messageLimit);
    }

    /** These settings with another choice of the protocol's version. */
    public LinkSettings withProtocol(Protocol value) {
        return new LinkSettings(baud, paced, spacingMillis, boardQueue, bootMillis, value, messageLimit);
    }

    /** These settings with another limit for messages, in bytes. */
    public LinkSettings withMessageLimit(int value) {
        return new LinkSettings(baud, paced, spacingMillis, boardQueue, bootMillis, protocol, value);
    }

    /** The settings of the serial line. */
    public LineSettings line() {
        return new LineSettings(baud);
    }
}
