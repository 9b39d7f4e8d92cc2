package javino;

/**
 * What a board said.
 *
 * @param version the version of the protocol in which it came: 1 or 2
 * @param text one character a byte (ISO-8859-1)
 */
record Message(int version, String text) {}
