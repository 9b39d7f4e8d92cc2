/** Opens connections to boards in a network and to serial servers: the ports {@code tcp://HOST:PORT}. */
package javino.tcp;
