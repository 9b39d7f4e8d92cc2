/**
 * Opens connections to boards in a network and to serial servers: the ports {@code tcp://HOST:PORT}, and {@code
 * tls://HOST:PORT} with certificates of both ends.
 */
package javino.tcp;
