package javino.sim;

/**
 * A message that a board has handled.
 *
 * @param text the message's payload, a character a byte
 * @param nanos time at which the board began to handle the message, by the clock of its line; for a board that is plugged in,
 *     {@link System#nanoTime()}
 */
public record ReceivedMessage(String text, long nanos) {}
