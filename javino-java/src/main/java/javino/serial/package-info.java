/**
 * Opens serial devices, by the name that the operating system gives them and by their USB identity, through jSerialComm.
 *
 * <p>{@link javino.serial.SerialPorts} lists the devices and finds out why one cannot be opened.
 */
package javino.serial;
