/**
 * Links: open ports through which one owner exchanges messages with a board. A link keeps the pace of the line and speaks the board's
 * version of the protocol. Start with {@link javino.link.Link}.
 */
package javino.link;
