package javino.sim;

/**
 * A message that a board has handled.
 *
 * @param text the message's payload, one character per byte
 * @param nanos the time at which the board began to handle the message, by the line's clock. A board that is plugged in uses
 *     {@link System#nanoTime()}
 */
public record ReceivedMessage(String text, long nanos) {}
