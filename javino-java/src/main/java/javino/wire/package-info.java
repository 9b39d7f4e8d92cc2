/**
 * The bytes of version 2 of the Javino protocol, specified in docs/protocol.md: frames, commands, percepts, vocabulary and rules.
 *
 * <p>The code consists of pure functions and small state machines without threads or clocks. Callers pass times in. Payloads and texts
 * are strings with one character a byte (ISO-8859-1).
 */
package javino.wire;
