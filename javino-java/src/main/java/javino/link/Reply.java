package javino.link;

import javino.Protocol;

/**
 * A message from a board.
 *
 * @param text the message's text, one character a byte (ISO-8859-1)
 * @param version the protocol version of the message
 * @param receivedNanos time at which the message's last byte was read, by the link's clock
 */
public record Reply(String text, Protocol version, long receivedNanos) {}
