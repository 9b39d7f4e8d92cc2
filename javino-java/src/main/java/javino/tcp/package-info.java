/**
 * Opens connections to boards in a network and to serial servers: the ports {@code tcp://HOST:PORT}, and {@code tls://HOST:PORT} with
 * certificates at both ends.
 */
package javino.tcp;
