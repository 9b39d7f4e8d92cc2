/**
 * The computer's side of version 2 of the Javino protocol, specified in docs/protocol.md: a state machine without threads and clocks.
 *
 * <p>{@link javino.session.ComputerSession} takes arriving frames and the time, and returns the next frame to write. The session reports
 * outcomes and percepts to a {@link javino.session.SessionListener}. Times are nanoseconds of one clock.
 */
package javino.session;
