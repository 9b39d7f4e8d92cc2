package javino.sim;

/**
 * A message that a board has handled.
 *
 * @param text its payload, a character a byte
 * @param nanos when the board took it up, in nanoseconds of the clock of its line: of a board that is plugged in that of
 *     {@link System#nanoTime()}
 */
public record ReceivedMessage(String text, long nanos) {}
