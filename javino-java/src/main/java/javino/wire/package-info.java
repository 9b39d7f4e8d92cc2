/**
 * The bytes of version 2 of the Javino protocol, as docs/protocol.md specifies them: frames, commands, percepts, vocabulary and rules.
 *
 * <p>Pure functions and small state machines without threads or clocks: times are passed in. Payloads and texts are strings of one
 * character a byte (ISO-8859-1).
 */
package javino.wire;
