/**
 * Links: open ports through which one owner exchanges messages with a board, at the pace of the line, in the version of the protocol that
 * the board speaks. {@link javino.link.Link} is the way in.
 */
package javino.link;
