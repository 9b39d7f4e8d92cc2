/**
 * The computer's side of version 2 of the Javino protocol, as docs/protocol.md specifies it: a state machine without threads and clocks.
 *
 * <p>{@link javino.session.ComputerSession} is given the frames that come and the time, and says which frame is to be written next. It
 * reports outcomes and percepts to a {@link javino.session.SessionListener}. Times are nanoseconds of any one clock.
 */
package javino.session;
