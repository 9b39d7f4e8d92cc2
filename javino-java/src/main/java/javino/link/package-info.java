/**
 * A link is an open port through which one owner exchanges messages with a board, at the pace of the line and in the board's version of the
 * protocol. {@link javino.link.Link} is the way in.
 */
package javino.link;
