/** Connects to boards and serial servers on a network: the ports {@code tcp://HOST:PORT} and {@code tls://HOST:PORT}. */
package javino.tcp;
